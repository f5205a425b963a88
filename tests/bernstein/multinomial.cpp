// multinomial.hpp and scale_table.hpp: factors of the basis, and products without division.
#include "bernstein/explicit_sum.hpp"

#include "bezcert/bernstein/multinomial.hpp"
#include "bezcert/bernstein/scale_table.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// degree! / m! of every coefficient: the value of the basis functions where all parameters count as 1.
std::vector<Integer> expected_multinomials(Shape shape) {
  std::vector<Integer> result;
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      result.push_back(shape.domain == Domain::triangle
                           ? Integer(factorial(shape.degree(0)) /
                                     (factorial(c) * factorial(r) * factorial(shape.degree(0) - r - c)))
                           : Integer(choose(shape.degree(0), c) * choose(shape.degree(1), r)));
    }
  }
  return result;
}

bool contains(const Interval& interval, const Integer& x) {
  return Rational(interval.inf()) <= Rational(x) && Rational(x) <= Rational(interval.sup());
}

}  // namespace

TEST_CASE("binomials: Pascal's triangle, and 0 outside it") {
  for (int n = 0; n <= 40; ++n) {
    for (int k = -2; k <= n + 2; ++k) {
      const Integer expected = k < 0 || k > n ? Integer(0) : choose(n, k);
      if (binomial(n, k) != expected) FAIL("C(" << n << ", " << k << ") = " << binomial(n, k));
    }
  }
  CHECK(binomial(200, 100) == choose(200, 100));
}

TEST_CASE("multinomials are degree! / m!, and sum to the number of words") {
  for (const Shape shape : all_shapes(9)) {
    const auto factors = multinomials(shape);
    INFO(show(shape));
    CHECK(factors == expected_multinomials(shape));
    Integer sum = 0;
    for (const Integer& factor : factors) sum += factor;
    Integer words = 1;
    for (int k = 0; k < shape.degree(0) + shape.degree(1); ++k)
      words *= shape.domain == Domain::triangle ? 3 : 2;
    CHECK(sum == words);
  }
}

TEST_CASE("scaled coefficients multiply by convolution") {
  const std::uint64_t seed = seed_or(231);
  Random random(seed);
  long cases = 0;
  for (const Domain domain : {Domain::segment, Domain::triangle, Domain::square}) {
    for (int i = 0; i < 60; ++i) {
      const auto shape = [&] {
        const int p = static_cast<int>(random.integer(0, 5));
        return Shape{domain, p, domain == Domain::square ? static_cast<int>(random.integer(0, 5)) : 0};
      };
      const Polynomial<Integer> f = random_integer_polynomial(random, shape());
      const Polynomial<Integer> g = random_integer_polynomial(random, shape());
      Polynomial<Integer> fs = f;
      Polynomial<Integer> gs = g;
      to_scaled(fs);
      to_scaled(gs);
      Polynomial<Integer> product = convolve(fs, gs);
      INFO("seed " << seed << ", " << show(f.shape) << " times " << show(g.shape));
      // Twice into one sum.
      Polynomial<Integer> sum = product;
      add_convolution(sum, fs, gs);
      for (std::size_t m = 0; m < sum.coefficients.size(); ++m) {
        if (sum.coefficients[m] != 2 * product.coefficients[m]) FAIL("add_convolution at " << m);
      }
      from_scaled(product);
      const Rational multiple(scale_table(product.shape).multiple);
      const auto at = random_parameter(random, domain);
      if (explicit_value(product, at) != multiple * explicit_value(f, at) * explicit_value(g, at)) {
        FAIL("at " << show(at));
      }
      ++cases;
    }
  }
  CHECK(cases == 180);
}

TEST_CASE("scale tables: the least common multiple, cofactors, and intervals that contain them") {
  std::vector<Shape> shapes = all_shapes(7);
  shapes.push_back(Shape::triangle(27));
  shapes.push_back(Shape::square(28, 28));
  for (const Shape shape : shapes) {
    const ScaleTable& table = scale_table(shape);
    const auto factors = expected_multinomials(shape);
    Integer multiple = 1;
    for (const Integer& factor : factors) multiple = lcm(multiple, factor);
    INFO(show(shape));
    CHECK(table.multiple == multiple);
    CHECK(table.multinomial == factors);
    REQUIRE(table.cofactor.size() == factors.size());
    REQUIRE(table.multinomial_interval.size() == factors.size());
    REQUIRE(table.cofactor_interval.size() == factors.size());
    for (std::size_t m = 0; m < factors.size(); ++m) {
      if (table.cofactor[m] * factors[m] != multiple) FAIL("cofactor " << m);
      if (!contains(table.multinomial_interval[m], factors[m])) FAIL("multinomial interval " << m);
      if (!contains(table.cofactor_interval[m], table.cofactor[m])) FAIL("cofactor interval " << m);
    }
    CHECK(&scale_table(shape) == &table);
  }
}

TEST_CASE("to_scaled and from_scaled multiply by the common multiple, in integers and intervals") {
  const std::uint64_t seed = seed_or(232);
  Random random(seed);
  const RoundUp up;
  for (const Shape shape : all_shapes(7)) {
    const Polynomial<Integer> f = random_integer_polynomial(random, shape);
    Polynomial<Integer> exact = f;
    Polynomial<Interval> intervals(shape);
    for (std::size_t m = 0; m < f.coefficients.size(); ++m)
      intervals.coefficients[m] = to_interval(f.coefficients[m]);
    to_scaled(exact);
    to_scaled(intervals);
    INFO("seed " << seed << ", " << show(shape));
    const auto factors = expected_multinomials(shape);
    for (std::size_t m = 0; m < factors.size(); ++m) {
      if (exact.coefficients[m] != f.coefficients[m] * factors[m]) FAIL("to_scaled at " << m);
      if (!contains(intervals.coefficients[m], exact.coefficients[m])) FAIL("interval to_scaled at " << m);
    }
    from_scaled(exact);
    from_scaled(intervals);
    for (std::size_t m = 0; m < factors.size(); ++m) {
      if (exact.coefficients[m] != f.coefficients[m] * scale_table(shape).multiple)
        FAIL("from_scaled at " << m);
      if (!contains(intervals.coefficients[m], exact.coefficients[m])) FAIL("interval from_scaled at " << m);
    }
  }
}

TEST_CASE("number_from_integer keeps the integer") {
  Integer large = 1;
  large <<= 70;
  large += 1;
  CHECK(number_from_integer<Rational>(large) == Rational(large));
  CHECK(number_from_integer<Integer>(large) == large);
  const Interval interval = number_from_integer<Interval>(large);
  CHECK(interval.inf() == 0x1p70);
  CHECK(interval.sup() == 0x1.0000000000001p70);
}
