// Other control points of one curve, against its value by powers of the parameter.
#include "bezcert/curve/curve_net.hpp"

#include "bezcert/curve/same_curve.hpp"
#include "power_form.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

Rational some_parameter(Random& random) { return random.rational(0, 1, random.integer(1, 30)); }

}  // namespace

TEST_CASE("parts, elevation, reversal and balance give the same points: 600 curves") {
  const std::uint64_t seed = seed_or(601);
  Random random(seed);
  for (int i = 0; i < 600; ++i) {
    INFO("seed " << seed << " case " << i);
    const int degree = 1 + i % 8;
    const CurveNet<Integer> net = random_curve(random, degree);
    const PowerForm curve = power_form(net);
    const Rational s = some_parameter(random), a = some_parameter(random), b = some_parameter(random);
    REQUIRE(point_at(net, s) == curve(s));
    REQUIRE(point_at(reversed(net), s) == curve(1 - s));
    REQUIRE(power_form(part_of(net, a, b))(s) == curve(a + (b - a) * s));

    const auto [before, after] = split(net, a);
    REQUIRE(power_form(before)(s) == curve(a * s));
    REQUIRE(power_form(after)(s) == curve(a + (1 - a) * s));

    const int higher = degree + static_cast<int>(random.integer(0, 4));
    const CurveNet<Integer> raised = elevated(net, higher);
    REQUIRE(raised.size() == static_cast<std::size_t>(higher) + 1);
    REQUIRE(power_form(raised)(s) == curve(s));
    REQUIRE(same_curve(raised, net));

    const long p = random.integer(1, 1000), q = random.integer(1, 1000);
    const CurveNet<Integer> changed = balanced(net, p, q);
    REQUIRE(power_form(changed)(s) == curve(p * s / (p * s + q * (1 - s))));
    REQUIRE(same_curve(changed, net));
  }
}

// Of degree 2 with weights 1 and 16 at the ends: the square roots are 1 and 4.
TEST_CASE("balance makes the weights of the ends equal") {
  const CurveNet<Integer> net{{0, 3, 32}, {0, 6, 0}, {1, 3, 16}};
  const CurveNet<Integer> even = balanced(net, 1, 4);
  CHECK(even.w == std::vector<Integer>{16, 12, 16});
  CHECK(even.x == std::vector<Integer>{0, 12, 32});
}

TEST_CASE("the weights tell whether a curve is polynomial") {
  CHECK(is_polynomial({{0, 1}, {0, 1}, {7, 7}}));
  CHECK_FALSE(is_polynomial({{0, 1}, {0, 1}, {7, 8}}));
}

}  // namespace bezcert::test
