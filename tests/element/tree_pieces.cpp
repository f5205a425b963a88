// jacobian_tree.hpp: pieces tile the domain, and their signs are those of the exact coefficients.
#include "element/replayed_tree.hpp"

#include "bezcert/element/forms.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// Position of a point of the domain in a piece: 1 inside, 0 on its boundary, -1 outside.
int position(const std::vector<Values>& corners, const Values& at) {
  const std::size_t u = corners.size() == 3 ? 1 : 0;
  int result = 1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Values& a = corners[k];
    const Values& b = corners[(k + 1) % corners.size()];
    const Rational side = (b[u] - a[u]) * (at[u + 1] - a[u + 1]) - (b[u + 1] - a[u + 1]) * (at[u] - a[u]);
    result = std::min(result, side.sign());
  }
  return result;
}

bool same_signs(const PieceSigns& a, const PieceSigns& b) {
  return a.none_negative == b.none_negative && a.none_positive == b.none_positive && a.corner == b.corner;
}

PieceSigns expected_signs(const Polynomial<Rational>& f) {
  PieceSigns result;
  result.none_negative =
      std::all_of(f.coefficients.begin(), f.coefficients.end(), [](auto& c) { return c >= 0; });
  result.none_positive =
      std::all_of(f.coefficients.begin(), f.coefficients.end(), [](auto& c) { return c <= 0; });
  const auto corners = corner_indices(f.shape);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    result.corner[k] = static_cast<signed char>(f.coefficients[corners[k]].sign());
  }
  return result;
}

}  // namespace

TEST_CASE("pieces of a subdivision have the corners of the replay and tile the domain") {
  const std::uint64_t seed = seed_or(331);
  Random random(seed);
  long points_inside = 0, deepest = 0;
  for (int i = 0; i < 12; ++i) {
    const Shape shape = i % 2 == 0 ? Shape::triangle(2) : Shape::square(1, 2);
    const ControlNet net = random_net(random, shape, Points::small_integers, Weights::none);
    const Element element = bernstein_element(net);
    const Forms forms(element);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    CHECK(tree.piece_count() == 1);
    CHECK(tree.corner_count() == (i % 2 == 0 ? 3 : 4));
    const Rational whole = doubled_area(replay[JacobianTree::root].corners);
    split_randomly(random, tree, replay, 40);
    INFO("seed " << seed << ", case " << i);
    for (std::size_t piece = 0; piece < replay.size(); ++piece) {
      if (tree.depth(piece) != replay[piece].depth) FAIL("depth of piece " << piece);
      for (std::size_t k = 0; k < tree.corner_count(); ++k) {
        if (tree.corner(piece, k).values() != replay[piece].corners[k]) {
          FAIL("corner " << k << " of piece " << piece << ": " << show(tree.corner(piece, k).values()));
        }
      }
      deepest = std::max(deepest, static_cast<long>(tree.depth(piece)));
    }
    Rational area = 0;
    for (const std::size_t leaf : replay.leaves()) {
      std::vector<Values> corners;
      for (std::size_t k = 0; k < tree.corner_count(); ++k) corners.push_back(tree.corner(leaf, k).values());
      const Rational piece_area = doubled_area(corners);
      CHECK(piece_area > 0);  // counter-clockwise
      CHECK(piece_area * powers(2, tree.depth(leaf)).back() == whole);
      area += piece_area;
    }
    CHECK(area == whole);
    for (int k = 0; k < 20; ++k) {
      const auto at = random_parameter(random, shape.domain, true);
      long inside = 0, touching = 0;
      for (const std::size_t leaf : replay.leaves()) {
        const int where = position(replay[leaf].corners, at);
        inside += where == 1;
        touching += where == 0;
      }
      if (inside > 1 || inside + touching == 0 || (inside == 1 && touching > 0)) FAIL("point " << show(at));
      points_inside += inside;
    }
  }
  CHECK(points_inside > 100);
  CHECK(deepest > 6);
}

TEST_CASE("newest vertex bisection makes at most four kinds of triangles up to similarity") {
  const ControlNet net = identity_net(Shape::triangle(1));
  const Element element = bernstein_element(net);
  const Forms forms(element);
  JacobianTree tree(forms);
  std::vector<JacobianTree::Piece> level{JacobianTree::root};
  std::set<std::vector<Rational>> kinds;
  for (int depth = 0; depth < 8; ++depth) {
    std::vector<JacobianTree::Piece> next;
    for (const auto piece : level) {
      const auto [first, second] = tree.split(piece);
      next.push_back(first);
      next.push_back(second);
    }
    level = next;
    for (const auto piece : level) {
      std::vector<Rational> sides;
      for (std::size_t k = 0; k < 3; ++k) {
        const Values a = tree.corner(piece, k).values();
        const Values b = tree.corner(piece, (k + 1) % 3).values();
        sides.push_back((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
      }
      std::sort(sides.begin(), sides.end());
      kinds.insert({sides[0] / sides[2], sides[1] / sides[2]});
    }
  }
  CHECK(level.size() == 256);
  CHECK(kinds.size() >= 2);
  CHECK(kinds.size() <= 4);
}

TEST_CASE("the replayed coefficients are N on the piece: they give det J at its parameters") {
  const std::uint64_t seed = seed_or(332);
  Random random(seed);
  long cases = 0;
  for (int i = 0; i < 60; ++i) {
    const ControlNet net = tree_net(random, 4, 3);
    const Element element = bernstein_element(net);
    const Forms forms(element);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    split_randomly(random, tree, replay, 12);
    const ExactNet exact = exact_net(element);
    for (const std::size_t leaf : replay.leaves()) {
      const auto local = random_parameter(random, net.shape.domain, true);
      const Values at = replay.in_domain(leaf, local);
      Rational w = 1;
      if (exact.net.rational()) w = explicit_value(weight_polynomial(exact.net), at);
      const Rational n = explicit_value(replay[leaf].numerator, local);
      const Rational factor = degree_factor(net.shape) * exact.scale * exact.scale /
                              Rational(numerator_multiple(replay[leaf].numerator.shape));
      if (factor * n != direct_determinant(net, at) * w * w * w) {
        INFO("seed " << seed << ", " << show(net));
        FAIL("piece " << leaf << " at " << show(at));
      }
      ++cases;
    }
  }
  CHECK(cases == 60 * 13);
}

TEST_CASE("signs of pieces are the exact signs of the coefficients, filter on and off") {
  const std::uint64_t seed = seed_or(333);
  Random random(seed);
  long positive = 0, negative = 0, mixed = 0, zero_corners = 0, all_zero = 0, nonnegative_with_zero = 0;
  long exact_with_filter = 0, filter_sufficed = 0;
  for (int i = 0; i < 500; ++i) {
    const ControlNet net = tree_net(random, 4, 3);
    const Element element = bernstein_element(net);
    const Forms on(element, Filter::on);
    const Forms off(element, Filter::off);
    JacobianTree tree_on(on);
    JacobianTree tree_off(off);
    ReplayedTree replay(net);
    INFO("seed " << seed << ", case " << i << ", " << show(net));
    for (int k = 0; k < 8; ++k) {
      const auto leaves = replay.leaves();
      const auto piece =
          leaves[static_cast<std::size_t>(random.integer(0, static_cast<long>(leaves.size()) - 1))];
      // Ask some pieces before their children, others not: forms are made on demand.
      if (random.chance(50)) {
        if (!same_signs(tree_on.signs(piece), expected_signs(replay[piece].numerator))) FAIL("before split");
      }
      split_both(tree_on, replay, piece);
      tree_off.split(piece);
    }
    for (std::size_t piece = 0; piece < replay.size(); ++piece) {
      const PieceSigns expected = expected_signs(replay[piece].numerator);
      const PieceSigns with_filter = tree_on.signs(piece);
      const PieceSigns without = tree_off.signs(piece);
      if (!same_signs(with_filter, expected)) FAIL("filter on, piece " << piece);
      if (!same_signs(without, expected)) FAIL("filter off, piece " << piece);
      const auto corners = static_cast<std::ptrdiff_t>(tree_on.corner_count());
      const auto corner_signs_are = [&](int sign) {
        return std::all_of(expected.corner.begin(), expected.corner.begin() + corners,
                           [sign](int s) { return s == sign; });
      };
      const bool proves_positive = expected.none_negative && corner_signs_are(1);
      const bool proves_negative = expected.none_positive && corner_signs_are(-1);
      if (tree_on.proves_positive(expected) != proves_positive) FAIL("proves_positive, piece " << piece);
      if (tree_on.proves_negative(expected) != proves_negative) FAIL("proves_negative, piece " << piece);
      positive += proves_positive;
      negative += proves_negative;
      mixed += !expected.none_negative && !expected.none_positive;
      all_zero += expected.none_negative && expected.none_positive;
      nonnegative_with_zero += expected.none_negative && !expected.none_positive && !proves_positive;
      zero_corners += std::count(expected.corner.begin(), expected.corner.begin() + corners, 0);
    }
    (on.went_exact() ? exact_with_filter : filter_sufficed) += 1;
  }
  CHECK(positive > 500);
  CHECK(negative > 200);
  CHECK(mixed > 500);
  CHECK(all_zero > 10);
  CHECK(nonnegative_with_zero > 20);
  CHECK(zero_corners > 100);
  CHECK(exact_with_filter > 30);
  CHECK(filter_sufficed > 100);
}

TEST_CASE("a corner's sign is the sign of det J at its parameter, and proofs hold at sampled parameters") {
  const std::uint64_t seed = seed_or(334);
  Random random(seed);
  long corners = 0, sampled_positive = 0, sampled_negative = 0;
  for (int i = 0; i < 120; ++i) {
    const ControlNet net = tree_net(random, 3, 2);
    const Element element = bernstein_element(net);
    const Forms forms(element);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    split_randomly(random, tree, replay, 10);
    INFO("seed " << seed << ", case " << i << ", " << show(net));
    for (std::size_t piece = 0; piece < tree.piece_count(); ++piece) {
      const PieceSigns signs = tree.signs(piece);
      for (std::size_t k = 0; k < tree.corner_count(); ++k) {
        if (direct_determinant(net, tree.corner(piece, k).values()).sign() != signs.corner[k])
          FAIL("piece " << piece);
        ++corners;
      }
      const bool up = tree.proves_positive(signs);
      const bool down = tree.proves_negative(signs);
      if (!up && !down) continue;
      const Values at = replay.in_domain(piece, random_parameter(random, net.shape.domain, true));
      if (direct_determinant(net, at).sign() != (up ? 1 : -1)) FAIL("det J at " << show(at));
      (up ? sampled_positive : sampled_negative) += 1;
    }
  }
  CHECK(corners > 120 * 21 * 3 - 1);
  CHECK(sampled_positive > 200);
  CHECK(sampled_negative > 50);
}

TEST_CASE("corners stay exact far down") {
  for (const Shape shape : {Shape::triangle(1), Shape::square(1, 1)}) {
    const ControlNet net = identity_net(shape);
    const Element element = bernstein_element(net);
    const Forms forms(element);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    std::size_t piece = JacobianTree::root;
    for (int depth = 0; depth < 150; ++depth) {
      split_both(tree, replay, piece);
      piece = replay.size() - (depth % 3 == 0 ? 1 : 2);
    }
    INFO(show(shape));
    CHECK(tree.depth(piece) == 150);
    for (std::size_t k = 0; k < tree.corner_count(); ++k)
      CHECK(tree.corner(piece, k).values() == replay[piece].corners[k]);
    CHECK(tree.proves_positive(tree.signs(piece)));
  }
}
