// The signed area inside a closed chain of edges, exactly where they are polynomial, else between proven
// bounds (curve/area.hpp).
#pragma once

#include "bezcert/curve/area.hpp"
#include "bezcert/surface/boundary_loops.hpp"

namespace bezcert {

struct LoopArea {
  AreaBounds bounds;
  /// 1 counter-clockwise, -1 clockwise. Certain.
  int orientation = 0;
};

/// Positive where the chain runs counter-clockwise; upper - lower <= 2^-10 |area| but for very thin chains of
/// rational edges, whose orientation is found by the winding number around a point beside them. Precondition:
/// the chain is simple and closed.
LoopArea loop_area(const HalfEdges& edges, const BoundaryLoop& loop);

/// The same for a chain whose edges all have plain areas (polynomial_area.hpp) and few nodes, so that it
/// takes little time: nothing for others. The chain need not be simple, but then its area means little.
std::optional<LoopArea> plain_loop_area(const HalfEdges& edges, const BoundaryLoop& loop);

}  // namespace bezcert
