// Short ways to write and make integer polynomials in tests of the algebra.
#pragma once

#include "bezcert/algebra/bivariate.hpp"
#include "random_input.hpp"
#include "rational_polynomial.hpp"

namespace bezcert::test {

inline Univariate poly(std::initializer_list<long> coefficients) {
  return Univariate(std::vector<Integer>(coefficients.begin(), coefficients.end()));
}

/// b x - a, with the root a / b.
inline Univariate linear_factor(const Rational& root) {
  return Univariate({Integer(-numerator(root)), Integer(denominator(root))});
}

inline Univariate product_of(const std::vector<Univariate>& factors) {
  Univariate result = poly({1});
  for (const Univariate& f : factors) result = result * f;
  return result;
}

inline Univariate random_univariate(Random& random, int degree, long size) {
  std::vector<Integer> c;
  for (int k = 0; k <= degree; ++k) c.emplace_back(random.integer(-size, size));
  while (c.back().is_zero()) c.back() = random.integer(-size, size);
  return Univariate(std::move(c));
}

/// Equal up to a constant factor.
inline bool proportional(const Univariate& f, const Univariate& g) {
  if (f.is_zero() || g.is_zero()) return f.is_zero() && g.is_zero();
  const RationalPolynomial a(f.coefficients), b(g.coefficients);
  return (Rational(1) / a.c.back()) * a == (Rational(1) / b.c.back()) * b;
}

// ---- two variables
// ------------------------------------------------------------------------------------------

/// Rows of coefficients: rows[k] belongs to v^k.
inline Bivariate poly2(std::initializer_list<Univariate> rows) {
  return Bivariate(std::vector<Univariate>(rows));
}
inline Bivariate constant2(long c) { return poly2({poly({c})}); }
inline const Bivariate U = poly2({poly({0, 1})});
inline const Bivariate V = poly2({Univariate(), poly({1})});

/// a + b u + c v.
inline Bivariate line2(long a, long b, long c) { return poly2({poly({a, b}), poly({c})}); }
inline Bivariate operator+(const Bivariate& f, const Bivariate& g) { return f - (constant2(-1) * g); }
inline Bivariate square(const Bivariate& f) { return f * f; }

inline Rational value_at(const Bivariate& f, const Rational& u, const Rational& v) {
  Rational sum = 0;
  for (std::size_t k = f.by_v.size(); k-- > 0;) sum = sum * v + RationalPolynomial(f.by_v[k].coefficients)(u);
  return sum;
}

inline bool equal(const Bivariate& f, const Bivariate& g) { return f.by_v == g.by_v; }

/// Equal up to a constant factor.
inline bool proportional(const Bivariate& f, const Bivariate& g) {
  if (f.is_zero() || g.is_zero()) return f.is_zero() && g.is_zero();
  const Univariate x({f.by_v.back().leading()}), y({g.by_v.back().leading()});
  return equal(poly2({y}) * f, poly2({x}) * g);
}

inline Bivariate random_bivariate(Random& random, int degree_u, int degree_v, long size) {
  std::vector<Univariate> rows;
  for (int k = 0; k <= degree_v; ++k) rows.push_back(random_univariate(random, degree_u, size));
  return Bivariate(std::move(rows));
}

}  // namespace bezcert::test
