// jacobian.hpp: det J = factor scale^2 N / W^3 with the numerator N of the stated degree, exactly.
#include "element/random_net.hpp"

#include "bezcert/bernstein/scale_table.hpp"
#include "bezcert/element/jacobian.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Rational cube(const Rational& x) { return x * x * x; }

bool contains(const Interval& interval, const Rational& x) {
  const double low = interval.inf();
  const double high = interval.sup();
  return std::isfinite(low) && std::isfinite(high) && Rational(low) <= x && x <= Rational(high);
}

/// The value that the numerator of an exact net gives det J.
Rational determinant_by_numerator(const ExactNet& exact, const Polynomial<Integer>& n, const Values& at) {
  const Rational multiple(numerator_multiple(n.shape));
  const Rational w = exact.net.rational() ? explicit_value(weight_polynomial(exact.net), at) : Rational(1);
  return degree_factor(exact.net.shape) * exact.scale * exact.scale * explicit_value(n, at) / multiple /
         cube(w);
}

/// Checks exact and interval forms of one element at some parameters; returns whether the intervals were
/// tight.
void check_element(const ControlNet& net, Random& random, int parameters) {
  const Element element = bernstein_element(net);
  REQUIRE(element.rational() == really_rational(net));
  const ExactNet exact = exact_net(element);
  const Polynomial<Integer> n = jacobian_numerator(exact.net);
  if (n.shape != numerator_shape(net.shape, element.rational())) FAIL("shape of N");
  if (exact.net.rational() != element.rational()) FAIL("weights of the net");
  std::vector<Values> inside;
  for (int k = 0; k < parameters; ++k) {
    const auto at = random_parameter(random, net.shape.domain, k % 2 == 0);
    if (k % 2 == 0) inside.push_back(at);
    if (!defined_at(net, at)) continue;
    const Rational expected = direct_determinant(net, at);
    INFO("at " << show(at) << ", det J = " << expected);
    if (determinant_by_numerator(exact, n, at) != expected) FAIL("N");
    const MapValue value = evaluate_map(exact, Parameter(net.shape.domain, at));
    if (value.determinant != expected) FAIL("evaluate_map");
    const auto [x, y] = point_at(net, at);
    if (value.place != Values{x, y}) FAIL("place");
  }
  const RoundUp up;
  const IntervalNet intervals = interval_net(up, element);
  const Polynomial<Interval> ni = jacobian_numerator(intervals.net);
  const Polynomial<Interval> wi = weight_polynomial(intervals.net);
  if (ni.shape != n.shape) FAIL("shape of the interval N");
  const Interval scale = intervals.scale * intervals.scale;
  for (const Values& at : inside) {
    std::vector<Interval> at_interval;
    for (const Rational& x : at) at_interval.push_back(to_interval(x));
    std::vector<Interval> for_weight = at_interval;
    const Interval w = evaluate(wi, for_weight);
    const Interval value = Interval(degree_factor(net.shape)) * scale * evaluate(ni, at_interval) /
                           (to_interval(numerator_multiple(ni.shape)) * w * w * w);
    if (!contains(value, direct_determinant(net, at))) FAIL("interval det J at " << show(at));
  }
  // Coefficient by coefficient: scale^2 C / W_0^3 is the same number in both forms.
  const Rational w0 = exact.net.rational() ? Rational(exact.net.weights[0]) : Rational(1);
  const Interval w0i = intervals.net.rational() ? intervals.net.weights[0] : Interval(1);
  for (std::size_t m = 0; m < n.coefficients.size(); ++m) {
    const Rational expected = exact.scale * exact.scale * Rational(n.coefficients[m]) / cube(w0);
    if (!contains(scale * ni.coefficients[m] / (w0i * w0i * w0i), expected))
      FAIL("interval coefficient " << m);
  }
}

}  // namespace

TEST_CASE("the oracle: the identity map has det J = 1, a stretched one its factor") {
  const std::uint64_t seed = seed_or(300);
  Random random(seed);
  for (const Shape shape : element_shapes(5, 4)) {
    const ControlNet net = identity_net(shape);
    ControlNet stretched = net;
    for (Rational& x : stretched.x) x = 3 * x + 7;
    for (Rational& y : stretched.y) y = -2 * y;
    const auto at = random_parameter(random, shape.domain);
    INFO("seed " << seed << ", " << show(shape) << " at " << show(at));
    CHECK(direct_determinant(net, at) == 1);
    CHECK(direct_determinant(stretched, at) == -6);
    const auto [x, y] = point_at(net, at);
    const std::size_t u = shape.domain == Domain::triangle ? 1 : 0;
    CHECK(x == at[u]);
    CHECK(y == at[u + 1]);
  }
  // Rational, of degree 1: weights (1, 2, 3) on the identity: det J = w0 w1 w2 / W^3.
  ControlNet projective = identity_net(Shape::triangle(1));
  projective.w = {1, 2, 3};
  const std::vector<Rational> at{Rational(1, 2), Rational(1, 3), Rational(1, 6)};
  CHECK(direct_determinant(projective, at) == 6 / cube(Rational(1, 2) + Rational(2, 3) + Rational(1, 2)));
}

TEST_CASE("N gives det J of triangles and quadrilaterals, polynomial and rational, exactly") {
  const std::uint64_t seed = seed_or(301);
  Random random(seed);
  long cases[2][2] = {};
  for (const Shape shape : element_shapes(5, 4)) {
    for (const Points points : all_points) {
      for (const Weights weights : all_weights) {
        const ControlNet net = random_net(random, shape, points, weights);
        INFO("seed " << seed << ", " << show(net));
        check_element(net, random, 4);
        ++cases[shape.domain == Domain::square][really_rational(net)];
      }
    }
  }
  CHECK(cases[0][0] >= 5 * 4 * 2);
  CHECK(cases[0][1] > 5 * 4 * 2);
  CHECK(cases[1][0] >= 16 * 4 * 2);
  CHECK(cases[1][1] > 16 * 4 * 2);
}

TEST_CASE("N gives det J at degree 10: a rational triangle and a polynomial quadrilateral") {
  const std::uint64_t seed = seed_or(302);
  Random random(seed);
  for (const Points points : {Points::near_identity, Points::doubles}) {
    const ControlNet triangle = random_net(random, Shape::triangle(10), points, Weights::doubles);
    REQUIRE(really_rational(triangle));
    INFO("seed " << seed);
    check_element(triangle, random, 4);
    check_element(random_net(random, Shape::square(10, 10), points, Weights::none), random, 4);
  }
}

TEST_CASE("the numerator has the stated shape, and the multiple is the least common one") {
  for (int n = 1; n <= 12; ++n) {
    const Shape triangle = Shape::triangle(n);
    CHECK(numerator_shape(triangle, false) == Shape::triangle(2 * (n - 1)));
    CHECK(numerator_shape(triangle, true) == Shape::triangle(3 * (n - 1)));
    CHECK(degree_factor(triangle) == n * n);
    for (int q = 1; q <= 12; ++q) {
      const Shape square = Shape::square(n, q);
      CHECK(numerator_shape(square, false) == Shape::square(2 * n - 1, 2 * q - 1));
      CHECK(numerator_shape(square, true) == Shape::square(3 * n - 2, 3 * q - 2));
      CHECK(degree_factor(square) == n * q);
    }
  }
  for (const Shape shape : element_shapes(6, 4)) {
    for (const bool rational : {false, true}) {
      const Shape n = numerator_shape(shape, rational);
      Integer multiple = 1;
      for (const auto& [r, c] : rows_and_columns(n)) {
        multiple = lcm(multiple, n.domain == Domain::triangle
                                     ? Integer(factorial(n.degree(0)) /
                                               (factorial(r) * factorial(c) * factorial(n.degree(0) - r - c)))
                                     : Integer(choose(n.degree(0), c) * choose(n.degree(1), r)));
      }
      CHECK(numerator_multiple(n) == multiple);
    }
  }
}

TEST_CASE("an element built to have det J = g has det J = g") {
  const std::uint64_t seed = seed_or(305);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const int p = static_cast<int>(random.integer(1, 4));
    const Shape shape =
        i % 2 == 0 ? Shape::triangle(p - 1) : Shape::square(p, static_cast<int>(random.integer(0, 3)));
    const Polynomial<Rational> g = random_polynomial(random, shape);
    const ControlNet net = net_with_determinant(g);
    const Element element = bernstein_element(net);
    const ExactNet exact = exact_net(element);
    const Polynomial<Integer> n = jacobian_numerator(exact.net);
    INFO("seed " << seed << ", " << show(net));
    for (int k = 0; k < 3; ++k) {
      const auto at = random_parameter(random, shape.domain);
      const Rational expected = explicit_value(g, at);
      if (direct_determinant(net, at) != expected) FAIL("the oracle at " << show(at));
      if (map_determinant(element, at) != expected) FAIL("evaluate_map at " << show(at));
      if (determinant_by_numerator(exact, n, at) != expected) FAIL("N at " << show(at));
    }
  }
}

TEST_CASE("equal weights, given or not, of any size, give the same det J") {
  const std::uint64_t seed = seed_or(303);
  Random random(seed);
  for (const Shape shape : element_shapes(4, 3)) {
    ControlNet net = random_net(random, shape, Points::fractions, Weights::none);
    const Element plain = bernstein_element(net);
    net.w.assign(net.x.size(), Rational(7, 3));
    const Element weighted = bernstein_element(net);
    INFO("seed " << seed << ", " << show(shape));
    CHECK_FALSE(weighted.rational());
    CHECK(jacobian_numerator(exact_net(plain).net).coefficients ==
          jacobian_numerator(exact_net(weighted).net).coefficients);
    const auto at = random_parameter(random, shape.domain);
    CHECK(map_determinant(plain, at) == map_determinant(weighted, at));
  }
}

TEST_CASE("interval numerators of very large and very small elements stay finite and contain det J") {
  const std::uint64_t seed = seed_or(304);
  Random random(seed);
  for (const int exponent : {-1000, -600, -200, 200, 600, 1000}) {
    for (const Shape shape : element_shapes(3, 2)) {
      ControlNet net = random_net(random, shape, Points::near_identity, Weights::small_integers);
      const Rational factor(std::ldexp(1.0, exponent));
      for (Rational& x : net.x) x *= factor;
      for (Rational& y : net.y) y *= factor;
      INFO("seed " << seed << ", times 2^" << exponent << ", " << show(net));
      const Element element = bernstein_element(net);
      const ExactNet exact = exact_net(element);
      const Polynomial<Integer> n = jacobian_numerator(exact.net);
      const RoundUp up;
      const IntervalNet intervals = interval_net(up, element);
      const Polynomial<Interval> ni = jacobian_numerator(intervals.net);
      long certain = 0;
      for (std::size_t m = 0; m < n.coefficients.size(); ++m) {
        const Interval c = ni.coefficients[m];
        if (!std::isfinite(c.inf()) || !std::isfinite(c.sup())) FAIL("coefficient " << m << " is not finite");
        const auto known = certain_sign(c);
        if (known && *known != sign(n.coefficients[m])) FAIL("sign of coefficient " << m);
        certain += known.has_value();
      }
      // The net itself is small integers times a power of two: nothing is rounded away.
      CHECK(certain == static_cast<long>(n.coefficients.size()));
      const auto at = random_parameter(random, shape.domain, true);
      CHECK(determinant_by_numerator(exact, n, at) == direct_determinant(net, at));
    }
  }
}

TEST_CASE("evaluate_map refuses a wrong number of parameters") {
  const Element triangle = bernstein_element(identity_net(Shape::triangle(2)));
  const Element square = bernstein_element(identity_net(Shape::square(2, 1)));
  for (const std::size_t count : {0, 1, 2, 4}) {
    CHECK_THROWS_AS(map_determinant(triangle, Values(count)), std::invalid_argument);
  }
  for (const std::size_t count : {0, 1, 3, 4}) {
    CHECK_THROWS_AS(map_determinant(square, Values(count)), std::invalid_argument);
  }
}
