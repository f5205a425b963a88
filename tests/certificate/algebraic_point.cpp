// Points with algebraic coordinates: the equations that define them are evaluated by schoolbook polynomials,
// and the coordinates are held against known decimals.
#include "bezcert/algebra/algebraic_point.hpp"
#include "algebra/polynomials.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// f modulo m.
RationalPolynomial reduced(RationalPolynomial f, const Univariate& m) {
  const RationalPolynomial divisor(m.coefficients);
  while (f.degree() >= divisor.degree()) {
    std::vector<Rational> factor(static_cast<std::size_t>(f.degree() - divisor.degree()) + 1, 0);
    factor.back() = -f.c.back() / divisor.c.back();
    const int degree = f.degree();
    f = f + RationalPolynomial(factor) * divisor;
    REQUIRE(f.degree() < degree);
  }
  return f;
}

RationalPolynomial composed(const Bivariate& f, const AlgebraicPoint& point) {
  const RationalPolynomial u(point.u), v(point.v);
  RationalPolynomial sum;
  for (std::size_t k = f.by_v.size(); k-- > 0;) {
    RationalPolynomial row;
    for (std::size_t i = f.by_v[k].coefficients.size(); i-- > 0;) {
      row = row * u + RationalPolynomial({Rational(f.by_v[k].coefficients[i])});
    }
    sum = sum * v + row;
  }
  return sum;
}

// A coordinate is unknown in [value - 2^-20, value + 2^-20].
RealRoot around(double value) {
  const Rational width(1, 1 << 20);
  return {Univariate(), exact(value) - width, exact(value) + width};
}

// The root of f (irreducible) near a value.
RealRoot root_near(const Univariate& f, double value) {
  return {f, around(value).lower, around(value).upper};
}

void check_point(const std::vector<Bivariate>& vanishing, const PlanarPoint& at, int degree, double u,
                 double v) {
  auto point = algebraic_point(vanishing, at);
  REQUIRE(point);
  REQUIRE(point->polynomial.degree() == degree);
  CHECK(sign_at(point->polynomial, point->lower) * sign_at(point->polynomial, point->upper) == -1);
  for (const Bivariate& f : vanishing) {
    CHECK(reduced(composed(f, *point), point->polynomial).is_zero());
    CHECK(value_at(f, *point).empty());
  }
  // Narrow until the coordinates are known to 1e-7, by conditions on them.
  const Rational e(1, 10000000);
  CHECK(narrow(*point,
               {{e - exact(u), 1, 0}, {e + exact(u), -1, 0}, {e - exact(v), 0, 1}, {e + exact(v), 0, -1}}));
  const RationalPolynomial x(point->u), y(point->v);
  for (const Rational& end : {point->lower, point->upper}) {
    CHECK(x(end).convert_to<double>() == Approx(u).margin(1e-6));
    CHECK(y(end).convert_to<double>() == Approx(v).margin(1e-6));
  }
}

}  // namespace

TEST_CASE("a point with one rational coordinate") {
  // 8 u^2 = 1, v = 1/3: the other coordinate is the number itself.
  const Bivariate f = poly2({poly({-1, 0, 8})}), g = line2(-1, 0, 3);
  check_point({f, g}, {root_near(poly({-1, 0, 8}), 0.3535533906), rational_root(Rational(1, 3))}, 2,
              0.3535533906, 1.0 / 3);
  check_point({f, g}, {around(0.3535533906), rational_root(Rational(1, 3))}, 2, 0.3535533906, 1.0 / 3);
  check_point({swapped(f), swapped(g)}, {rational_root(Rational(1, 3)), around(0.3535533906)}, 2, 1.0 / 3,
              0.3535533906);
  const auto rational =
      algebraic_point({line2(-1, 2, 0), g}, {rational_root(Rational(1, 2)), around(1.0 / 3)});
  REQUIRE(rational);
  CHECK(rational->is_rational());
  CHECK(rational->u == std::vector{Rational(1, 2)});
  CHECK(rational->v == std::vector{Rational(1, 3)});
}

TEST_CASE("a point with two irrational coordinates") {
  // sqrt(1/8) and sqrt(2/25): a field of degree 4, as sqrt(1/8) / sqrt(2/25) = 5/4 would be rational, so of
  // degree 2; with sqrt(3/25) it has degree 4.
  const Bivariate f = poly2({poly({-1, 0, 8})}), g = swapped(poly2({poly({-2, 0, 25})})),
                  h = swapped(poly2({poly({-3, 0, 25})}));
  const double u = 0.35355339059, v2 = 0.28284271247, v3 = 0.34641016151;
  check_point({f, g}, {root_near(poly({-1, 0, 8}), u), root_near(poly({-2, 0, 25}), v2)}, 2, u, v2);
  check_point({f, g}, {around(u), around(v2)}, 2, u, v2);
  check_point({f, h}, {root_near(poly({-1, 0, 8}), u), root_near(poly({-3, 0, 25}), v3)}, 4, u, v3);
  check_point({f, h}, {around(u), root_near(poly({-3, 0, 25}), v3)}, 4, u, v3);
  check_point({f, h}, {around(u), around(v3)}, 4, u, v3);
  // The sum of squares with its derivatives, a double zero.
  const Bivariate n = square(f) + square(h);
  check_point({n, derivative_u(n), derivative_v(n)}, {root_near(poly({-1, 0, 8}), u), around(v3)}, 4, u, v3);
  // Two conics: u^2 + v^2 = 1/4, 16 u v = 1; (u^2)^2 - u^2/4 + 1/256 = 0: u^2 = (2 + sqrt 3) / 16.
  const Bivariate conic = constant2(4) * (square(U) + square(V)) - constant2(1),
                  other = constant2(16) * U * V - constant2(1);
  check_point({conic, other}, {around(0.48296291314), around(0.12940952255)}, 4, 0.48296291314,
              0.12940952255);
}

TEST_CASE("points on the hypotenuse, on common curves, and none") {
  const double r = 0.35355339059;
  const Bivariate w = line2(1, -1, -1);
  const Bivariate f = w + square(poly2({poly({-1, 0, 8})}));
  check_point({f, w}, {root_near(poly({-1, 0, 8}), r), root_near(poly({7, -16, 8}), 1 - r)}, 2, r, 1 - r);
  // A common curve 8 u^2 = 2 v + 1 / 3 ... through the box: a rational column serves.
  const Bivariate curve = poly2({poly({-1, 0, 24}), poly({-6})});
  const auto point = algebraic_point({curve * line2(7, 1, 0), curve * line2(5, 0, 2)},
                                     {around(0.30), around((24 * 0.09 - 1) / 6)});
  REQUIRE(point);
  CHECK(value_at(curve, *point).empty());
  CHECK_FALSE(algebraic_point({f, line2(1, 3, 0)}, {around(0.3), around(0.4)}));
  CHECK_FALSE(algebraic_point({poly2({poly({-1, 0, 8})}), line2(-1, 0, 3)}, {around(0.36), around(1.0 / 3)}));
  // A diagonal that is a common factor away from the box does not matter.
  const Bivariate diagonal = line2(0, 1, -1);
  check_point({diagonal * poly2({poly({-1, 0, 8})}), diagonal * line2(-2, 0, 3)},
              {around(r), around(2.0 / 3)}, 2, r, 2.0 / 3);
}

TEST_CASE("conditions are shown by coefficients on the interval") {
  // x = sqrt(1/8) in (0, 1): u = x, v = 1 - x.
  AlgebraicPoint point{poly({-1, 0, 8}), 0, 1, {Rational(0), Rational(1)}, {Rational(1), Rational(-1)}};
  const auto asks = AffineCondition::Asks::one_strict_sign;
  CHECK(narrow(point, {{1, -1, -1}}));  // 0: divisible
  CHECK(point.lower == 0);
  CHECK_FALSE(narrow(point, {{1, -1, -1, asks}}));
  CHECK(narrow(point, {{0, 1, -1, asks}}));  // u - v < 0
  CHECK(point.upper <= Rational(1, 2));
  CHECK_FALSE(narrow(point, {{0, 1, -1}}));
  CHECK(narrow(point, {{Rational(-353553, 1000000), 1, 0}}));
  CHECK(point.lower >= Rational(353553, 1000000));
  CHECK(sign_at(poly({-1, 0, 8}), point.lower) < 0);
  CHECK(sign_at(poly({-1, 0, 8}), point.upper) > 0);
  AlgebraicPoint rational{Univariate(), 0, 0, {Rational(1, 2)}, {}};
  CHECK(narrow(rational, {{0, 1, 0}, {0, 0, 1}, {1, -1, -1, asks}}));
  CHECK_FALSE(narrow(rational, {{0, -1, 0}}));
}
