// How often closed curves run around a point, exactly.
//
// A piece whose control points see the point from outside their hull can be moved to its chord within the
// hull, so without passing the point: the winding number stays. Pieces are halved until all are such; the
// polygon of the chords is counted by its crossings of the ray from the point in direction +x (those upwards
// count +1, downwards -1, an end point on the ray belongs to the chord above it).
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/point.hpp"

#include <optional>
#include <span>

namespace bezcert {

/// What a curve adds to the winding number around `point` of a closed chain of curves; the sum over the chain
/// is the winding number. Nothing if `depth` halvings do not separate the point from the curve. Precondition:
/// the point is not on the curve (where it is, the answer means nothing).
std::optional<int> winding_share(DyadicCurve& curve, const Point& point, int depth = 4096);

/// The winding number of a closed chain. Nothing as above.
std::optional<int> winding_number(std::span<DyadicCurve> chain, const Point& point, int depth = 4096);

/// 1 if a closed chain runs counter-clockwise, -1 if clockwise. Precondition: it is simple, and the
/// derivative of its first curve is not 0 in the middle.
int orientation(std::span<DyadicCurve> chain);

}  // namespace bezcert
