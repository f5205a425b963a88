// Whether two rational Bezier curves are one curve with one parametrisation, as edges that are glued must be.
//
// Same means: equal as maps of [0, 1] to the plane up to a projective change of the parameter,
// t -> a t / (a t + b (1 - t)) with a, b > 0. Degree elevation, common factors of X, Y, W and the scale of
// the weights do not matter; every other change of the parameter does. Theorem and proof: docs/mesh.md, "Same
// curves".
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"

#include <optional>

namespace bezcert {

/// rho = power^(1/exponent) > 0; `exponent` is the smallest for which rho^exponent is rational, so that the
/// powers of rho below it are linearly independent over the rationals.
struct ParameterChange {
  int exponent = 1;
  Rational power = 1;
};

/// With z = t / (1 - t): the rho for which a at rho z is b at z, if there is one. Precondition: all weights
/// are positive.
std::optional<ParameterChange> parameter_change(const CurveNet<Integer>& a, const CurveNet<Integer>& b);

/// Whether a and b are the same: there is such a rho.
inline bool same_curve(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  return parameter_change(a, b).has_value();
}

/// The curve run through from its end.
template <class T>
CurveNet<T> reversed(const CurveNet<T>& net) {
  return {{net.x.rbegin(), net.x.rend()}, {net.y.rbegin(), net.y.rend()}, {net.w.rbegin(), net.w.rend()}};
}

}  // namespace bezcert
