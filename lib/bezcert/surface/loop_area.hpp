// The signed area inside a closed chain of edges, exactly where they are polynomial, else between proven
// bounds.
//
// Area = integral of (x dy - y dx) / 2 along the chain (Green). Polynomial edges: products of Bernstein
// polynomials are integrated exactly. Rational edges: on every piece the chord's share is exact and the rest,
// between chord and piece, is enclosed by the signs of the control points of its integrand; halving shrinks
// that fast. docs/mesh.md.
#pragma once

#include "bezcert/surface/boundary_loops.hpp"

namespace bezcert {

/// lower <= area <= upper; equal where all edges are polynomial.
struct AreaBounds {
  Rational lower = 0, upper = 0;

  bool is_exact() const { return lower == upper; }
};

struct LoopArea {
  AreaBounds bounds;
  /// 1 counter-clockwise, -1 clockwise. Certain.
  int orientation = 0;
};

/// Positive where the chain runs counter-clockwise; upper - lower <= 2^-10 |area| but for very thin chains of
/// rational edges, whose orientation is found by the winding number around a point beside them. Precondition:
/// the chain is simple and closed.
LoopArea loop_area(const MeshEdges& edges, const BoundaryLoop& loop);

/// The same for a chain whose edges all have plain areas (polynomial_area.hpp) and few nodes, so that it
/// takes little time: nothing for others. The chain need not be simple, but then its area means little.
std::optional<LoopArea> plain_loop_area(const MeshEdges& edges, const BoundaryLoop& loop);

}  // namespace bezcert
