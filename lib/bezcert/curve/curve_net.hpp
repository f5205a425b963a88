// A rational Bezier curve by its homogeneous control points, and other control points of the same curve.
//
// The point at t is (X / W, Y / W) with X, Y, W the polynomials of the coefficients x, y, w in the Bernstein
// basis; all w are positive, so the curve lies in the hull of the points (x_i / w_i, y_i / w_i). A common
// positive factor of all coefficients changes nothing, which is how exact curves stay in integers.
#pragma once

#include "bezcert/curve/point.hpp"
#include "bezcert/number/rational.hpp"

#include <utility>
#include <vector>

namespace bezcert {

/// Homogeneous control points of a curve, in order; at least one.
template <class T>
struct CurveNet {
  std::vector<T> x, y, w;

  std::size_t size() const { return x.size(); }
  bool operator==(const CurveNet&) const = default;
};

/// The curve run through from its end.
template <class T>
CurveNet<T> reversed(const CurveNet<T>& net) {
  return {{net.x.rbegin(), net.x.rend()}, {net.y.rbegin(), net.y.rend()}, {net.w.rbegin(), net.w.rend()}};
}

/// Whether all weights are equal. (A common factor of X, Y and W may hide that a curve is polynomial.)
bool is_polynomial(const CurveNet<Integer>& curve);

/// The point at a parameter.
Point point_at(const CurveNet<Integer>& curve, const Rational& t);

/// The same curve from t = lower to t = upper, as a curve over [0, 1]: its control points are the values of
/// the polar form at (lower, ..., lower, upper, ..., upper). Times a positive factor. (Beyond [0, 1] it is
/// the curve prolonged, and weights need not be positive.)
CurveNet<Integer> part_of(const CurveNet<Integer>& curve, const Rational& lower, const Rational& upper);

/// The parts before and after t.
std::pair<CurveNet<Integer>, CurveNet<Integer>> split(const CurveNet<Integer>& curve, const Rational& t);

/// The same map of [0, 1] with control points of a higher degree, times a positive factor. Precondition:
/// degree >= curve.size() - 1.
CurveNet<Integer> elevated(const CurveNet<Integer>& curve, int degree);

/// The same curve after the change of its parameter t -> a t / (a t + b (1 - t)), which keeps both ends:
/// control point i is multiplied by a^i b^(degree - i). With a : b = w_0^(1/degree) : w_n^(1/degree), where
/// these are rational, the weights of both ends become equal. Precondition: a, b > 0.
CurveNet<Integer> balanced(const CurveNet<Integer>& curve, const Integer& a, const Integer& b);

/// The Bernstein coefficients of f g, number k times C(m + n, k), from those of f and g.
std::vector<Integer> scaled_product(const std::vector<Integer>& f, const std::vector<Integer>& g);

/// The curve whose coefficients are given times C(degree, k), times a positive factor.
CurveNet<Integer> from_scaled(CurveNet<Integer> scaled);

}  // namespace bezcert
