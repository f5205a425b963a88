// The edges of the elements of a mesh, numbered one after another, and their curves.
//
// Edge i of an element leads from its corner i to the next, counter-clockwise in the domain, so that the
// element lies on its left if it keeps the orientation. An edge that two elements share is two uses, one
// each; the mesh's gluing.hpp says which. Only numbers are kept here (8 bytes a use): curves are made when
// asked for.
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/point.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/mesh/mesh.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace bezcert {

/// One edge of one element.
using EdgeUse = std::uint32_t;
inline constexpr EdgeUse no_edge = std::numeric_limits<EdgeUse>::max();

/// Which end of an edge.
enum class End { begin, end };

/// A closed rectangle that contains something.
struct Box {
  double x_low, x_high, y_low, y_high;

  bool overlaps(const Box& other) const {
    return x_low <= other.x_high && other.x_low <= x_high && y_low <= other.y_high && other.y_low <= y_high;
  }
};

class MeshEdges {
 public:
  /// Keeps a reference: `mesh` must outlive this. Throws std::length_error beyond 2^32 - 2 edges.
  explicit MeshEdges(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  std::size_t count() const { return element_.size(); }
  std::size_t element_count() const { return mesh_.elements.size(); }

  std::uint32_t element(EdgeUse use) const { return element_[use]; }
  /// Edge number within the element.
  int edge(EdgeUse use) const { return static_cast<int>(use - first_[element_[use]]); }
  EdgeUse first(std::size_t element) const { return first_[element]; }
  EdgeUse next(EdgeUse use) const {
    return use + 1 == first_[element_[use] + 1] ? first_[element_[use]] : use + 1;
  }
  EdgeUse previous(EdgeUse use) const {
    return use == first_[element_[use]] ? first_[element_[use] + 1] - 1 : use - 1;
  }

  /// The number the file gives the element of an edge.
  std::uint64_t element_number(EdgeUse use) const { return mesh_.elements[element_[use]].tag; }
  /// The nodes along the edge; control points of it, or nodes that it interpolates.
  std::vector<std::uint32_t> nodes(EdgeUse use) const;
  std::uint32_t begin_node(EdgeUse use) const;
  Basis basis(EdgeUse use) const { return mesh_.elements[element_[use]].basis; }
  Point point(std::uint32_t node) const { return {mesh_.x[node], mesh_.y[node]}; }

  /// Homogeneous control points with X / W and Y / W the true coordinates; the factor of all three is
  /// positive.
  CurveNet<Integer> exact(EdgeUse use) const;
  /// Contains the true control points, up to the factor of W. Needs a RoundingScope.
  CurveNet<Interval> interval(EdgeUse use) const;
  /// Both. Needs a RoundingScope.
  DyadicCurve curve(EdgeUse use) const { return DyadicCurve(interval(use), exact(use)); }
  /// Contains the edge. Needs a RoundingScope.
  Box box(EdgeUse use) const;

  /// The tangent at an end, away from it along the edge, times a positive number; not zero where the element
  /// is regular. `interval_tangent` needs a RoundingScope.
  Vector2<Interval> interval_tangent(EdgeUse use, End end) const;
  Vector2<Integer> exact_tangent(EdgeUse use, End end) const;

 private:
  /// Whether the weights along these nodes are all equal (or there are none).
  bool equal_weights(const std::vector<std::uint32_t>& nodes) const;

  const Mesh& mesh_;
  std::vector<EdgeUse> first_;  // of each element, and the end
  std::vector<std::uint32_t> element_;
};

}  // namespace bezcert
