// At which parameters a curve passes a point, and the part of a curve between two parameters, exactly.
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/point.hpp"

namespace bezcert {

/// Whether the curve passes the point at some t in (0, 1) (rational or not).
bool passes_inside(const CurveNet<Integer>& curve, const Point& point);

/// The rational t in (lower, 1] at which the curve is at the point, ascending. Irrational ones are left out;
/// all of (lower, 1] is left out too if the curve is that point alone.
std::vector<Rational> rational_parameters(const CurveNet<Integer>& curve, const Point& point,
                                          const Rational& lower);

/// The same curve from t = lower to t = upper, as a curve over [0, 1]: its control points are the values of
/// the polar form at (lower, ..., lower, upper, ..., upper). Times a positive factor.
CurveNet<Integer> part_of(const CurveNet<Integer>& curve, const Rational& lower, const Rational& upper);

/// The point at a parameter.
Point point_at(const CurveNet<Integer>& curve, const Rational& t);

}  // namespace bezcert
