// Points of the plane whose coordinates are polynomials in one real algebraic number: evidence that others
// can check with divisions of polynomials alone.
//
// A common zero (u, v) of polynomials with rational coefficients lies in Q(x)^2 for x = u + k v and all but
// finitely many k (primitive element). A polynomial f vanishes there if and only if f(u(x), v(x)) is
// divisible by x's minimal polynomial; a sign holds there if the Bernstein coefficients over an interval
// around x have it. So nothing is believed of the search for x: what it finds is checked in this way.
#pragma once

#include "bezcert/algebra/zero_set.hpp"

#include <array>
#include <optional>
#include <vector>

namespace bezcert {

/// u = u(x) and v = v(x), coefficients of 1, x, x^2, ... without leading zeros, fewer than the degree of
/// `polynomial`. x is the only root of `polynomial`, which is irreducible of degree at least 2, in the open
/// interval (lower, upper), where it has opposite signs at the ends. If the point is rational, `polynomial`
/// is 0, u and v are constants, and lower = upper = 0.
struct AlgebraicPoint {
  Univariate polynomial;
  Rational lower, upper;
  std::vector<Rational> u, v;

  bool is_rational() const { return polynomial.is_zero(); }
};

/// The common zero of `vanishing` in the closed box that the intervals of `at` span: all of them vanish there
/// (checked). The zero is given as in zero_set.hpp: a coordinate that is not rational may lack its minimal
/// polynomial, but not both. If the box holds a curve of common zeros, any point of it in the box. Nothing if
/// none is found: there is no zero, or it takes a resultant of more than `budget_bits` (degree times bits of
/// a coefficient, as in decide/algebraic.hpp).
std::optional<AlgebraicPoint> algebraic_point(const std::vector<Bivariate>& vanishing, const PlanarPoint& at,
                                              std::size_t budget_bits = std::size_t{1} << 25);

/// f(u(x), v(x)) modulo the polynomial of x, coefficients of 1, x, ... without leading zeros: empty if and
/// only if f vanishes at the point.
std::vector<Rational> value_at(const Bivariate& f, const AlgebraicPoint& point);

/// A condition on constant + by_u u(x) + by_v v(x).
struct AffineCondition {
  enum class Asks {
    not_negative,     ///< divisible by the polynomial of x, or no Bernstein coefficient is negative
    one_strict_sign,  ///< all Bernstein coefficients are positive, or all are negative
  };
  Rational constant, by_u, by_v;
  Asks asks = Asks::not_negative;
};

/// Halves (lower, upper) until all conditions hold, with the Bernstein coefficients over [lower, upper] of
/// the polynomial's own degree (of the constant itself, if the point is rational). False if one does not hold
/// at x.
bool narrow(AlgebraicPoint& point, const std::vector<AffineCondition>& conditions);

}  // namespace bezcert
