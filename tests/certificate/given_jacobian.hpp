// Elements whose det J is a given polynomial: the map (u, integral of f dv) has the determinant f. For the
// library and for the verifier, which knows nothing of it.
#pragma once

#include "refusal.hpp"

#include "algebra/polynomials.hpp"
#include "bezcert/element/element.hpp"
#include "bezcert/number/scaled.hpp"

#include "rules.hpp"

#include <algorithm>
#include <string>

namespace bezcert::test {

inline Rational falling(int n, int k) {
  Rational product = 1;
  for (int i = 0; i < k; ++i) product *= n - i;
  return product;
}

/// The Bernstein coefficient of u^i v^k at (column c, row r): blossoms of monomials.
inline Rational monomial_coefficient(Shape shape, int i, int k, int c, int r) {
  if (i > c || k > r) return 0;
  const Rational part = falling(c, i) * falling(r, k);
  return shape.domain == Domain::triangle
             ? Rational(part / falling(shape.degree(0), i + k))
             : Rational(part / (falling(shape.degree(0), i) * falling(shape.degree(1), k)));
}

inline Element element_with(const Bivariate& f, Domain domain) {
  int total = 0;
  for (int k = 0; k <= f.degree_v(); ++k) {
    const int degree = f.by_v[static_cast<std::size_t>(k)].degree();
    if (degree >= 0) total = std::max(total, degree + k);
  }
  const Shape shape = domain == Domain::triangle ? Shape{domain, total + 1, 0}
                                                 : Shape{domain, std::max(f.degree_u(), 1), f.degree_v() + 1};
  std::vector<Rational> x, y;
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      x.push_back(monomial_coefficient(shape, 1, 0, c, r));
      Rational sum = 0;
      for (int k = 0; k <= f.degree_v(); ++k) {
        const auto& row = f.by_v[static_cast<std::size_t>(k)].coefficients;
        for (std::size_t i = 0; i < row.size(); ++i) {
          sum += Rational(row[i]) / (k + 1) * monomial_coefficient(shape, static_cast<int>(i), k + 1, c, r);
        }
      }
      y.push_back(std::move(sum));
    }
  }
  return Element(shape, Basis::bernstein, {ExactVector(std::move(x)), ExactVector(std::move(y))});
}

/// What the verifier says of a claim for an element whose N is f times a positive constant: "" if it accepts.
inline std::string refusal(const Bivariate& f, Domain domain, const std::string& claim) {
  const Element element = element_with(f, domain);
  const std::size_t count = element.coordinates()[0].size();
  std::vector<Rational> all;
  for (const ExactVector* numbers : {&element.coordinates()[0], &element.coordinates()[1]}) {
    for (std::size_t i = 0; i < count; ++i) all.push_back((*numbers)[i]);
  }
  const ScaledIntegers scaled = scaled_integers(all);
  verifier::Element other;
  other.triangle = element.is_triangle();
  other.p = element.shape().degree(0);
  other.q = other.triangle ? other.p : element.shape().degree(1);
  other.lagrange = other.rational = false;
  other.unit = mpz_class(Integer(denominator(scaled.scale)).str());
  for (std::size_t i = 0; i < count; ++i) {
    other.x.emplace_back(Integer(scaled.values[i] * numerator(scaled.scale)).str());
    other.y.emplace_back(Integer(scaled.values[count + i] * numerator(scaled.scale)).str());
    other.w.emplace_back(1);
  }
  return refusal_of(claim, [&](verifier::Tokens& tokens) { verifier::check_element(other, tokens); });
}

}  // namespace bezcert::test
