// Integer polynomials in the power basis: what the rules need of them. All functions spend their work.
#pragma once

#include "text.hpp"

#include <array>

namespace verifier {

/// The size of the largest of c in limbs, at least 1; and what a product of numbers of a and b limbs costs.
std::size_t limbs(const std::vector<mpz_class>& c);
std::size_t product_work(std::size_t a, std::size_t b);

/// Coefficients of x^n, x^(n-1) y, ..., y^n: x + y is put for x.
void shear(std::vector<mpz_class>& c);
/// Values become their differences at the first.
void differences(std::vector<mpz_class>& c);
/// Coefficients of 1, y, y (y - 1) / 2!, ... become those of 1, x, x^2, ..., times degree!; y = unit x.
/// `degree` is at least that of c.
void newton_to_power(std::vector<mpz_class>& c, int degree, int unit);

/// {degree in u, degree in v, total degree}, 0 for f = 0.
std::array<int, 3> degrees(const Polynomial2& f);
/// Drops leading zeros.
void trim(Polynomial& f);
void trim(Polynomial2& f);
Polynomial operator*(const Polynomial& f, const Polynomial& g);
Polynomial2 operator*(const Polynomial2& f, const Polynomial2& g);
Polynomial2 operator-(Polynomial2 f, const Polynomial2& g);
Polynomial2 derivative(const Polynomial2& f, bool by_v);

/// f(u(x)) times (denominator of u)^degree; `degree` is at least f's.
Polynomial compose(const Polynomial& f, int degree, const RationalPolynomial& u);
/// A positive multiple of f(u(x), v(x)).
Polynomial compose(const Polynomial2& f, const RationalPolynomial& u, const RationalPolynomial& v);
/// f(x) times a positive number, f(x) itself if x is an integer.
mpz_class value(const Polynomial& f, const mpq_class& x);
/// The function that maps [0, 1] to [low, high].
RationalPolynomial onto(const mpq_class& low, const mpq_class& high);
/// Bernstein coefficients on [low, high] in the given degree (at least f's), each times a positive number.
std::vector<mpz_class> bernstein(const Polynomial& f, int degree, const mpq_class& low,
                                 const mpq_class& high);
/// f modulo m, which is not 0, times a number that is not 0.
Polynomial remainder(Polynomial f, const Polynomial& m);
/// Whether f = q m for a polynomial q over the rationals; false if m = 0.
bool divisible(const Polynomial& f, const Polynomial& m);
/// The determinant of the Sylvester matrix with respect to v of f and g, taken in the degrees n and m,
/// at least theirs, up to a positive factor.
Polynomial resultant(const Polynomial2& f, int n, const Polynomial2& g, int m);

}  // namespace verifier
