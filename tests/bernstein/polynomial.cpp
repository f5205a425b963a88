// polynomial.hpp over rationals: each operation against the definition of the Bernstein form.
#include "bernstein/power_basis.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// Whether a parameter lies outside the domain.
bool outside(Domain domain, const std::vector<Rational>& at) {
  return std::any_of(at.begin(), at.end(),
                     [domain](const Rational& x) { return x < 0 || (domain != Domain::triangle && x > 1); });
}

}  // namespace

TEST_CASE("the oracle: explicit sum and power basis agree, the basis sums to 1") {
  const std::uint64_t seed = seed_or(210);
  Random random(seed);
  for (const Shape shape : all_shapes(4)) {
    const Polynomial<Rational> f = random_polynomial(random, shape);
    const PowerForm g = power_form(f);
    for (int k = 0; k < 3; ++k) {
      const auto at = random_parameter(random, shape.domain);
      INFO("seed " << seed << ", " << show(shape) << " at " << show(at));
      Rational sum = 0;
      for (const Rational& b : basis_values(shape, at)) sum += b;
      CHECK(sum == 1);
      CHECK(value(g, shape.domain, at) == explicit_value(f, at));
    }
  }
}

TEST_CASE("evaluate is the explicit Bernstein sum, inside and outside the domain") {
  const std::uint64_t seed = seed_or(211);
  Random random(seed);
  long cases = 0, beyond = 0;
  for (const Shape shape : all_shapes(6)) {
    for (int k = 0; k < 12; ++k) {
      const Polynomial<Rational> f = random_polynomial(random, shape);
      const auto at = random_parameter(random, shape.domain, k % 3 == 0);
      if (evaluate(f, at) != explicit_value(f, at)) {
        INFO("seed " << seed << ", " << show(shape) << " at " << show(at) << ", coefficients "
                     << show(f.coefficients));
        FAIL("evaluate");
      }
      ++cases;
      beyond += outside(shape.domain, at);
    }
  }
  CHECK(cases == 12 * 63);
  CHECK(beyond > 300);
}

TEST_CASE("elevate raises the degree and keeps the values") {
  const std::uint64_t seed = seed_or(212);
  Random random(seed);
  long cases = 0;
  for (const Shape shape : all_shapes(6)) {
    for (int times = 0; times <= 3; ++times) {
      const Polynomial<Rational> f = random_polynomial(random, shape);
      const Polynomial<Rational> g = elevate(f, times);
      const Shape expected{shape.domain, shape.degree(0) + times,
                           shape.domain == Domain::square ? shape.degree(1) + times : 0};
      INFO("seed " << seed << ", " << show(shape) << ", " << times << " times");
      if (g.shape != expected || g.coefficients.size() != coefficient_count(expected))
        FAIL("shape " << show(g.shape));
      for (int k = 0; k < 4; ++k) {
        const auto at = random_parameter(random, shape.domain);
        if (explicit_value(g, at) != explicit_value(f, at)) FAIL("value at " << show(at));
        ++cases;
      }
    }
  }
  CHECK(cases == 63 * 4 * 4);
}

TEST_CASE("multiply gives the product of the values") {
  const std::uint64_t seed = seed_or(213);
  Random random(seed);
  long cases = 0;
  for (const Domain domain : {Domain::segment, Domain::triangle, Domain::square}) {
    for (int k = 0; k < 150; ++k) {
      const auto shape = [&] {
        const int p = static_cast<int>(random.integer(0, 6));
        return Shape{domain, p, domain == Domain::square ? static_cast<int>(random.integer(0, 6)) : 0};
      };
      const Polynomial<Rational> f = random_polynomial(random, shape());
      const Polynomial<Rational> g = random_polynomial(random, shape());
      const Polynomial<Rational> product = multiply(f, g);
      INFO("seed " << seed << ", " << show(f.shape) << " times " << show(g.shape));
      if (product.shape !=
          Shape{domain, f.shape.degree(0) + g.shape.degree(0), f.shape.degree(1) + g.shape.degree(1)})
        FAIL("shape");
      for (int i = 0; i < 3; ++i) {
        const auto at = random_parameter(random, domain);
        if (explicit_value(product, at) != explicit_value(f, at) * explicit_value(g, at))
          FAIL("at " << show(at));
        ++cases;
      }
    }
  }
  CHECK(cases == 3 * 150 * 3);
  const Polynomial<Rational> f(Shape::segment(1));
  const Polynomial<Rational> g(Shape::triangle(1));
  CHECK_THROWS_AS(multiply(f, g), std::invalid_argument);
}

TEST_CASE("differentiate is the derivative in the power basis") {
  const std::uint64_t seed = seed_or(214);
  Random random(seed);
  std::map<Domain, long> cases;
  for (const Shape shape : all_shapes(6)) {
    for (int direction = 0; direction < (shape.domain == Domain::segment ? 1 : 2); ++direction) {
      Shape expected = shape;
      expected = expected.raised(shape.domain == Domain::square ? direction : 0, -1);
      if (expected.degree(0) < 0 || expected.degree(1) < 0) continue;
      const Polynomial<Rational> f = random_polynomial(random, shape);
      const Polynomial<Rational> g = differentiate(f, direction);
      const PowerForm exact = derivative(power_form(f), direction);
      INFO("seed " << seed << ", " << show(shape) << ", direction " << direction);
      if (g.shape != expected) FAIL("shape " << show(g.shape));
      for (int k = 0; k < 4; ++k) {
        const auto at = random_parameter(random, shape.domain);
        if (explicit_value(g, at) != value(exact, shape.domain, at)) FAIL("at " << show(at));
        ++cases[shape.domain];
      }
    }
  }
  CHECK(cases[Domain::segment] == 6 * 4);
  CHECK(cases[Domain::triangle] == 6 * 2 * 4);
  CHECK(cases[Domain::square] == 6 * 7 * 2 * 4);
}

TEST_CASE("split gives both parts of a segment or square, in either direction, at any parameter") {
  const std::uint64_t seed = seed_or(215);
  Random random(seed);
  long cases[2] = {}, beyond = 0;
  for (const Shape shape : all_shapes(6)) {
    if (shape.domain == Domain::triangle) continue;
    for (int direction = 0; direction < (shape.domain == Domain::segment ? 1 : 2); ++direction) {
      for (int k = 0; k < 3; ++k) {
        const Polynomial<Rational> f = random_polynomial(random, shape);
        const Rational t = random_parameter(random, Domain::segment)[0];
        const auto [lower, upper] = split(f, t, direction);
        INFO("seed " << seed << ", " << show(shape) << ", direction " << direction << ", t = " << t);
        if (lower.shape != shape || upper.shape != shape) FAIL("shape");
        const auto at = random_parameter(random, shape.domain);
        auto in_lower = at;
        auto in_upper = at;
        const auto d = static_cast<std::size_t>(direction);
        in_lower[d] = t * at[d];
        in_upper[d] = t + (1 - t) * at[d];
        if (explicit_value(lower, at) != explicit_value(f, in_lower)) FAIL("lower part at " << show(at));
        if (explicit_value(upper, at) != explicit_value(f, in_upper)) FAIL("upper part at " << show(at));
        ++cases[direction];
        beyond += t < 0 || t > 1;
      }
    }
  }
  CHECK(cases[0] == 56 * 3);
  CHECK(cases[1] == 49 * 3);
  CHECK(beyond > 80);
}

TEST_CASE("split gives both parts of a triangle, at any parameter") {
  const std::uint64_t seed = seed_or(216);
  Random random(seed);
  long cases = 0, beyond = 0;
  for (int degree = 0; degree <= 6; ++degree) {
    for (int k = 0; k < 30; ++k) {
      const Shape shape = Shape::triangle(degree);
      const Polynomial<Rational> f = random_polynomial(random, shape);
      const Rational t = random_parameter(random, Domain::segment)[0];
      const auto [first, second] = split(f, t);
      const auto at = random_parameter(random, Domain::triangle);
      INFO("seed " << seed << ", degree " << degree << ", t = " << t << ", at " << show(at));
      // Corners (A, M, C) and (M, B, C) with M = (1-t) A + t B.
      const std::vector<Rational> in_first{at[0] + (1 - t) * at[1], t * at[1], at[2]};
      const std::vector<Rational> in_second{(1 - t) * at[0], t * at[0] + at[1], at[2]};
      if (explicit_value(first, at) != explicit_value(f, in_first)) FAIL("first part");
      if (explicit_value(second, at) != explicit_value(f, in_second)) FAIL("second part");
      ++cases;
      beyond += t < 0 || t > 1;
    }
  }
  CHECK(cases == 7 * 30);
  CHECK(beyond > 80);
}

TEST_CASE("range is the smallest and largest coefficient and contains every value on the domain") {
  const std::uint64_t seed = seed_or(217);
  Random random(seed);
  long cases = 0, attained = 0;
  for (const Shape shape : all_shapes(6)) {
    const Polynomial<Rational> f = random_polynomial(random, shape);
    const auto [low, high] = range(f);
    INFO("seed " << seed << ", " << show(shape) << ", range " << low << " to " << high);
    for (const Rational& c : f.coefficients) {
      if (c < low || c > high) FAIL("a coefficient outside");
    }
    if (std::find(f.coefficients.begin(), f.coefficients.end(), low) == f.coefficients.end()) FAIL("low");
    if (std::find(f.coefficients.begin(), f.coefficients.end(), high) == f.coefficients.end()) FAIL("high");
    for (int k = 0; k < 20; ++k) {
      const auto at = random_parameter(random, shape.domain, true);
      REQUIRE_FALSE(outside(shape.domain, at));
      const Rational x = explicit_value(f, at);
      if (x < low || x > high) FAIL("value " << x << " at " << show(at));
      attained += x == low || x == high;
      ++cases;
    }
  }
  CHECK(cases == 63 * 20);
  CHECK(attained > 20);
}
