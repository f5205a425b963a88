// The geometric map of an element and its Jacobian determinant, straight from the definition:
//   x(u, v) = sum w P B / sum w B, differentiated by the quotient rule, in rationals.
// Shares nothing with the library's numerator, nets or de Casteljau; only the order of coefficients.
#pragma once

#include "bernstein/explicit_sum.hpp"

#include "bezcert/element/map.hpp"

#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {

/// Control points and weights of a rational Bezier element, one a coefficient; `w` empty for a polynomial
/// one.
struct ControlNet {
  Shape shape;
  std::vector<Rational> x;
  std::vector<Rational> y;
  std::vector<Rational> w;

  Rational weight(std::size_t m) const { return w.empty() ? Rational(1) : w[m]; }
};

/// The values of a parameter (Parameter::values), free to compute with.
using Values = std::vector<Rational>;

/// det J by the library's evaluation of the map.
inline Rational map_determinant(const Element& element, const Values& at) {
  return evaluate_map(element, Parameter(element.shape().domain, at)).determinant;
}

inline Element bernstein_element(const ControlNet& net) {
  return Element(net.shape, Basis::bernstein, {ExactVector(net.x), ExactVector(net.y)}, ExactVector(net.w));
}

/// Row and column of every coefficient.
inline std::vector<std::pair<int, int>> rows_and_columns(Shape shape) {
  std::vector<std::pair<int, int>> result;
  const int rows = shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1);
  for (int r = 0; r <= rows; ++r) {
    const int last = shape.domain == Domain::triangle ? shape.degree(0) - r : shape.degree(0);
    for (int c = 0; c <= last; ++c) result.emplace_back(r, c);
  }
  return result;
}

/// d/du (0) or d/dv (1) of every basis function; on the triangle xi = (1-u-v, u, v).
inline std::vector<Rational> basis_derivatives(Shape shape, const std::vector<Rational>& at, int direction) {
  // d/dx of x^n, and 0 for n = 0.
  const auto slope = [](const std::vector<Rational>& power, int n) {
    return n == 0 ? Rational(0) : Rational(n * power[static_cast<std::size_t>(n) - 1]);
  };
  const auto get = [](const std::vector<Rational>& power, int n) {
    return power[static_cast<std::size_t>(n)];
  };
  std::vector<Rational> result;
  if (shape.domain == Domain::triangle) {
    const auto x = powers(at[0], shape.degree(0));
    const auto y = powers(at[1], shape.degree(0));
    const auto z = powers(at[2], shape.degree(0));
    for (const auto& [k, j] : rows_and_columns(shape)) {
      const int i = shape.degree(0) - j - k;
      const Rational factor(
          Integer(factorial(shape.degree(0)) / (factorial(i) * factorial(j) * factorial(k))));
      const Rational by_first = slope(x, i) * get(y, j) * get(z, k);
      const Rational by_other = direction == 0 ? Rational(get(x, i) * slope(y, j) * get(z, k))
                                               : Rational(get(x, i) * get(y, j) * slope(z, k));
      result.push_back(factor * (by_other - by_first));
    }
    return result;
  }
  const auto u = powers(at[0], shape.degree(0));
  const auto u1 = powers(1 - at[0], shape.degree(0));
  const auto v = powers(at[1], shape.degree(1));
  const auto v1 = powers(1 - at[1], shape.degree(1));
  for (const auto& [r, c] : rows_and_columns(shape)) {
    const Rational factor(Integer(choose(shape.degree(0), c) * choose(shape.degree(1), r)));
    const Rational along_u = get(u1, shape.degree(0) - c) * get(u, c);
    const Rational along_v = get(v1, shape.degree(1) - r) * get(v, r);
    const Rational slope_u =
        get(u1, shape.degree(0) - c) * slope(u, c) - slope(u1, shape.degree(0) - c) * get(u, c);
    const Rational slope_v =
        get(v1, shape.degree(1) - r) * slope(v, r) - slope(v1, shape.degree(1) - r) * get(v, r);
    result.push_back(factor * (direction == 0 ? Rational(slope_u * along_v) : Rational(along_u * slope_v)));
  }
  return result;
}

/// The homogeneous map (X, Y, W) = sum (w x, w y, w) B.
struct Homogeneous {
  Rational x, y, w;
};
inline Homogeneous weighted_sum(const ControlNet& net, const std::vector<Rational>& basis) {
  Homogeneous sum{0, 0, 0};
  for (std::size_t m = 0; m < basis.size(); ++m) {
    const Rational weighted = net.weight(m) * basis[m];
    sum.x += weighted * net.x[m];
    sum.y += weighted * net.y[m];
    sum.w += weighted;
  }
  return sum;
}

/// Whether the map is defined there: outside the domain W may vanish.
inline bool defined_at(const ControlNet& net, const std::vector<Rational>& at) {
  return weighted_sum(net, basis_values(net.shape, at)).w != 0;
}

inline std::pair<Rational, Rational> point_at(const ControlNet& net, const std::vector<Rational>& at) {
  const Homogeneous p = weighted_sum(net, basis_values(net.shape, at));
  return {p.x / p.w, p.y / p.w};
}

/// det J with respect to (u, v) by the quotient rule. Precondition: defined_at.
inline Rational direct_determinant(const ControlNet& net, const std::vector<Rational>& at) {
  const Homogeneous p = weighted_sum(net, basis_values(net.shape, at));
  const Homogeneous pu = weighted_sum(net, basis_derivatives(net.shape, at, 0));
  const Homogeneous pv = weighted_sum(net, basis_derivatives(net.shape, at, 1));
  const Rational ww = p.w * p.w;
  const Rational xu = (pu.x * p.w - p.x * pu.w) / ww;
  const Rational yu = (pu.y * p.w - p.y * pu.w) / ww;
  const Rational xv = (pv.x * p.w - p.x * pv.w) / ww;
  const Rational yv = (pv.y * p.w - p.y * pv.w) / ww;
  return xu * yv - xv * yu;
}

inline std::string show(const ControlNet& net) {
  return show(net.shape) + " x " + show(net.x) + " y " + show(net.y) + " w " + show(net.w);
}

}  // namespace bezcert::test
