// Integer polynomials in one variable, in the power basis.
//
// What the algebra of the decision needs of them: exact signs at rationals, common divisors, irreducible
// factors. FLINT does the arithmetic (univariate.cpp); this header does not show it.
#pragma once

#include "bezcert/number/rational.hpp"

#include <string>
#include <utility>
#include <vector>

namespace bezcert {

/// sum of coefficients[k] x^k. The last coefficient is not zero; the zero polynomial has none.
struct Univariate {
  std::vector<Integer> coefficients;

  Univariate() = default;
  /// Drops leading zeros.
  explicit Univariate(std::vector<Integer> c);

  /// -1 for the zero polynomial.
  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  bool is_zero() const { return coefficients.empty(); }
  const Integer& leading() const { return coefficients.back(); }

  bool operator==(const Univariate&) const = default;
};

/// The polynomial with the Bernstein coefficients `values` on [0, 1].
Univariate from_bernstein(const std::vector<Integer>& values);

/// A positive multiple of the polynomial whose coefficients are rationals.
Univariate from_rationals(const std::vector<Rational>& coefficients);

Rational value_at(const Univariate& f, const Rational& x);
int sign_at(const Univariate& f, const Rational& x);

Univariate operator+(const Univariate& f, const Univariate& g);
Univariate operator-(const Univariate& f, const Univariate& g);
Univariate operator*(const Univariate& f, const Univariate& g);
Univariate derivative(const Univariate& f);

/// The common divisor of the largest degree: primitive, with a positive leading coefficient; 0 if both are 0.
Univariate gcd(const Univariate& f, const Univariate& g);

/// The quotient. Precondition: g divides f over the integers.
Univariate exact_quotient(const Univariate& f, const Univariate& g);

/// The product of the different irreducible factors, primitive. Precondition: f is not 0.
Univariate square_free_part(const Univariate& f);

/// Primitive irreducible factors of positive degree with their multiplicities. Precondition: f is not 0.
std::vector<std::pair<Univariate, int>> irreducible_factors(const Univariate& f);

/// "3*u^2 - 1".
std::string to_string(const Univariate& f, const std::string& variable);

}  // namespace bezcert
