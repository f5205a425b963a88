// Real roots against polynomials whose roots are known, and Sturm's theorem.
#include "bezcert/algebra/real_root.hpp"
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Univariate chebyshev(int n) {
  Univariate a = poly({1}), b = poly({0, 1});
  for (int k = 0; k < n; ++k) {
    Univariate next = poly({0, 2}) * b - a;
    a = std::move(b);
    b = std::move(next);
  }
  return a;
}

// A root is exact, or alone in an open interval with opposite signs at its ends; roots ascend and do not
// overlap.
void check_isolation(const Univariate& f, const std::vector<RealRoot>& roots, const Rational& lower,
                     const Rational& upper) {
  const RationalPolynomial reference(f.coefficients);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const RealRoot& root = roots[i];
    REQUIRE(root.lower <= root.upper);
    REQUIRE(root.lower >= lower);
    REQUIRE(root.upper <= upper);
    if (root.is_rational()) {
      REQUIRE(reference(root.lower).is_zero());
    } else {
      REQUIRE(sign(reference(root.lower)) * sign(reference(root.upper)) < 0);
    }
    if (i > 0) {
      REQUIRE(roots[i - 1].upper <= root.lower);
      REQUIRE_FALSE((roots[i - 1].is_rational() && root.is_rational() && roots[i - 1].upper == root.lower));
    }
  }
}

}  // namespace

TEST_CASE("roots_in finds known rational roots, close pairs and the ends") {
  const std::uint64_t seed = seed_or(111);
  Random random(seed);
  int at_lower = 0, at_upper = 0, outside = 0, close = 0, exact_found = 0;
  for (int i = 0; i < 1500; ++i) {
    const Rational lower(random.integer(-4, 2), random.integer(1, 5));
    const Rational upper = lower + Rational(random.integer(1, 9), random.integer(1, 7));
    std::vector<Rational> all;
    const int number = static_cast<int>(random.integer(1, 6));
    for (int k = 0; k < number; ++k) {
      switch (random.integer(0, 5)) {
        case 0: all.push_back(lower); break;
        case 1: all.push_back(upper); break;
        case 2: all.push_back(lower + (upper - lower) * Rational(random.integer(0, 16), 16)); break;
        case 3:
          if (!all.empty()) {
            all.push_back(all.back() + power_of_two(-random.integer(1, 80)) * (random.chance(50) ? 1 : -1));
            break;
          }
          [[fallthrough]];
        default: all.push_back(Rational(random.integer(-40, 40), random.integer(1, 9)));
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    Univariate f = poly({random.chance(50) ? 1 : -3});
    for (const Rational& root : all) f = f * linear_factor(root);
    if (random.chance(50)) f = f * poly({3, 1, 1});  // no real root
    std::vector<Rational> expected;
    for (const Rational& root : all) {
      if (lower <= root && root <= upper) expected.push_back(root);
      if (root == lower) ++at_lower;
      if (root == upper) ++at_upper;
      if (root < lower || root > upper) ++outside;
    }
    for (std::size_t k = 1; k < expected.size(); ++k) {
      if (expected[k] - expected[k - 1] < power_of_two(-40)) ++close;
    }
    INFO("seed " << seed << " case " << i << " f " << to_string(f, "x") << " in [" << lower << ", " << upper
                 << "]");
    std::vector<RealRoot> roots = roots_in(f, lower, upper);
    REQUIRE(roots.size() == expected.size());
    check_isolation(f, roots, lower, upper);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      RealRoot& root = roots[k];
      REQUIRE(root.lower <= expected[k]);
      REQUIRE(expected[k] <= root.upper);
      // Refining keeps it, and no other root comes in.
      for (int step = 0; step < 5; ++step) {
        const Rational before = root.upper - root.lower;
        root.refine();
        REQUIRE(root.lower <= expected[k]);
        REQUIRE(expected[k] <= root.upper);
        REQUIRE((root.is_rational() || root.upper - root.lower == before / 2));
        if (!root.is_rational()) {
          REQUIRE(root.lower < expected[k]);
          REQUIRE(expected[k] < root.upper);
        }
      }
      root.refine_to(power_of_two(-100));
      REQUIRE(root.upper - root.lower <= power_of_two(-100));
      REQUIRE(root.lower <= expected[k]);
      REQUIRE(expected[k] <= root.upper);
      // The minimal polynomial is linear, so the value comes out exactly.
      const RealRoot exact = with_minimal_polynomial(roots[k]);
      REQUIRE(exact.is_rational());
      REQUIRE(exact.lower == expected[k]);
      REQUIRE(proportional(exact.polynomial, linear_factor(expected[k])));
      if (!root.is_rational()) ++exact_found;
    }
  }
  CHECK(at_lower > 200);
  CHECK(at_upper > 200);
  CHECK(outside > 500);
  CHECK(close > 100);
  CHECK(exact_found > 200);
}

TEST_CASE("roots_in counts as Sturm's theorem does") {
  const std::uint64_t seed = seed_or(112);
  Random random(seed);
  int none = 0, several = 0, irrational = 0;
  for (int i = 0; i < 1500; ++i) {
    const Univariate raw =
        random_univariate(random, static_cast<int>(random.integer(1, 9)), random.chance(50) ? 3 : 40);
    const Univariate f = square_free_part(raw);
    if (f.degree() < 1) continue;
    const Rational lower(random.integer(-3, 1), random.integer(1, 3)),
        upper = lower + Rational(random.integer(1, 6), 2);
    INFO("seed " << seed << " case " << i << " f " << to_string(f, "x") << " in [" << lower << ", " << upper
                 << "]");
    const std::vector<RealRoot> roots = roots_in(f, lower, upper);
    REQUIRE(static_cast<int>(roots.size()) ==
            count_roots(RationalPolynomial(raw.coefficients), lower, upper));
    check_isolation(f, roots, lower, upper);
    (roots.empty() ? none : several) += 1;
    for (const RealRoot& root : roots) irrational += root.is_rational() ? 0 : 1;
  }
  CHECK(none > 200);
  CHECK(several > 600);
  CHECK(irrational > 500);
}

TEST_CASE("Chebyshev, Wilkinson and Mignotte polynomials") {
  // T_n has the n roots cos((2k+1) pi / 2n) in (-1, 1).
  for (const int n : {1, 2, 5, 16, 31, 50}) {
    CAPTURE(n);
    std::vector<RealRoot> roots = roots_in(chebyshev(n), -1, 1);
    REQUIRE(roots.size() == static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
      roots[static_cast<std::size_t>(k)].refine_to(power_of_two(-45));
      const double value = -std::cos((2 * k + 1) * std::acos(-1.0) / (2 * n));
      CHECK(std::abs(roots[static_cast<std::size_t>(k)].lower.convert_to<double>() - value) < 1e-12);
    }
    CHECK(roots_in(chebyshev(n), 0, 1).size() == static_cast<std::size_t>((n + 1) / 2));
    CHECK(roots_in(chebyshev(n), 1, 2).empty());
  }
  // (x-1)(x-2)...(x-20), and with a coefficient changed by 2^-23 (Wilkinson): 10 real roots are left.
  Univariate wilkinson = poly({1});
  for (int k = 1; k <= 20; ++k) wilkinson = wilkinson * poly({-k, 1});
  const auto roots = roots_in(wilkinson, 1, 20);
  REQUIRE(roots.size() == 20);
  for (int k = 0; k < 20; ++k) {
    const RealRoot exact = with_minimal_polynomial(roots[static_cast<std::size_t>(k)]);
    CHECK(exact.lower == k + 1);
    CHECK(exact.is_rational());
  }
  Univariate changed = wilkinson;
  for (Integer& c : changed.coefficients) c <<= 23;
  changed.coefficients[19] -= 1;
  CHECK(roots_in(changed, 0, 100).size() == 10);
  // x^n - 2 (a x - 1)^2: two roots closer than 2 a^(-(n+2)/2) around 1/a.
  const int n = 12;
  const long a = 1000;
  std::vector<Integer> c(n + 1, 0);
  c[0] = -2;
  c[1] = 4 * a;
  c[2] = -2 * a * a;
  c[n] = 1;
  const Univariate mignotte(std::move(c));
  const auto pair = roots_in(mignotte, 0, 1);
  REQUIRE(pair.size() == 2);
  const Rational gap = 2 * power(Rational(1, a), (n + 2) / 2);
  for (RealRoot root : pair) {
    root.refine_to(gap / 100);
    CHECK(abs(root.lower - Rational(1, a)) < gap);
  }
}

TEST_CASE("roots_in of constants and at double ends") {
  CHECK(roots_in(poly({5}), 0, 1).empty());
  const auto ends = roots_in(poly({0, -1, 1}), 0, 1);
  REQUIRE(ends.size() == 2);
  CHECK((ends[0].lower == 0 && ends[0].upper == 0 && ends[1].lower == 1 && ends[1].upper == 1));
  // Roots 0, 1/2 and 1, and one irrational between each.
  const auto five =
      roots_in(product_of({poly({0, 1}), poly({-1, 2}), poly({-1, 1}), poly({1, -8, 8})}), 0, 1);
  REQUIRE(five.size() == 5);
  CHECK(five[2].lower == Rational(1, 2));
  CHECK(five[2].is_rational());
}

TEST_CASE("simplest_between has the smallest denominator") {
  const std::uint64_t seed = seed_or(113);
  Random random(seed);
  int single = 0, fractions = 0, negative = 0;
  for (int i = 0; i < 3000; ++i) {
    const Rational a(random.integer(-60, 60), random.integer(1, 40));
    const Rational b =
        random.chance(10) ? a : Rational(a + Rational(random.integer(1, 40), random.integer(1, 400)));
    INFO("seed " << seed << " case " << i << " [" << a << ", " << b << "]");
    const Rational found = simplest_between(a, b);
    REQUIRE(a <= found);
    REQUIRE(found <= b);
    Integer denominator_found = 1;
    for (;; denominator_found += 1) {  // an integer p with a q <= p <= b q
      const Rational q(denominator_found);
      if (Rational(floor(Rational(b * q))) >= a * q) break;
    }
    REQUIRE(Integer(denominator(found)) == denominator_found);
    if (a == b) ++single;
    if (denominator_found > 1) ++fractions;
    if (b < 0) ++negative;
  }
  CHECK(single > 200);
  CHECK(fractions > 1000);
  CHECK(negative > 800);
  CHECK(simplest_between(-1, 1) == 0);
}

TEST_CASE("with_minimal_polynomial picks the factor of the root") {
  // sqrt 2 and 1.41421356 lie in one interval of the product only after isolation.
  const Rational near(141421356, 100000000);
  const Univariate f = poly({-2, 0, 1}) * linear_factor(near) * poly({-3, 0, 0, 1});
  const auto roots = roots_in(f, 1, 2);
  REQUIRE(roots.size() == 3);
  const RealRoot rational = with_minimal_polynomial(roots[0]), root2 = with_minimal_polynomial(roots[1]),
                 cube = with_minimal_polynomial(roots[2]);
  CHECK(rational.is_rational());
  CHECK(rational.lower == near);
  CHECK(proportional(root2.polynomial, poly({-2, 0, 1})));
  CHECK_FALSE(root2.is_rational());
  CHECK(proportional(cube.polynomial, poly({-3, 0, 0, 1})));
  CHECK(proportional(with_minimal_polynomial({Univariate(), Rational(-3, 7), Rational(-3, 7)}).polynomial,
                     poly({3, 7})));
  CHECK(root_of_linear(poly({3, -7})) == Rational(3, 7));
}
