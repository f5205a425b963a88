// jacobian_tree.hpp: bounds of det J contain it, do not depend on the filter, and are as tight as stated.
#include "element/replayed_tree.hpp"

#include "bezcert/element/forms.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

bool same(const DeterminantBounds& a, const DeterminantBounds& b) {
  return a.min_lower == b.min_lower && a.min_upper == b.min_upper && a.max_lower == b.max_lower &&
         a.max_upper == b.max_upper;
}

std::string show(const DeterminantBounds& b) {
  return "min in [" + to_string(to_rational(b.min_lower)) + ", " + to_string(to_rational(b.min_upper)) +
         "], max in [" + to_string(to_rational(b.max_lower)) + ", " + to_string(to_rational(b.max_upper)) +
         "]";
}

/// The smallest and largest det J at the corners of pieces, by the quotient rule.
std::pair<Rational, Rational> corner_extremes(const ControlNet& net, const ReplayedTree& replay,
                                              const std::vector<std::size_t>& pieces) {
  std::vector<Rational> values;
  for (const std::size_t piece : pieces) {
    for (const Values& corner : replay[piece].corners) values.push_back(direct_determinant(net, corner));
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

std::vector<std::size_t> random_subset(Random& random, const std::vector<std::size_t>& all) {
  std::vector<std::size_t> chosen;
  for (const std::size_t k : all) {
    if (random.chance(50)) chosen.push_back(k);
  }
  if (chosen.empty()) chosen.push_back(all.back());
  return chosen;
}

}  // namespace

TEST_CASE("bounds over pieces contain det J, filter on and off alike") {
  const std::uint64_t seed = seed_or(341);
  Random random(seed);
  long rational = 0, polynomial = 0, samples = 0, around_zero = 0, filter_sufficed = 0, exact_with_filter = 0;
  for (int i = 0; i < 300; ++i) {
    const ControlNet net = tree_net(random, 4, 3);
    const Element element = bernstein_element(net);
    const Forms on(element, Filter::on);
    const Forms off(element, Filter::off);
    JacobianTree tree_on(on);
    JacobianTree tree_off(off);
    ReplayedTree replay(net);
    for (int k = 0; k < 6; ++k) {
      const auto leaves = replay.leaves();
      const auto piece =
          leaves[static_cast<std::size_t>(random.integer(0, static_cast<long>(leaves.size()) - 1))];
      split_both(tree_on, replay, piece);
      tree_off.split(piece);
    }
    const auto pieces = random.chance(50) ? replay.leaves() : random_subset(random, replay.leaves());
    const int bits = random.chance(50) ? report_bits : static_cast<int>(random.integer(2, 40));
    const DeterminantBounds b = tree_on.bounds(pieces, bits);
    const DeterminantBounds exact = tree_off.bounds(pieces, bits);
    INFO("seed " << seed << ", case " << i << ", bits " << bits << ", " << test::show(net));
    INFO(show(b));
    if (!same(b, exact)) FAIL("without the filter " << show(exact));
    const Rational min_lower = to_rational(b.min_lower), min_upper = to_rational(b.min_upper);
    const Rational max_lower = to_rational(b.max_lower), max_upper = to_rational(b.max_upper);
    if (min_lower > min_upper || max_lower > max_upper) FAIL("order");
    const auto check = [&](const Values& at) {
      const Rational det = direct_determinant(net, at);
      if (det < min_lower || det > max_upper) FAIL("det J = " << det << " at " << test::show(at));
      ++samples;
    };
    for (const std::size_t piece : pieces) {
      for (const Values& corner : replay[piece].corners) check(corner);
      for (int k = 0; k < 2; ++k) {
        check(replay.in_domain(piece, random_parameter(random, net.shape.domain, true)));
      }
    }
    (really_rational(net) ? rational : polynomial) += 1;
    around_zero += min_lower < 0 && max_upper > 0;
    (on.went_exact() ? exact_with_filter : filter_sufficed) += 1;
  }
  CHECK(rational > 100);
  CHECK(polynomial > 80);
  CHECK(samples > 4000);
  CHECK(around_zero > 100);
  CHECK(filter_sufficed > 50);
  CHECK(exact_with_filter > 10);
}

TEST_CASE("the inner bounds are det J at the best corner, rounded outwards") {
  const std::uint64_t seed = seed_or(342);
  Random random(seed);
  long rational = 0;
  for (int i = 0; i < 200; ++i) {
    const ControlNet net = tree_net(random, 3, 2);
    const Element element = bernstein_element(net);
    const Forms forms(element, i % 2 == 0 ? Filter::on : Filter::off);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    split_randomly(random, tree, replay, 5);
    const auto pieces = random_subset(random, replay.leaves());
    const DeterminantBounds b = tree.bounds(pieces);
    const auto [low, high] = corner_extremes(net, replay, pieces);
    INFO("seed " << seed << ", case " << i << ", " << test::show(net));
    INFO(show(b) << ", corners from " << low << " to " << high);
    if (!(b.min_upper == round_up(low))) FAIL("min_upper");
    if (!(b.max_lower == round_down(high))) FAIL("max_lower");
    rational += really_rational(net);
  }
  CHECK(rational > 60);
}

TEST_CASE("the outer bounds of a polynomial element are its extreme coefficients, rounded outwards") {
  const std::uint64_t seed = seed_or(343);
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const auto shapes = element_shapes(4, 3);
    const Shape shape =
        shapes[static_cast<std::size_t>(random.integer(0, static_cast<long>(shapes.size()) - 1))];
    const ControlNet net = random_net(random, shape, random_points(random), Weights::none);
    const Element element = bernstein_element(net);
    const Forms forms(element, i % 2 == 0 ? Filter::on : Filter::off);
    JacobianTree tree(forms);
    ReplayedTree replay(net);
    split_randomly(random, tree, replay, 5);
    const auto pieces = random_subset(random, replay.leaves());
    const DeterminantBounds b = tree.bounds(pieces);
    const ExactNet exact = exact_net(element);
    const Rational factor = degree_factor(shape) * exact.scale * exact.scale /
                            Rational(numerator_multiple(numerator_shape(shape, false)));
    std::vector<Rational> all;
    for (const std::size_t piece : pieces) {
      for (const Rational& c : replay[piece].numerator.coefficients) all.push_back(factor * c);
    }
    const auto [low, high] = std::minmax_element(all.begin(), all.end());
    INFO("seed " << seed << ", case " << i << ", " << test::show(net));
    INFO(show(b) << ", coefficients from " << *low << " to " << *high);
    if (!(b.min_lower == round_down(*low))) FAIL("min_lower");
    if (!(b.max_upper == round_up(*high))) FAIL("max_upper");
  }
}

TEST_CASE("known extremes lie between the bounds: det J constant, and rational triangles of degree 1") {
  const std::uint64_t seed = seed_or(344);
  Random random(seed);
  long constant = 0, projective = 0, zero = 0;
  const JacobianTree::Piece root[] = {JacobianTree::root};
  for (int i = 0; i < 600; ++i) {
    const bool weighted = random.chance(50);
    const Shape shape = Shape::triangle(1);
    const ControlNet net =
        random_net(random, shape, random_points(random), weighted ? Weights::small_integers : Weights::none);
    const Element element = bernstein_element(net);
    const Forms forms(element, i % 2 == 0 ? Filter::on : Filter::off);
    JacobianTree tree(forms);
    const DeterminantBounds b = tree.bounds(root);
    INFO("seed " << seed << ", case " << i << ", " << test::show(net));
    INFO(show(b));
    // N is constant and W linear: det J = N / W^3 is extreme at corners.
    const ReplayedTree replay(net);
    const auto [low, high] = corner_extremes(net, replay, {0});
    if (to_rational(b.min_lower) > low || low > to_rational(b.min_upper)) FAIL("min det J = " << low);
    if (to_rational(b.max_lower) > high || high > to_rational(b.max_upper)) FAIL("max det J = " << high);
    if (really_rational(net)) {
      ++projective;
      continue;
    }
    if (low != high) FAIL("the oracle: det J is not constant");
    if (!(b.min_lower == round_down(low)) || !(b.max_upper == round_up(low))) FAIL("not the rounded det J");
    if (!(b.min_upper == round_up(low)) || !(b.max_lower == round_down(low))) FAIL("not the rounded det J");
    ++constant;
    zero += low == 0;
  }
  CHECK(constant > 200);
  CHECK(projective > 200);
  CHECK(zero > 5);
}

TEST_CASE("bounds close in under subdivision") {
  const std::uint64_t seed = seed_or(345);
  Random random(seed);
  long narrowed = 0;
  for (const Shape shape : element_shapes(3, 2)) {
    for (int i = 0; i < 10; ++i) {
      const Weights weights = i % 2 == 0 ? Weights::none : Weights::small_integers;
      const ControlNet net = random_net(random, shape, Points::near_identity, weights);
      const Element element = bernstein_element(net);
      const Forms forms(element);
      JacobianTree tree(forms);
      std::vector<JacobianTree::Piece> level{JacobianTree::root};
      const DeterminantBounds first = tree.bounds(level, 30);
      for (int depth = 0; depth < 8; ++depth) {
        std::vector<JacobianTree::Piece> next;
        for (const auto piece : level) {
          const auto [a, b] = tree.split(piece);
          next.insert(next.end(), {a, b});
        }
        level = next;
      }
      const DeterminantBounds last = tree.bounds(level, 30);
      const auto gap = [](const DeterminantBounds& b) {
        return Rational(to_rational(b.min_upper) - to_rational(b.min_lower) + to_rational(b.max_upper) -
                        to_rational(b.max_lower));
      };
      INFO("seed " << seed << ", " << test::show(net));
      INFO("first " << show(first) << ", last " << show(last));
      // Eight halvings: sides 1/16 as long. The error of coefficients is quadratic in the side, that of the
      // quotient by W^3, whose numerator and denominator are bounded apart, linear.
      const int factor = really_rational(net) ? 3 : 10;
      // 30 bits round by less than a millionth.
      const Rational size = abs(to_rational(last.max_upper)) + abs(to_rational(last.min_lower));
      if (gap(last) * factor > gap(first) + size / 1000000) FAIL("gap " << gap(last) << " of " << gap(first));
      narrowed += gap(last) < gap(first);
    }
  }
  CHECK(narrowed > 30);
}
