// An element's map and det J at a parameter, from their definition: nothing of the library's mathematics.
//
// The basis functions are evaluated as they are written in textbooks, on numbers that carry their exact
// derivatives in u and v along.
#pragma once

#include "bezcert/element/element.hpp"

#include <vector>

namespace bezcert::test {

struct Dual {
  Rational value, u, v;
};

inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.u + b.u, a.v + b.v}; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.u * b.value + a.value * b.u, a.v * b.value + a.value * b.v};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const Rational square = b.value * b.value;
  return {a.value / b.value, (a.u * b.value - a.value * b.u) / square,
          (a.v * b.value - a.value * b.v) / square};
}
inline Dual constant(const Rational& value) { return {value, 0, 0}; }

inline Rational factorial(int n) { return n < 2 ? Rational(1) : n * factorial(n - 1); }

inline Dual power(const Dual& a, int n) { return n == 0 ? constant(1) : a * power(a, n - 1); }

// n! / (m_0! m_1! ...) t_0^m_0 t_1^m_1 ...
inline Dual bernstein_function(const std::vector<Dual>& t, const std::vector<int>& m) {
  int n = 0;
  Dual product = constant(1);
  for (std::size_t r = 0; r < m.size(); ++r) {
    n += m[r];
    product = product * power(t[r], m[r]) * constant(1 / factorial(m[r]));
  }
  return product * constant(factorial(n));
}

// 1 at the node m / n, 0 at all others: the product of (n t_r - s) / (m_r - s) over s < m_r.
inline Dual lagrange_function(const std::vector<Dual>& t, const std::vector<int>& m) {
  int n = 0;
  for (const int part : m) n += part;
  Dual product = constant(1);
  for (std::size_t r = 0; r < m.size(); ++r) {
    for (int s = 0; s < m[r]; ++s)
      product = product * (t[r] * constant(n) + constant(-s)) * constant(Rational(1, m[r] - s));
  }
  return product;
}

// The map's two coordinates.
struct DualPoint {
  Dual x, y;
};

/// The values of a parameter as reports show them.
using Values = std::vector<Rational>;

inline DualPoint exact_map(const Element& element, const Values& parameter) {
  const Shape shape = element.shape();
  const auto function = element.basis() == Basis::bernstein ? bernstein_function : lagrange_function;
  const bool triangle = shape.domain == Domain::triangle;
  const Dual u = {triangle ? parameter.at(1) : parameter.at(0), 1, 0};
  const Dual v = {triangle ? parameter.at(2) : parameter.at(1), 0, 1};
  const Dual minus = constant(-1);
  Dual x = constant(0), y = constant(0), w = constant(0);
  std::size_t i = 0;
  for (int r = 0; r <= (triangle ? shape.degree(0) : shape.degree(1)); ++r) {
    for (int c = 0; c <= (triangle ? shape.degree(0) - r : shape.degree(0)); ++c, ++i) {
      const Dual basis =
          triangle ? function({constant(1) + minus * u + minus * v, u, v}, {shape.degree(0) - r - c, c, r})
                   : function({constant(1) + minus * u, u}, {shape.degree(0) - c, c}) *
                         function({constant(1) + minus * v, v}, {shape.degree(1) - r, r});
      const Dual weighted = basis * constant(element.weights().empty() ? Rational(1) : element.weights()[i]);
      x = x + weighted * constant(element.coordinates()[0][i]);
      y = y + weighted * constant(element.coordinates()[1][i]);
      w = w + weighted;
    }
  }
  return {x / w, y / w};
}

inline Rational exact_determinant(const Element& element, const Values& parameter) {
  const DualPoint point = exact_map(element, parameter);
  return point.x.u * point.y.v - point.x.v * point.y.u;
}

}  // namespace bezcert::test
