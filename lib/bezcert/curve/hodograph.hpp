// The derivative of a rational Bezier curve, and whether it vanishes.
//
// (X / W)' = (X' W - X W') / W^2, and the same for Y: the hodograph is a rational Bezier curve again, of
// twice the degree and with the weights of W^2. The curve is regular where it is not the origin; that is a
// question about the common zeros of its two numerators.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/curve/vector.hpp"

namespace bezcert {

/// The curve whose point at t is the derivative c'(t). Times a positive factor.
CurveNet<Integer> hodograph(const CurveNet<Integer>& curve);

/// c'(t): length a unit of the parameter.
Vector2<Rational> derivative_at(const CurveNet<Integer>& curve, const Rational& t);

/// Whether the derivative vanishes nowhere on the closed interval [0, 1] (at rational parameters or others).
bool is_regular(const CurveNet<Integer>& curve);

}  // namespace bezcert
