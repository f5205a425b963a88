// Sizes relative to an element: the same for affine images of a mesh.
//
// Whether a gap between edges is a crack or a hole that is meant is no question of exactness but of size;
// what it is called must not depend on units or directions. So differences are measured in the frame of an
// edge's end points and the point of its element that is farthest from their line.
#pragma once

#include "bezcert/surface/half_edges.hpp"

namespace bezcert {

class ElementFrame {
 public:
  /// The frame of an edge. Exact.
  ElementFrame(const HalfEdges& edges, HalfEdge h);

  /// Whether the difference q - p has coordinates of at most 1/8. False if all points of the element are
  /// collinear.
  bool is_small(const Point& p, const Point& q) const;

 private:
  Vector2<Rational> along_, across_;
  Rational area_ = 0;  // cross(along, across)
};

/// Whether two uses between the same two vertices, in opposite directions, are close to each other at equal
/// parameters (15 of them), in the frame of one of them.
bool are_close(const HalfEdges& edges, HalfEdge a, HalfEdge b);

/// Whether a point is close to one of 33 points of an edge.
bool is_near(const ElementFrame& frame, const CurveNet<Integer>& edge, const Point& point);

}  // namespace bezcert
