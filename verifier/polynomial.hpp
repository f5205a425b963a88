// Polynomials with integer coefficients, in powers and in Bernstein form: what the rules need of them. All
// functions spend their work.
#pragma once

#include "text.hpp"

#include <array>

namespace verifier {

using Integers = std::vector<mpz_class>;

/// The size of the largest of c in limbs, at least 1; and what a product of numbers of a and b limbs costs.
std::size_t limbs(const Integers& c);
std::size_t product_work(std::size_t a, std::size_t b);

/// a / b in lowest terms.
mpq_class fraction(const mpz_class& a, const mpz_class& b);

/// How many points, or coefficients, a triangle of degree p = q or a quadrilateral of degrees p, q has.
inline std::size_t point_count(bool triangle, std::size_t p, std::size_t q) {
  return triangle ? (p + 1) * (p + 2) / 2 : (p + 1) * (q + 1);
}

/// Numbers in a table, in the order of a row or a column: steps may shrink by `less` each time.
struct Line {
  mpz_class* first;
  int size, step = 1, less = 0;
  mpz_class& operator[](int k) const { return first[k * step - k * (k - 1) / 2 * less]; }
};
inline Line line(Integers& c) { return {c.data(), static_cast<int>(c.size())}; }
/// Coefficients of x^n, x^(n-1) y, ..., y^n: x + y is put for x, or x - y.
void shear(Line c, bool minus = false);
/// Values become their differences at the first.
void differences(Line c);
/// Coefficients of 1, y, y (y - 1) / 2!, ... become those of 1, x, x^2, ..., times degree!; y = unit x.
/// `degree` is at least that of c.
void newton_to_power(Line c, int degree, int unit);

/// {degree in u, degree in v, total degree}, 0 for f = 0.
std::array<int, 3> degrees(const Polynomial2& f);
/// Drops leading zeros.
void trim(Polynomial& f);
void trim(Polynomial2& f);
Polynomial operator*(const Polynomial& f, const Polynomial& g);
Polynomial2 operator*(const Polynomial2& f, const Polynomial2& g);
Polynomial2 operator-(Polynomial2 f, const Polynomial2& g);
Polynomial2 derivative(const Polynomial2& f, bool by_v);
/// u and v exchange their roles.
Polynomial2 exchanged(const Polynomial2& f);

/// f on a piece of its domain, a triangle or a square, as a homogeneous polynomial in the piece's barycentric
/// coordinates (squares: those of u, and those of v). Coefficients, in the order of an element's points, are
/// Bernstein coefficients times multinomials.
struct Form {
  bool triangle;
  int p, q;  ///< p = q on triangles
  Integers c = Integers(point_count(triangle, p, q));

  /// The place of the coefficient with the exponents i of corner 1 (u) and j of corner 2 (v).
  int at(int i, int j) const { return triangle ? j * (2 * p + 3 - j) / 2 + i : j * (p + 1) + i; }
  /// Changes all lines of coefficients along u, or v.
  template <class Change>
  void lines(bool along_v, Change change) {
    for (int k = 0; k <= (along_v ? p : q); ++k) {
      const int size = (triangle ? p - k : along_v ? q : p) + 1;
      change(along_v ? Line{&c[k], size, p + 1, triangle} : Line{&c[at(0, k)], size});
    }
  }
};
/// On the whole domain. Rejected if the degrees are too low.
Form form(const Polynomial2& f, bool triangle, int p, int q);

/// A number as a polynomial, and the function that maps [0, 1] to [low, high].
RationalPolynomial constant(const mpq_class& x);
RationalPolynomial onto(const mpq_class& low, const mpq_class& high);
/// f(u(x)) times (denominator of u)^degree; `degree` is at least f's.
Polynomial compose(const Polynomial& f, int degree, const RationalPolynomial& u);
/// A positive multiple of f(u(x), v(x)).
Polynomial compose(const Polynomial2& f, const RationalPolynomial& u, const RationalPolynomial& v);
/// Bernstein coefficients on [low, high], times binomials and one positive number: in the degree that the
/// size of f says, trailing zeros allowed.
Integers bernstein(const Polynomial& f, const mpq_class& low, const mpq_class& high);
/// The sign of f at x.
int sign_at(const Polynomial& f, const mpq_class& x);
bool one_strict_sign(const Integers& c);

/// Whether f = q m for a polynomial q over the rationals; false if m = 0.
bool divisible(Polynomial f, const Polynomial& m);
/// The determinant of the Sylvester matrix with respect to v of f and g, taken in the degrees n and m,
/// at least theirs, up to a positive factor.
Polynomial resultant(const Polynomial2& f, int n, const Polynomial2& g, int m);

}  // namespace verifier
