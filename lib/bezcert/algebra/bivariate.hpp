// Integer polynomials in two variables u and v, in the power basis, and their elimination.
#pragma once

#include "bezcert/algebra/univariate.hpp"
#include "bezcert/bernstein/polynomial.hpp"

#include <array>

namespace bezcert {

/// sum of by_v[k](u) v^k; the last one is not zero, the zero polynomial has none.
struct Bivariate {
  std::vector<Univariate> by_v;

  Bivariate() = default;
  /// Drops leading zeros.
  explicit Bivariate(std::vector<Univariate> coefficients);

  bool is_zero() const { return by_v.empty(); }
  /// -1 for the zero polynomial.
  int degree_v() const { return static_cast<int>(by_v.size()) - 1; }
  int degree_u() const;
};

/// The polynomial with these Bernstein coefficients on the triangle (u = xi_1, v = xi_2) or the square.
Bivariate to_power_basis(const Polynomial<Integer>& f);

Bivariate operator-(const Bivariate& f, const Bivariate& g);
Bivariate operator*(const Bivariate& f, const Bivariate& g);
Bivariate derivative_u(const Bivariate& f);
Bivariate derivative_v(const Bivariate& f);
/// f(v, u).
Bivariate swapped(const Bivariate& f);

/// A positive multiple of f(u, .) at a rational u.
Univariate at_u(const Bivariate& f, const Rational& u);
int sign_at(const Bivariate& f, const Rational& u, const Rational& v);
/// A strict sign that f takes inside the triangle u, v > 0, u + v < 1: on a grid finer than its degrees.
/// Precondition: f is not 0.
int some_sign(const Bivariate& f);

/// A positive multiple of t -> f(from + t (to - from)).
Univariate along(const Bivariate& f, const std::array<Rational, 2>& from, const std::array<Rational, 2>& to);

/// Irreducible factors over the rationals, of positive degree, primitive, with their multiplicities. The sign
/// of the constant factor is dropped. Precondition: f is not 0.
std::vector<std::pair<Bivariate, int>> irreducible_factors(const Bivariate& f);

/// The common divisor of the largest degree, up to a constant factor.
Bivariate gcd(const Bivariate& f, const Bivariate& g);
/// The quotient up to a constant factor. Precondition: g divides f over the rationals.
Bivariate quotient(const Bivariate& f, const Bivariate& g);

/// Bits of the longest coefficient, at least 1.
std::size_t longest_coefficient(const Bivariate& f);

/// A bound of the degree in u of resultant_v.
int resultant_degree_bound(const Bivariate& f, const Bivariate& g);

/// The resultant with respect to v, up to a constant factor: vanishes at u if f(u, .) and g(u, .) have a
/// common complex root (and where both leading coefficients vanish). It is A f + B g for some polynomials A,
/// B. Computed at enough integers u and interpolated. Precondition: neither is 0.
Univariate resultant_v(const Bivariate& f, const Bivariate& g);

}  // namespace bezcert
