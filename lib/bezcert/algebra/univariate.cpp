#include "bezcert/algebra/univariate.hpp"

#include "bezcert/algebra/flint_types.hpp"
#include "bezcert/bernstein/multinomial.hpp"
#include "bezcert/number/scaled.hpp"

#include <flint/fmpz_poly_factor.h>

namespace bezcert {

Univariate::Univariate(std::vector<Integer> c) : coefficients(std::move(c)) {
  while (!coefficients.empty() && coefficients.back().is_zero()) coefficients.pop_back();
}

Univariate from_bernstein(const std::vector<Integer>& values) {
  // sum c_i C(n,i) t^i (1-t)^(n-i): the coefficient of t^k is C(n,k) times the k-th difference at c_0.
  const int degree = static_cast<int>(values.size()) - 1;
  std::vector<Integer> difference(values);
  for (std::size_t k = 1; k < values.size(); ++k) {
    for (std::size_t i = values.size(); i-- > k;) difference[i] -= difference[i - 1];
  }
  for (int k = 0; k <= degree; ++k) difference[static_cast<std::size_t>(k)] *= binomial(degree, k);
  return Univariate(std::move(difference));
}

Univariate from_rationals(const std::vector<Rational>& coefficients) {
  return Univariate(scaled_integers(coefficients).values);
}

Rational value_at(const Univariate& f, const Rational& x) {
  Rational result = 0;
  for (std::size_t k = f.coefficients.size(); k-- > 0;) result = result * x + Rational(f.coefficients[k]);
  return result;
}

int sign_at(const Univariate& f, const Rational& x) {
  // Homogeneous in (numerator, denominator): no fractions.
  const Integer p = numerator(x), q = denominator(x);
  Integer sum = 0, power = 1;
  for (std::size_t k = f.coefficients.size(); k-- > 0;) {
    sum = sum * p + f.coefficients[k] * power;
    if (k > 0) power *= q;
  }
  return sum.sign();
}

Univariate operator+(const Univariate& f, const Univariate& g) {
  std::vector<Integer> sum(f.coefficients);
  if (sum.size() < g.coefficients.size()) sum.resize(g.coefficients.size(), 0);
  for (std::size_t k = 0; k < g.coefficients.size(); ++k) sum[k] += g.coefficients[k];
  return Univariate(std::move(sum));
}

Univariate operator-(const Univariate& f, const Univariate& g) {
  std::vector<Integer> sum(f.coefficients);
  if (sum.size() < g.coefficients.size()) sum.resize(g.coefficients.size(), 0);
  for (std::size_t k = 0; k < g.coefficients.size(); ++k) sum[k] -= g.coefficients[k];
  return Univariate(std::move(sum));
}

Univariate operator*(const Univariate& f, const Univariate& g) {
  const FlintPolynomial a(f), b(g);
  FlintPolynomial product;
  fmpz_poly_mul(product.value, a.value, b.value);
  return to_univariate(product.value);
}

Univariate derivative(const Univariate& f) {
  std::vector<Integer> result;
  for (std::size_t k = 1; k < f.coefficients.size(); ++k) {
    result.push_back(f.coefficients[k] * Integer(static_cast<unsigned long>(k)));
  }
  return Univariate(std::move(result));
}

Univariate gcd(const Univariate& f, const Univariate& g) {
  const FlintPolynomial a(f), b(g);
  FlintPolynomial divisor;
  fmpz_poly_gcd(divisor.value, a.value, b.value);
  if (fmpz_poly_is_zero(divisor.value) == 0) fmpz_poly_primitive_part(divisor.value, divisor.value);
  return to_univariate(divisor.value);
}

Univariate exact_quotient(const Univariate& f, const Univariate& g) {
  const FlintPolynomial a(f), b(g);
  FlintPolynomial quotient;
  if (fmpz_poly_divides(quotient.value, a.value, b.value) == 0) {
    throw std::logic_error("exact_quotient: the division leaves a remainder");
  }
  return to_univariate(quotient.value);
}

Univariate square_free_part(const Univariate& f) {
  FlintPolynomial a(f);
  fmpz_poly_primitive_part(a.value, a.value);
  FlintPolynomial slope, divisor, quotient;
  fmpz_poly_derivative(slope.value, a.value);
  fmpz_poly_gcd(divisor.value, a.value, slope.value);
  fmpz_poly_div(quotient.value, a.value, divisor.value);
  return to_univariate(quotient.value);
}

std::vector<std::pair<Univariate, int>> irreducible_factors(const Univariate& f) {
  FlintPolynomial a(f);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, a.value);
  std::vector<std::pair<Univariate, int>> result;
  for (slong i = 0; i < factors->num; ++i) {
    result.emplace_back(to_univariate(factors->p + i), static_cast<int>(factors->exp[i]));
  }
  fmpz_poly_factor_clear(factors);
  return result;
}

std::string to_string(const Univariate& f, const std::string& variable) {
  if (f.is_zero()) return "0";
  std::string text;
  for (std::size_t k = f.coefficients.size(); k-- > 0;) {
    const Integer& c = f.coefficients[k];
    if (c.is_zero()) continue;
    const Integer size = abs(c);
    if (text.empty()) {
      text += c.sign() < 0 ? "-" : "";
    } else {
      text += c.sign() < 0 ? " - " : " + ";
    }
    if (size != 1 || k == 0) text += size.str() + (k > 0 ? "*" : "");
    if (k > 0) text += variable + (k > 1 ? "^" + std::to_string(k) : "");
  }
  return text;
}

}  // namespace bezcert
