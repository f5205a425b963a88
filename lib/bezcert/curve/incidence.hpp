// Which points lie on a curve, and at which parameters, exactly.
#pragma once

#include "bezcert/curve/curve_net.hpp"

namespace bezcert {

/// Whether the curve passes the point at some t in (0, 1) (rational or not).
bool passes_inside(const CurveNet<Integer>& curve, const Point& point);

/// The rational t in (lower, 1] at which the curve is at the point, ascending. Irrational ones are left out;
/// all of (lower, 1] is left out too if the curve is that point alone.
std::vector<Rational> rational_parameters(const CurveNet<Integer>& curve, const Point& point,
                                          const Rational& lower);

/// Whether a piece of b, between end points of the two, runs along a.
bool run_together(const CurveNet<Integer>& a, const CurveNet<Integer>& b);

}  // namespace bezcert
