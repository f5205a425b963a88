// Polynomials with rational coefficients by schoolbook algorithms: an independent check of the library's
// algebra.
#pragma once

#include "bezcert/number/rational.hpp"

#include <concepts>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bezcert::test {

/// sum of c[k] x^k, no leading zeros.
struct RationalPolynomial {
  std::vector<Rational> c;

  RationalPolynomial() = default;
  RationalPolynomial(std::vector<Rational> coefficients) : c(std::move(coefficients)) { shrink(); }
  template <std::same_as<Integer> T>  // a template: a list in braces is one of rationals
  explicit RationalPolynomial(const std::vector<T>& coefficients)
      : c(coefficients.begin(), coefficients.end()) {
    shrink();
  }

  int degree() const { return static_cast<int>(c.size()) - 1; }
  bool is_zero() const { return c.empty(); }
  Rational operator()(const Rational& x) const {
    Rational sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * x + c[k];
    return sum;
  }
  void shrink() {
    while (!c.empty() && c.back().is_zero()) c.pop_back();
  }
  bool operator==(const RationalPolynomial&) const = default;
};

inline RationalPolynomial operator+(RationalPolynomial f, const RationalPolynomial& g) {
  if (f.c.size() < g.c.size()) f.c.resize(g.c.size(), 0);
  for (std::size_t k = 0; k < g.c.size(); ++k) f.c[k] += g.c[k];
  f.shrink();
  return f;
}

inline RationalPolynomial operator*(const RationalPolynomial& f, const RationalPolynomial& g) {
  if (f.is_zero() || g.is_zero()) return {};
  std::vector<Rational> c(f.c.size() + g.c.size() - 1, 0);
  for (std::size_t i = 0; i < f.c.size(); ++i) {
    for (std::size_t j = 0; j < g.c.size(); ++j) c[i + j] += f.c[i] * g.c[j];
  }
  return {std::move(c)};
}

inline RationalPolynomial operator*(const Rational& factor, RationalPolynomial f) {
  for (Rational& x : f.c) x *= factor;
  f.shrink();
  return f;
}

inline RationalPolynomial operator-(const RationalPolynomial& f, const RationalPolynomial& g) {
  return f + Rational(-1) * g;
}

inline RationalPolynomial slope(const RationalPolynomial& f) {
  std::vector<Rational> c;
  for (std::size_t k = 1; k < f.c.size(); ++k) c.push_back(f.c[k] * Rational(static_cast<long>(k)));
  return {std::move(c)};
}

/// Quotient and remainder. Precondition: g is not 0.
inline std::pair<RationalPolynomial, RationalPolynomial> divide(RationalPolynomial f,
                                                                const RationalPolynomial& g) {
  if (g.is_zero()) throw std::logic_error("divide: by 0");
  std::vector<Rational> quotient(f.c.size() >= g.c.size() ? f.c.size() - g.c.size() + 1 : 0, 0);
  while (f.c.size() >= g.c.size()) {
    const std::size_t shift = f.c.size() - g.c.size();
    const Rational factor = f.c.back() / g.c.back();
    for (std::size_t k = 0; k < g.c.size(); ++k) f.c[shift + k] -= factor * g.c[k];
    quotient[shift] = factor;
    f.shrink();
  }
  return {RationalPolynomial(std::move(quotient)), std::move(f)};
}

/// Monic, or 0.
inline RationalPolynomial common_divisor(RationalPolynomial f, RationalPolynomial g) {
  while (!g.is_zero()) {
    RationalPolynomial rest = divide(std::move(f), g).second;
    if (!rest.is_zero()) rest = (1 / rest.c.back()) * rest;
    f = std::move(g);
    g = std::move(rest);
  }
  return f.is_zero() ? f : (1 / f.c.back()) * f;
}

inline RationalPolynomial without_multiple_roots(const RationalPolynomial& f) {
  return f.degree() < 1 ? f : divide(f, common_divisor(f, slope(f))).first;
}

/// The number of different real roots in the closed interval, by Sturm's theorem. Precondition: f is not 0.
inline int count_roots(const RationalPolynomial& f, const Rational& low, const Rational& high) {
  if (f.degree() < 1) return 0;
  std::vector<RationalPolynomial> chain = {without_multiple_roots(f)};
  chain.push_back(slope(chain[0]));
  while (chain.back().degree() > 0) {
    RationalPolynomial rest = divide(chain[chain.size() - 2], chain.back()).second;
    const Rational size = abs(rest.c.back());
    chain.push_back(Rational(-1 / size) * rest);
  }
  const auto variations = [&](const Rational& x) {
    int changes = 0, last = 0;
    for (const RationalPolynomial& g : chain) {
      const int s = sign(g(x));
      if (s != 0 && last != 0 && s != last) ++changes;
      if (s != 0) last = s;
    }
    return changes;
  };
  return variations(low) - variations(high) + (chain[0](low).is_zero() ? 1 : 0);
}

}  // namespace bezcert::test
