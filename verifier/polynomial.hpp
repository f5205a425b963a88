// Integer polynomials in the power basis: what the rules need of them.
#pragma once

#include "text.hpp"

#include <array>

namespace verifier {

/// Lines c[first], c[first + stride], ... (`count` of them), changed in place:
/// coefficients of x^(count-1), x^(count-2) y, ..., y^(count-1): x + y is put for x;
void shear(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count);
/// values become their differences at the first, which are the coefficients of 1, x, x(x-1)/2!, ...;
void differences(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count);
/// coefficients of 1, x, x(x-1), ... become those of 1, x, x^2, ...
void newton_to_power(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count);

/// The size of the largest of c in limbs, at least 1; and what a product of numbers of a and b limbs costs.
std::size_t limbs(const std::vector<mpz_class>& c);
std::size_t product_work(std::size_t a, std::size_t b);

/// {max degree in u, max degree in v, max total degree}, 0 for f = 0.
std::array<int, 3> degrees(const Polynomial2& f);
mpq_class value(const Polynomial& f, const mpq_class& x);
mpq_class value(const Polynomial2& f, const mpq_class& u, const mpq_class& v);
Polynomial operator*(const Polynomial& f, const Polynomial& g);
Polynomial2 operator*(const Polynomial2& f, const Polynomial2& g);
Polynomial2 operator-(const Polynomial2& f, const Polynomial2& g);
/// Drops leading zeros.
void trim(Polynomial& f);
void trim(Polynomial2& f);

/// f(low + (high - low) x) times a positive number that depends on the other arguments only; `degree` is at
/// least f's.
Polynomial substituted(const Polynomial& f, int degree, const mpq_class& low, const mpq_class& high);
/// Bernstein coefficients on [low, high] in the given degree (at least f's), each times a positive number.
std::vector<mpz_class> bernstein(const Polynomial& f, int degree, const mpq_class& low,
                                 const mpq_class& high);
/// Whether f = q m for a polynomial q over the rationals; false if m = 0.
bool divisible(const Polynomial& f, const Polynomial& m);
/// A positive multiple of f(u(x), v(x)), f itself if the denominators are 1.
Polynomial compose(const Polynomial2& f, const RationalPolynomial& u, const RationalPolynomial& v);
/// The determinant of the Sylvester matrix with respect to v of f and g, taken in the formal degrees n and m,
/// up to a nonzero constant.
Polynomial resultant(const Polynomial2& f, int n, const Polynomial2& g, int m);

}  // namespace verifier
