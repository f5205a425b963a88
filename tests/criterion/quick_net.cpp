// The quick net: its signs are those of exact rational arithmetic, and a criterion's quick status is that of
// its full check. Inputs near the bound: doubles that are collinear or parallel up to the last bits, far from
// the origin, very small and very large; in all rounding modes.
#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/criterion/criterion.hpp"
#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/element/lagrange.hpp"
#include "number/double_oracle.hpp"
#include "random_element.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <numeric>

using namespace bezcert;
using namespace bezcert::test;

namespace {

struct Triangle {
  Shape shape;
  Basis basis = Basis::bernstein;
  std::vector<double> x, y;
  std::vector<std::uint32_t> nodes;

  Element element() const { return Element(shape, basis, {ExactVector(x), ExactVector(y)}); }
};

double nudged(Random& random, double value) {
  if (random.chance(60)) return value;
  const bool up = random.chance(50);
  for (long k = random.integer(1, 3); k > 0; --k) value = std::nextafter(value, up ? 1e300 : -1e300);
  return value;
}

// The corners and what lies between them evenly, moved by nothing, by last bits, by a little or by much.
Triangle random_triangle(Random& random, int max_degree) {
  const int n = static_cast<int>(random.integer(1, max_degree));
  Triangle result;
  result.shape = Shape::triangle(n);
  if (random.chance(60)) result.basis = Basis::lagrange;
  const bool round = random.chance(30);  // small integers: exact zeros are frequent
  const auto coordinate = [&] {
    return round ? static_cast<double>(random.integer(-3, 3)) * n : random.any_double(-1, 1);
  };
  std::array<double, 6> corners{coordinate(), coordinate(), coordinate(),
                                coordinate(), coordinate(), coordinate()};
  if (random.chance(60)) {  // a good shape
    corners = {0, 0, 1.0 * n, 0, 0, 1.0 * n};
    if (!round) {
      for (double& c : corners) c += random.any_double(-3, -2);
    }
  }
  if (random.chance(20)) {  // flat, or nearly
    corners[4] = (corners[0] + corners[2]) / 2;
    corners[5] = (corners[1] + corners[3]) / 2;
  }
  const double shift = random.chance(30) ? random.any_double(0, 20) : 0;
  const int exponent = random.chance(20) ? static_cast<int>(random.integer(-350, 350)) : 0;
  const std::array<double, 4> sizes = {0, 0, 0.1, 1};
  const double size = sizes[static_cast<std::size_t>(random.integer(0, 3))];
  const bool last_bits = random.chance(50);
  for (int r = 0; r <= n; ++r) {
    for (int c = 0; c <= n - r; ++c) {
      const double v = static_cast<double>(r) / n, u = static_cast<double>(c) / n, w = 1 - u - v;
      for (const int k : {0, 1}) {
        const auto i = static_cast<std::size_t>(k);
        double value = w * corners[i] + u * corners[i + 2] + v * corners[i + 4] + shift;
        if (size > 0)
          value += size * (round ? static_cast<double>(random.integer(-2, 2)) : random.any_double(-2, 0));
        if (last_bits) value = nudged(random, value);
        (k == 0 ? result.x : result.y).push_back(std::ldexp(value, exponent));
      }
    }
  }
  result.nodes.resize(result.x.size());
  std::iota(result.nodes.begin(), result.nodes.end(), 0U);
  return result;
}

// Control points by rational arithmetic alone.
std::vector<Rational> control_points(const Triangle& t, const std::vector<double>& numbers) {
  std::vector<Rational> nodes;
  for (const double number : numbers) nodes.emplace_back(number);
  if (t.basis == Basis::bernstein) return nodes;
  std::vector<Rational> result;
  for (const auto& row : lagrange_to_bernstein(t.shape).rows) {
    Rational sum = 0;
    for (const auto& entry : row) sum += Rational(entry.exact) * nodes[entry.column];
    result.push_back(sum);
  }
  return result;
}

void attack_signs(std::uint64_t seed, int triangles) {
  Random random(seed);
  std::map<int, int> turns, forwards;
  int used = 0, near = 0;
  QuickNet net;
  for (int i = 0; i < triangles; ++i) {
    const Triangle t = random_triangle(random, 6);
    const RoundingMode mode(rounding_modes[i % 4]);
    if (!net.load(t.shape, t.basis, t.x, t.y, t.nodes)) continue;
    ++used;
    const std::vector<Rational> x = control_points(t, t.x), y = control_points(t, t.y);
    INFO("seed " << seed << " case " << i);
    for (int k = 0; k < 25; ++k) {
      std::array<std::size_t, 4> p{};
      for (std::size_t& one : p)
        one = static_cast<std::size_t>(random.integer(0, static_cast<long>(x.size()) - 1));
      const Rational ax = x[p[1]] - x[p[0]], ay = y[p[1]] - y[p[0]], bx = x[p[3]] - x[p[2]],
                     by = y[p[3]] - y[p[2]];
      const Rational turn = ax * by - ay * bx, forward = ax * bx + ay * by;
      REQUIRE(net.turn(p[0], p[1], p[2], p[3]) == turn.sign());
      REQUIRE(net.forward(p[0], p[1], p[2], p[3]) == forward.sign());
      ++turns[turn.sign()];
      ++forwards[forward.sign()];
      // Not 0, but below what doubles resolve.
      const Rational size = abs(ax * by) + abs(ay * bx);
      if (!turn.is_zero() && abs(turn) * (Integer(1) << 45) < size) ++near;
    }
  }
  INFO("seed " << seed << ": used " << used << ", near " << near);
  CHECK(used > triangles / 8 * 7);
  for (const int sign : {-1, 0, 1}) {
    CHECK(turns[sign] > triangles / 2);
    CHECK(forwards[sign] > triangles / 2);
  }
  CHECK(near > triangles / 8);
}

}  // namespace

// 25 signs of each kind a triangle.
TEST_CASE("signs of the quick net are exact: 200,000 cases") { attack_signs(seed_or(501), 9000); }

TEST_CASE("signs of the quick net are exact: 10 million cases", "[.nightly]") {
  attack_signs(seed_or(503), 450000);
}

TEST_CASE("a quick status is the status of the check") {
  const std::uint64_t seed = seed_or(502);
  Random random(seed);
  std::map<std::string, std::map<Status, int>> seen;
  QuickNet net;
  for (int i = 0; i < 3000; ++i) {
    const Triangle t = random_triangle(random, 5);
    if (!net.load(t.shape, t.basis, t.x, t.y, t.nodes)) continue;
    const Element element = t.element();
    const Forms forms(element);
    INFO("seed " << seed << " case " << i << " degree " << t.shape.degree(0));
    for (const Criterion& criterion : criteria()) {
      REQUIRE(criterion.quick != nullptr);
      const std::optional<Status> status = criterion.quick(net);
      if (!status) continue;
      INFO(criterion.name);
      REQUIRE(*status == criterion.check(forms).status);
      ++seen[std::string(criterion.name)][*status];
    }
  }
  INFO("seed " << seed);
  for (const Criterion& criterion : criteria()) {
    INFO(criterion.name);
    auto& statuses = seen[std::string(criterion.name)];
    CHECK(statuses[Status::proved] > 200);
    const bool signs = criterion.name == "coefficients" || criterion.name == "subdivision";
    CHECK(statuses[signs ? Status::refuted : Status::inconclusive] > 200);
  }
  CHECK(seen["coefficients"][Status::inconclusive] > 5);
}

// Affine triangles of a height of some last bits: det J is that height and what rounding made of it.
TEST_CASE("signs of N are exact where doubles tell them") {
  const std::uint64_t seed = seed_or(505);
  Random random(seed);
  std::map<bool, int> told, positive;
  QuickNet net;
  for (int i = 0; i < 6000; ++i) {
    const int n = static_cast<int>(random.integer(1, 4));
    Triangle t{Shape::triangle(n), random.chance(70) ? Basis::lagrange : Basis::bernstein, {}, {}, {}};
    const double slope = random.any_double(-1, 1), base = random.any_double(-1, 1),
                 lean = random.any_double(-1, 1);
    const double height =
        std::ldexp(static_cast<double>(random.integer(-8, 8)), -static_cast<int>(random.integer(40, 54)));
    for (int r = 0; r <= n; ++r) {
      for (int c = 0; c <= n - r; ++c) {
        const double u = static_cast<double>(c) / n, v = static_cast<double>(r) / n;
        t.x.push_back(base * u + lean * v);
        t.y.push_back(slope * t.x.back() + height * v);
      }
    }
    t.nodes.resize(t.x.size());
    std::iota(t.nodes.begin(), t.nodes.end(), 0U);
    const RoundingMode mode(rounding_modes[i % 4]);
    if (!net.load(t.shape, t.basis, t.x, t.y, t.nodes)) continue;
    const auto signs = net.numerator_signs();
    ++told[signs.has_value()];
    if (!signs) continue;
    const Element element = t.element();
    const Forms forms(element, Filter::off);
    const PieceSigns exact = JacobianTree(forms).signs(JacobianTree::root);
    INFO("seed " << seed << " case " << i << " degree " << n);
    REQUIRE(signs->none_negative == exact.none_negative);
    REQUIRE(signs->none_positive == exact.none_positive);
    REQUIRE(signs->corner == exact.corner);
    ++positive[signs->none_negative];
  }
  INFO("seed " << seed);
  CHECK(told[true] > 1000);
  CHECK(told[false] > 1000);
  CHECK(positive[true] > 300);
  CHECK(positive[false] > 300);
}

TEST_CASE("the quick net refuses what it is not for") {
  QuickNet net;
  const std::vector<double> zero(66, 0), wide = {1e-40, 1, 1e20, 0, 1, 2};
  std::vector<std::uint32_t> nodes(66);
  std::iota(nodes.begin(), nodes.end(), 0U);
  const std::span<const std::uint32_t> six(nodes.data(), 6);
  CHECK(!net.load(Shape::triangle(2), Basis::bernstein, zero, zero, six));  // no size
  CHECK(!net.load(Shape::triangle(2), Basis::bernstein, wide, wide, six));  // exponents
  CHECK(!net.load(Shape::square(1, 1), Basis::bernstein, wide, wide, {nodes.data(), 4}));
  CHECK(!net.load(Shape::triangle(11), Basis::bernstein, zero, zero, nodes));
}
