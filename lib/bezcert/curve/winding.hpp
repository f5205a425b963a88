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

namespace bezcert {

/// What a curve adds to the winding number around `point` of a closed chain of curves; the sum over the chain
/// is the winding number. Nothing if `depth` halvings do not separate the point from the curve. Precondition:
/// the point is not on the curve (where it is, the answer means nothing).
std::optional<int> winding_share(DyadicCurve& curve, const Point& point, int depth = 4096);

}  // namespace bezcert
