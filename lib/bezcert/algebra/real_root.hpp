// Real roots of integer polynomials: isolated by Descartes' rule in the Bernstein basis, refined by
// bisection.
//
// The number of sign changes of the Bernstein coefficients over an interval bounds the number of roots in its
// interior and has the same parity (Descartes, Vincent); 0 changes: no root, 1 change: exactly one. For
// square-free polynomials halving ends (one- and two-circle theorems). Every root is either known exactly, as
// a rational, or alone in an open interval at whose ends the polynomial has opposite signs.
#pragma once

#include "bezcert/algebra/univariate.hpp"

namespace bezcert {

/// A real algebraic number: lower == upper is its value, or it is the only root of `polynomial` in the open
/// interval (lower, upper), and a simple one.
struct RealRoot {
  Univariate polynomial;
  Rational lower, upper;

  bool is_rational() const { return lower == upper; }
  /// Halves the interval.
  void refine();
  /// Halves until upper - lower <= width. Precondition: width > 0.
  void refine_to(const Rational& width);
};

/// A rational number, with its minimal polynomial.
RealRoot rational_root(const Rational& x);

/// Isolating intervals that are shown as evidence are at most this wide.
inline const Rational& shown_width() {
  static const Rational width(Integer(1), Integer(1) << 40);
  return width;
}

/// Positive multiples, by one common factor, of the Bernstein coefficients of f over [lower, upper] in f's
/// own degree. Preconditions: f is not 0, lower < upper.
std::vector<Integer> bernstein_over(const Univariate& f, const Rational& lower, const Rational& upper);

/// The number of sign changes in a sequence, zeros left out.
int sign_changes(const std::vector<Integer>& values);

/// The different roots in the closed interval [lower, upper], in ascending order; their intervals lie in
/// [lower, upper] and are disjoint except for common end points. Precondition: f is square-free (and not 0),
/// lower < upper.
std::vector<RealRoot> roots_in(const Univariate& f, const Rational& lower, const Rational& upper);

/// An open interval between neighbouring roots, and a rational number in it.
struct Gap {
  Rational lower, upper, sample;
};

/// The gaps between `lower`, the roots of f in [lower, upper] and `upper`, in ascending order; their ends are
/// moved inwards where a root is not rational. Preconditions: as roots_in, but f may be a constant.
std::vector<Gap> gaps_between_roots(const Univariate& f, const Rational& lower, const Rational& upper);

/// The fraction of the smallest denominator in [lower, upper]. Precondition: lower <= upper.
Rational simplest_between(const Rational& lower, const Rational& upper);

/// If an irreducible polynomial has degree 1, its root.
Rational root_of_linear(const Univariate& f);

/// The irreducible factor of `root.polynomial` that vanishes at the root, with the root's interval; exact if
/// that factor is linear.
RealRoot with_minimal_polynomial(RealRoot root);

}  // namespace bezcert
