// How far curves are apart that should be one: proven bounds.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/number/dyadic.hpp"

namespace bezcert {

/// Proven bounds of a distance.
struct DistanceBounds {
  Dyadic lower, upper;
};

/// Bounds of the largest distance of a(t) to b(t), t in [0, 1]. The lower bound is attained at a dyadic
/// parameter, up to rounding; the upper one is that of the control points of the difference on 64 pieces.
DistanceBounds largest_distance(const CurveNet<Integer>& a, const CurveNet<Integer>& b);

/// An upper bound of the distance of a point to a curve, that to the nearest of 65 of its points. The lower
/// bound is 0.
DistanceBounds distance_bounds(const CurveNet<Integer>& curve, const Point& point);

/// Bounds of the square root of a number >= 0.
Dyadic root_down(const Rational& square);
Dyadic root_up(const Rational& square);

}  // namespace bezcert
