// Integer polynomials in one variable against schoolbook arithmetic and products of known factors.
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// Irreducible over the rationals: by Eisenstein's criterion (2, 3 or 5), or quadratic without a rational
// root.
const std::vector<Univariate>& known_irreducibles() {
  static const std::vector<Univariate> list = {poly({-1, 3}),
                                               poly({2, 5}),
                                               poly({0, 1}),
                                               poly({-2, 0, 1}),
                                               poly({1, 0, 1}),
                                               poly({1, 1, 1}),
                                               poly({-2, 0, 0, 1}),
                                               poly({3, 6, 0, 9, 0, 1}),
                                               poly({-7, 0, 0, 0, 7, 2}),
                                               poly({10, 0, 15, 0, 5, 5, 3}),
                                               poly({1, 0, 0, 0, 1})};  // x^4 + 1: cyclotomic
  return list;
}

}  // namespace

TEST_CASE("arithmetic of univariate polynomials is the schoolbook's") {
  const std::uint64_t seed = seed_or(101);
  Random random(seed);
  int cancelled = 0;
  for (int i = 0; i < 2000; ++i) {
    Univariate f = random_univariate(random, static_cast<int>(random.integer(0, 8)), 9);
    Univariate g =
        random.chance(20) ? f : random_univariate(random, static_cast<int>(random.integer(0, 8)), 9);
    if (random.chance(10)) f = Univariate();
    const RationalPolynomial a(f.coefficients), b(g.coefficients);
    INFO("seed " << seed << " case " << i << " f " << to_string(f, "x") << " g " << to_string(g, "x"));
    REQUIRE(RationalPolynomial((f + g).coefficients) == a + b);
    REQUIRE(RationalPolynomial((f - g).coefficients) == a - b);
    REQUIRE(RationalPolynomial((f * g).coefficients) == a * b);
    REQUIRE(RationalPolynomial(derivative(f).coefficients) == slope(a));
    // No leading zeros are left.
    for (const Univariate& h : {f + g, f - g, f * g, derivative(f)})
      REQUIRE((h.is_zero() || !h.leading().is_zero()));
    if ((f - g).is_zero()) ++cancelled;
    const Rational x(random.integer(-50, 50), random.integer(1, 40));
    REQUIRE(value_at(f, x) == a(x));
    REQUIRE(sign_at(f, x) == sign(a(x)));
  }
  CHECK(cancelled > 100);
}

TEST_CASE("signs at roots and next to them") {
  // 10^40 x - 1 and (3x - 1)^2 - 10^-60: no double sees these signs.
  const Integer big = Integer(pow(Integer(10), 40));
  const Univariate f({Integer(-1), big});
  const Rational root(Integer(1), big), step = root / Rational(big);
  CHECK(sign_at(f, root) == 0);
  CHECK(sign_at(f, root + step) == 1);
  CHECK(sign_at(f, root - step) == -1);
  CHECK(sign_at(f, -root) == -1);
  const Integer tiny = Integer(pow(Integer(10), 60));
  const Univariate g({Integer(tiny - 1), Integer(-6 * tiny), Integer(9 * tiny)});
  const Rational third(1, 3), offset(Integer(1), Integer(3 * pow(Integer(10), 30)));
  CHECK(sign_at(g, third) == -1);
  CHECK(sign_at(g, third + offset) == 0);
  CHECK(sign_at(g, third - offset) == 0);
  CHECK(sign_at(g, third + 2 * offset) == 1);
  CHECK(sign_at(Univariate(), third) == 0);
  CHECK(sign_at(poly({-5}), third) == -1);
  CHECK(value_at(Univariate(), third) == 0);
}

TEST_CASE("from_bernstein has the values of the Bernstein form") {
  const std::uint64_t seed = seed_or(102);
  Random random(seed);
  int zero = 0;
  for (int i = 0; i < 1000; ++i) {
    const int degree = static_cast<int>(random.integer(0, 9));
    std::vector<Integer> values;
    const bool constant = random.chance(5);
    for (int k = 0; k <= degree; ++k) values.emplace_back(constant ? 0 : random.integer(-99, 99));
    const Univariate f = from_bernstein(values);
    const Rational t(random.integer(-20, 40), random.integer(1, 30));
    std::vector<Rational> row(values.begin(), values.end());
    for (int level = 0; level < degree; ++level) {
      for (int k = 0; k + level < degree; ++k) row[k] = (1 - t) * row[k] + t * row[k + 1];
    }
    INFO("seed " << seed << " case " << i << " f " << to_string(f, "x"));
    REQUIRE(value_at(f, t) == row[0]);
    REQUIRE(f.degree() <= degree);
    if (f.is_zero()) ++zero;
  }
  CHECK(zero > 20);
}

TEST_CASE("from_rationals is a positive multiple") {
  const Univariate f = from_rationals({Rational(-1, 6), 0, Rational(3, 4), 0});
  REQUIRE(f.degree() == 2);
  CHECK(f.leading() > 0);
  CHECK(f.coefficients[1] == 0);
  CHECK(Rational(f.coefficients[0], f.coefficients[2]) == Rational(-2, 9));
}

TEST_CASE("gcd, square-free part and factors of products of known irreducibles") {
  const std::uint64_t seed = seed_or(103);
  Random random(seed);
  const auto& primes = known_irreducibles();
  int coprime = 0, shared = 0, repeated = 0;
  for (int i = 0; i < 600; ++i) {
    // f and g: a constant (also negative) times powers of known factors.
    std::map<std::size_t, std::pair<int, int>> powers;
    for (int k = 0; k < 4; ++k) {
      auto& [a, b] =
          powers[static_cast<std::size_t>(random.integer(0, static_cast<long>(primes.size()) - 1))];
      a = static_cast<int>(random.integer(0, 3));
      b = static_cast<int>(random.integer(0, 2));
    }
    Univariate f = poly({random.chance(50) ? 6 : -4}), g = poly({random.chance(50) ? 10 : -3});
    Univariate divisor = poly({1}), radical = poly({1});
    std::map<std::size_t, int> expected;
    for (const auto& [which, exponents] : powers) {
      const auto [a, b] = exponents;
      for (int k = 0; k < a; ++k) f = f * primes[which];
      for (int k = 0; k < b; ++k) g = g * primes[which];
      for (int k = 0; k < std::min(a, b); ++k) divisor = divisor * primes[which];
      if (a > 0) {
        radical = radical * primes[which];
        expected[which] = a;
      }
      if (a > 1) ++repeated;
    }
    INFO("seed " << seed << " case " << i << " f " << to_string(f, "x") << " g " << to_string(g, "x"));
    // All known factors are primitive with a positive leading coefficient, so products are too (Gauss).
    REQUIRE(gcd(f, g) == divisor);
    REQUIRE(gcd(g, f) == divisor);
    (divisor.degree() > 0 ? shared : coprime) += 1;
    const Univariate part = square_free_part(f);
    REQUIRE((part == radical || part == Univariate() - radical));
    const auto factors = irreducible_factors(f);
    REQUIRE(factors.size() == expected.size());
    for (const auto& [which, exponent] : expected) {
      int found = 0;
      for (const auto& [factor, multiplicity] : factors) {
        if (factor == primes[which] || factor == Univariate() - primes[which]) found += multiplicity;
      }
      REQUIRE(found == exponent);
    }
    REQUIRE(exact_quotient(f * g, g) == f);
    REQUIRE(exact_quotient(f, f) == poly({1}));
  }
  CHECK(coprime > 50);
  CHECK(shared > 200);
  CHECK(repeated > 300);
}

TEST_CASE("gcd and quotient at their limits") {
  const Univariate f = poly({-4, 6}), zero;
  CHECK(gcd(zero, zero).is_zero());
  CHECK(gcd(f, zero) == poly({-2, 3}));
  CHECK(gcd(zero, poly({4, -6})) == poly({-2, 3}));
  CHECK(gcd(f, poly({7})) == poly({1}));
  CHECK(exact_quotient(zero, f).is_zero());
  CHECK_THROWS_AS(exact_quotient(poly({1, 1}), poly({0, 1})), std::logic_error);
  CHECK(square_free_part(poly({-6})).degree() == 0);
  CHECK(irreducible_factors(poly({-6})).empty());
  // Swinnerton-Dyer: x^4 - 10 x^2 + 1 splits modulo every prime, and is irreducible.
  CHECK(irreducible_factors(poly({1, 0, -10, 0, 1})).size() == 1);
}

TEST_CASE("to_string writes polynomials as people do") {
  CHECK(to_string(poly({-1, 0, 3}), "u") == "3*u^2 - 1");
  CHECK(to_string(poly({0, -1}), "v") == "-v");
  CHECK(to_string(poly({2, 1, -1}), "x") == "-x^2 + x + 2");
  CHECK(to_string(Univariate(), "x") == "0");
  CHECK(to_string(poly({-7}), "x") == "-7");
}
