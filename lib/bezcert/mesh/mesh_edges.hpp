// The edges of the elements of a mesh, numbered one after another, and their curves.
//
// Edge i of an element leads from its corner i to the next, counter-clockwise in the domain, so that the
// element lies on its left if it keeps the orientation. An edge that two elements share is two uses, one
// each; the mesh's gluing.hpp says which. Only numbers are kept here (up to 8 bytes a use): curves are made
// when asked for.
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/point.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
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

/// The nodes along an edge in its direction, or in the other one; a view of the mesh.
class EdgeNodes {
 public:
  EdgeNodes(const std::uint32_t* element, const std::vector<std::uint16_t>& positions)
      : element_(element), positions_(positions.data()), size_(positions.size()) {}

  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t i) const {
    return element_[positions_[backwards_ ? size_ - 1 - i : i]];
  }
  std::uint32_t front() const { return (*this)[0]; }
  std::uint32_t back() const { return (*this)[size_ - 1]; }
  EdgeNodes reversed() const {
    EdgeNodes result = *this;
    result.backwards_ = !backwards_;
    return result;
  }
  bool operator==(const EdgeNodes& other) const {
    if (size_ != other.size_) return false;
    for (std::size_t i = 0; i < size_; ++i) {
      if ((*this)[i] != other[i]) return false;
    }
    return true;
  }

 private:
  const std::uint32_t* element_;
  const std::uint16_t* positions_;
  std::size_t size_;
  bool backwards_ = false;
};

class MeshEdges {
 public:
  /// Keeps a reference: `mesh` must outlive this. Throws std::length_error beyond 2^32 - 2 edges.
  explicit MeshEdges(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  std::size_t count() const { return count_; }
  std::size_t element_count() const { return mesh_.elements().size(); }

  std::uint32_t element(EdgeUse use) const {
    return sides_ == 3 ? use / 3 : sides_ == 4 ? use / 4 : element_[use];
  }
  /// Edge number within the element.
  int edge(EdgeUse use) const { return static_cast<int>(use - first(element(use))); }
  EdgeUse first(std::size_t element) const {
    return sides_ != 0 ? static_cast<EdgeUse>(element * sides_) : first_[element];
  }
  EdgeUse next(EdgeUse use) const {
    const std::uint32_t own = element(use);
    return use + 1 == first(own + std::size_t{1}) ? first(own) : use + 1;
  }
  EdgeUse previous(EdgeUse use) const {
    const std::uint32_t own = element(use);
    return use == first(own) ? first(own + std::size_t{1}) - 1 : use - 1;
  }

  /// The number the file gives the element of an edge.
  std::uint64_t element_number(EdgeUse use) const { return mesh_.origin().number(element(use)); }
  /// The nodes along the edge; control points of it, or nodes that it interpolates.
  EdgeNodes nodes(EdgeUse use) const {
    const std::uint32_t own = element(use);
    const std::size_t begin = stride_ > 0 ? own * stride_ : mesh_.elements()[own].first_node;
    return {mesh_.connectivity().data() + begin, shapes_[shape_of(own)].along[use - first(own)]};
  }
  std::uint32_t begin_node(EdgeUse use) const { return nodes(use).front(); }
  Basis basis(EdgeUse use) const { return shapes_[shape_of(element(use))].basis; }
  Point point(std::uint32_t node) const { return {mesh_.coordinates(0)[node], mesh_.coordinates(1)[node]}; }

  /// Homogeneous control points with X / W and Y / W the true coordinates; the factor of all three is
  /// positive.
  CurveNet<Integer> exact(EdgeUse use) const;
  /// Contains the true control points, up to the factor of W. Needs a RoundingScope.
  CurveNet<Interval> interval(EdgeUse use) const;
  /// Both. Needs a RoundingScope.
  DyadicCurve curve(EdgeUse use) const {
    return DyadicCurve(interval(use), [this, use] { return exact(use); });
  }
  /// Contains the edge. Needs a RoundingScope.
  Box box(EdgeUse use) const;

  /// The tangent at an end, away from it along the edge, times a positive number; not zero where the element
  /// is regular. `interval_tangent` needs a RoundingScope.
  Vector2<Interval> interval_tangent(EdgeUse use, End end) const;
  Vector2<Integer> exact_tangent(EdgeUse use, End end) const;

  /// The sign of a coordinate (0: x, 1: y) of the tangent, if sums of doubles and a bound of their error tell
  /// it (proof in mesh_edges.cpp). In any rounding mode.
  std::optional<int> tangent_sign(EdgeUse use, End end, int coordinate) const;

  /// Whether all control points of the edge, or the nodes it interpolates, have one weight (or none).
  bool equal_weights(EdgeUse use) const { return equal_weights(nodes(use)); }

 private:
  /// Positions of the nodes along each edge, in elements of one shape, and the coefficients of an end's
  /// tangent in the nodes (empty if they are no doubles).
  struct ShapeEdges {
    Basis basis;
    std::array<std::vector<std::uint16_t>, 4> along;
    std::array<std::vector<double>, 4> tangent;
  };

  bool equal_weights(const EdgeNodes& nodes) const;
  std::size_t shape_of(std::size_t element) const { return shapes_.size() == 1 ? 0 : shape_[element]; }

  const Mesh& mesh_;
  std::size_t count_ = 0;
  std::size_t sides_ = 0;       // of every element, if all have as many; else 0, and then
  std::vector<EdgeUse> first_;  // of each element, and the end
  std::vector<std::uint32_t> element_;
  std::vector<ShapeEdges> shapes_;
  std::vector<std::uint16_t> shape_;  // of each element
  std::size_t stride_ = 0;  // nodes of every element, if all have as many and follow each other; else 0
};

}  // namespace bezcert
