// Integer polynomials in two variables against direct evaluation, Sylvester's determinant and products of
// known factors.
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Rational random_rational(Random& random) { return Rational(random.integer(-30, 30), random.integer(1, 20)); }

// Sylvester's determinant of f(u, .) and g(u, .) with the degrees in v of f and g, by elimination over the
// rationals.
Rational sylvester(const Bivariate& f, const Bivariate& g, const Rational& u) {
  const int m = f.degree_v(), n = g.degree_v();
  const auto size = static_cast<std::size_t>(m + n);
  std::vector<std::vector<Rational>> rows(size, std::vector<Rational>(size, 0));
  for (int shift = 0; shift < n; ++shift) {
    for (int k = 0; k <= m; ++k) rows[shift][shift + m - k] = RationalPolynomial(f.by_v[k].coefficients)(u);
  }
  for (int shift = 0; shift < m; ++shift) {
    for (int k = 0; k <= n; ++k)
      rows[n + shift][shift + n - k] = RationalPolynomial(g.by_v[k].coefficients)(u);
  }
  Rational determinant = 1;
  for (std::size_t c = 0; c < size; ++c) {
    std::size_t pivot = c;
    while (pivot < size && rows[pivot][c].is_zero()) ++pivot;
    if (pivot == size) return 0;
    if (pivot != c) {
      std::swap(rows[pivot], rows[c]);
      determinant = -determinant;
    }
    determinant *= rows[c][c];
    for (std::size_t r = c + 1; r < size; ++r) {
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < size; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  return determinant;
}

const std::vector<Bivariate>& known_irreducibles() {
  static const std::vector<Bivariate> list = {
      U,
      V,
      line2(1, -1, -1),
      poly2({poly({-2, 0, 1})}),                           // u^2 - 2
      poly2({poly({-3}), poly({}), poly({}), poly({1})}),  // v^3 - 3
      square(U) + square(V) - constant2(2),                // no line divides a smooth conic
      V - square(U) * U,                                   // a graph
      U * V - constant2(1),
      square(V) - U * square(U) - U - constant2(1),  // an elliptic curve
      square(V) * U - V -
          square(U) * square(U) * constant2(2)};  // linear discriminant argument: 1 + 8 u^5 is no square
  return list;
}

}  // namespace

TEST_CASE("to_power_basis has the values of the Bernstein form on triangles and squares") {
  const std::uint64_t seed = seed_or(121);
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    const bool triangle = random.chance(50);
    const int p = static_cast<int>(random.integer(0, 6)),
              q = triangle ? 0 : static_cast<int>(random.integer(0, 6));
    Polynomial<Integer> f(Shape{triangle ? Domain::triangle : Domain::square, p, q});
    for (Integer& c : f.coefficients) c = random.chance(20) ? 0 : random.integer(-50, 50);
    Polynomial<Rational> g(f.shape);
    for (std::size_t k = 0; k < f.coefficients.size(); ++k) g.coefficients[k] = Rational(f.coefficients[k]);
    const Bivariate powers = to_power_basis(f);
    INFO("seed " << seed << " case " << i << " degrees " << p << " " << q);
    for (int k = 0; k < 3; ++k) {
      const Rational u = random_rational(random), v = random_rational(random);
      const Rational expected = triangle ? evaluate(g, {Rational(1 - u - v), u, v}) : evaluate(g, {u, v});
      REQUIRE(value_at(powers, u, v) == expected);
      REQUIRE(sign_at(powers, u, v) == sign(expected));
    }
    REQUIRE((powers.is_zero() || !powers.by_v.back().is_zero()));
  }
}

TEST_CASE("arithmetic, derivatives, swapped, at_u and along agree with values") {
  const std::uint64_t seed = seed_or(122);
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    const auto some = [&] {
      return random_bivariate(random, static_cast<int>(random.integer(0, 4)),
                              static_cast<int>(random.integer(0, 4)), 9);
    };
    const Bivariate f = some(), g = some();
    const Rational u = random_rational(random), v = random_rational(random);
    INFO("seed " << seed << " case " << i << " at " << u << " " << v);
    REQUIRE(value_at(f - g, u, v) == value_at(f, u, v) - value_at(g, u, v));
    REQUIRE(value_at(f * g, u, v) == value_at(f, u, v) * value_at(g, u, v));
    REQUIRE(value_at(swapped(f), v, u) == value_at(f, u, v));
    REQUIRE(equal(swapped(swapped(f)), f));
    REQUIRE(swapped(f).degree_u() == f.degree_v());
    REQUIRE((f - f).is_zero());
    // The product rule, and the derivative of a linear form.
    REQUIRE(equal(derivative_u(f * g), derivative_u(f) * g + f * derivative_u(g)));
    REQUIRE(equal(derivative_v(f * g), derivative_v(f) * g + f * derivative_v(g)));
    // A positive multiple: the same factor at every v.
    const Univariate column = at_u(f, u);
    const Rational factor = power(Rational(denominator(u)), f.degree_u());
    for (const Rational& at : {v, Rational(v + 1), Rational(0)}) {
      REQUIRE(value_at(column, at) == factor * value_at(f, u, at));
    }
    const std::array<Rational, 2> from = {u, v}, to = {random_rational(random), random_rational(random)};
    const Univariate line = along(f, from, to);
    std::optional<Rational> ratio;
    for (int k = -3; k <= 4; ++k) {
      const Rational t(k, 2);
      const Rational expected = value_at(f, from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
      const Rational found = value_at(line, t);
      REQUIRE(sign(found) == sign(expected));
      if (expected.is_zero()) continue;
      if (ratio) REQUIRE(found / expected == *ratio);
      ratio = found / expected;
    }
  }
  CHECK(equal(derivative_u(line2(3, 5, 7)), constant2(5)));
  CHECK(equal(derivative_v(line2(3, 5, 7)), constant2(7)));
  CHECK(derivative_u(V).is_zero());
  CHECK(Bivariate().degree_u() == -1);
  CHECK(Bivariate().degree_v() == -1);
  // On an edge that the polynomial contains.
  CHECK(along(line2(1, -1, -1), {1, 0}, {0, 1}).is_zero());
}

TEST_CASE("the resultant of products of linear forms") {
  const std::uint64_t seed = seed_or(123);
  Random random(seed);
  int zero = 0;
  for (int i = 0; i < 500; ++i) {
    // f = product of (c v - a u - b): Res = product over pairs of the differences of the roots.
    struct Line {
      long a, b, c;
    };
    std::vector<Line> first, second;
    const auto fill = [&](std::vector<Line>& lines) {
      Bivariate f = constant2(random.chance(50) ? 2 : -3);
      for (int k = 0; k < static_cast<int>(random.integer(1, 4)); ++k) {
        lines.push_back({random.integer(-4, 4), random.integer(-4, 4), random.integer(1, 3)});
        f = f * line2(-lines.back().b, -lines.back().a, lines.back().c);
      }
      return f;
    };
    const Bivariate f = fill(first), g = fill(second);
    Univariate expected = poly({1});
    for (const Line& x : first) {
      for (const Line& y : second) expected = expected * poly({x.b * y.c - y.b * x.c, x.a * y.c - y.a * x.c});
    }
    const Univariate found = resultant_v(f, g);
    INFO("seed " << seed << " case " << i << " found " << to_string(found, "u") << " expected "
                 << to_string(expected, "u"));
    REQUIRE(proportional(found, expected));
    REQUIRE(found.degree() <= resultant_degree_bound(f, g));
    if (found.is_zero()) ++zero;
  }
  CHECK(zero > 5);
}

TEST_CASE(
    "the resultant is Sylvester's determinant, also where leading coefficients vanish at the points of "
    "interpolation") {
  const std::uint64_t seed = seed_or(124);
  Random random(seed);
  int leading_vanishes = 0, common = 0;
  for (int i = 0; i < 200; ++i) {
    Bivariate f = random_bivariate(random, static_cast<int>(random.integer(0, 3)),
                                   static_cast<int>(random.integer(1, 4)), 6);
    Bivariate g = random_bivariate(random, static_cast<int>(random.integer(0, 3)),
                                   static_cast<int>(random.integer(1, 4)), 6);
    if (random.chance(30)) {  // u (u - 1) (u + 1) (u - 2) as the leading coefficient
      f.by_v.back() = product_of({poly({0, 1}), poly({-1, 1}), poly({1, 1}), poly({-2, 1})});
      ++leading_vanishes;
    }
    if (random.chance(15)) {
      const Bivariate h = random_bivariate(random, 1, 1, 5);
      f = f * h;
      g = g * h;
      ++common;
    }
    const Univariate found = resultant_v(f, g);
    INFO("seed " << seed << " case " << i << " found " << to_string(found, "u"));
    std::optional<Rational> ratio;
    for (const Rational& u : {Rational(0), Rational(1), Rational(-1), Rational(2), Rational(7, 3),
                              Rational(-5, 4), Rational(11)}) {
      const Rational expected = sylvester(f, g, u), value = value_at(found, u);
      REQUIRE(value.is_zero() == expected.is_zero());
      if (value.is_zero()) continue;
      if (ratio) REQUIRE(value / expected == *ratio);
      ratio = value / expected;
    }
  }
  CHECK(leading_vanishes > 30);
  CHECK(common > 10);
  // One polynomial without v: its power. The discriminant of the circle.
  CHECK(proportional(resultant_v(poly2({poly({-1, 2})}), square(V) - U), poly({1, -4, 4})));
  const Bivariate circle = square(U) + square(V) - constant2(1);
  CHECK(proportional(resultant_v(circle, derivative_v(circle)), poly({-1, 0, 1})));
}

TEST_CASE("factors, gcd and quotient of products of known irreducibles") {
  const std::uint64_t seed = seed_or(125);
  Random random(seed);
  const auto& primes = known_irreducibles();
  int shared = 0, repeated = 0;
  for (int i = 0; i < 200; ++i) {
    std::map<std::size_t, std::pair<int, int>> powers;
    for (int k = 0; k < 3; ++k) {
      powers[static_cast<std::size_t>(random.integer(0, static_cast<long>(primes.size()) - 1))] = {
          static_cast<int>(random.integer(0, 3)), static_cast<int>(random.integer(0, 2))};
    }
    Bivariate f = constant2(random.chance(50) ? 6 : -10), g = constant2(15), divisor = constant2(1);
    std::map<std::size_t, int> expected;
    for (const auto& [which, exponents] : powers) {
      const auto [a, b] = exponents;
      for (int k = 0; k < a; ++k) f = f * primes[which];
      for (int k = 0; k < b; ++k) g = g * primes[which];
      for (int k = 0; k < std::min(a, b); ++k) divisor = divisor * primes[which];
      if (a > 0) expected[which] = a;
      if (a > 1) ++repeated;
    }
    INFO("seed " << seed << " case " << i);
    const auto factors = irreducible_factors(f);
    REQUIRE(factors.size() == expected.size());
    for (const auto& [which, exponent] : expected) {
      int found = 0;
      for (const auto& [factor, multiplicity] : factors) {
        if (proportional(factor, primes[which])) {
          found += multiplicity;
          REQUIRE(
              (equal(factor, primes[which]) || equal(constant2(-1) * factor, primes[which])));  // primitive
        }
      }
      REQUIRE(found == exponent);
    }
    REQUIRE(proportional(gcd(f, g), divisor));
    REQUIRE(proportional(quotient(f * g, g), f));
    if (divisor.degree_u() + divisor.degree_v() > 0) ++shared;
    // A fixed order.
    const auto again = irreducible_factors(constant2(-7) * f);
    REQUIRE(again.size() == factors.size());
    for (std::size_t k = 0; k < factors.size(); ++k) REQUIRE(equal(again[k].first, factors[k].first));
  }
  CHECK(shared > 20);
  CHECK(repeated > 100);
  CHECK_THROWS_AS(quotient(U, V), std::logic_error);
  CHECK(irreducible_factors(constant2(-6)).empty());
  // u^4 + 4 v^4 splits over the integers (Sophie Germain); u^2 + v^2 does not.
  const Bivariate u2 = square(U), v2 = square(V);
  CHECK(irreducible_factors(square(u2) + constant2(4) * square(v2)).size() == 2);
  CHECK(irreducible_factors(u2 + v2).size() == 1);
}
