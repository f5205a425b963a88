// Greatest common divisors of polynomials over a number field Q(alpha), by primes.
//
// Let r be alpha's minimal polynomial, p a prime that divides neither r's leading coefficient nor its
// discriminant, and let the leading coefficient of f_1 be invertible modulo p and r. A monic divisor of f_1
// over Q(alpha) then has coefficients that are integral at p (Gauss), so the divisor modulo p has at least
// the degree of the true one: degree 0 proves that there is none. Otherwise the coefficients are found from
// several primes (Chinese remainders, rational reconstruction) and the candidate, of the smallest degree met,
// is divided into all f_i exactly: if it divides, it is the greatest. No fractions grow on the way, as they
// do in Euclid's algorithm.
#pragma once

#include "bezcert/algebra/bivariate.hpp"

namespace bezcert {

/// An element of Q(alpha): coefficients of 1, alpha, alpha^2, ..., fewer than the degree of r.
using FieldVector = std::vector<Rational>;

/// The monic greatest common divisor of the f_i(alpha, v), lowest coefficient first; {1} if there is none.
/// Empty if all vanish. Preconditions: r is irreducible of degree at least 2.
std::vector<FieldVector> field_gcd(const Univariate& r, const std::vector<Bivariate>& f);

}  // namespace bezcert
