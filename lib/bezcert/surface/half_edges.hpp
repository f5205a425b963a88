// The half-edges of a mesh: the edges of its elements, numbered one after another, and their curves.
//
// Half-edge i of an element leads from its corner i to the next, counter-clockwise in the domain, so that the
// element lies on its left if it keeps the orientation. An edge that two elements share is two half-edges,
// one each; surface.hpp says which. Only numbers are kept here (up to 8 bytes each): curves are made when
// asked for.
#pragma once

#include "bezcert/curve/box.hpp"
#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/mesh/mesh.hpp"
#include "bezcert/surface/element_edge.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace bezcert {

/// Which end of an edge.
enum class End { begin, end };

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

class HalfEdges {
 public:
  /// Keeps a reference: `mesh` must outlive this. Throws std::length_error beyond 2^32 - 2 edges.
  explicit HalfEdges(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  std::size_t count() const { return count_; }
  std::size_t element_count() const { return mesh_.elements().size(); }

  std::uint32_t element(HalfEdge h) const { return sides_ == 3 ? h / 3 : sides_ == 4 ? h / 4 : element_[h]; }
  /// Edge number within the element.
  int edge(HalfEdge h) const { return static_cast<int>(h - first(element(h))); }
  HalfEdge first(std::size_t element) const {
    return sides_ != 0 ? static_cast<HalfEdge>(element * sides_) : first_[element];
  }
  HalfEdge next(HalfEdge h) const {
    const std::uint32_t own = element(h);
    return h + 1 == first(own + std::size_t{1}) ? first(own) : h + 1;
  }
  HalfEdge previous(HalfEdge h) const {
    const std::uint32_t own = element(h);
    return h == first(own) ? first(own + std::size_t{1}) - 1 : h - 1;
  }

  ElementEdge element_edge(HalfEdge h) const { return {element(h), edge(h)}; }
  HalfEdge half_edge(ElementEdge of) const { return first(of.element) + static_cast<HalfEdge>(of.edge); }

  /// The nodes along the edge; control points of it, or nodes that it interpolates.
  EdgeNodes nodes(HalfEdge h) const {
    const std::uint32_t own = element(h);
    const std::size_t begin = stride_ > 0 ? own * stride_ : mesh_.elements()[own].first_node;
    return {mesh_.connectivity().data() + begin, shapes_[shape_of(own)].along[h - first(own)]};
  }
  std::uint32_t begin_node(HalfEdge h) const { return nodes(h).front(); }
  Basis basis(HalfEdge h) const { return shapes_[shape_of(element(h))].basis; }
  Point point(std::uint32_t node) const { return {mesh_.coordinates(0)[node], mesh_.coordinates(1)[node]}; }
  /// Compares two nodes by x, then by y: -1, 0, 1. Exact.
  int compare_points(std::uint32_t a, std::uint32_t b) const;

  /// Homogeneous control points with X / W and Y / W the true coordinates; the factor of all three is
  /// positive.
  CurveNet<Integer> exact(HalfEdge h) const;
  /// Contains the true control points, up to the factor of W.
  CurveNet<Interval> interval(const RoundUp&, HalfEdge h) const;
  /// Both.
  DyadicCurve curve(HalfEdge h) const {
    return DyadicCurve(interval(RoundUp(), h), [this, h] { return exact(h); });
  }
  /// Contains the edge.
  Box box(const RoundUp& up, HalfEdge h) const { return box_of(up, interval(up, h)); }

  /// The tangent at an end, away from it along the edge, times a positive number; not zero where the element
  /// is regular.
  Vector2<Interval> interval_tangent(const RoundUp&, HalfEdge h, End end) const;
  Vector2<Integer> exact_tangent(HalfEdge h, End end) const;

  /// A coordinate (0: x, 1: y) of the tangent in double, with its error; nothing where the numbers are no
  /// doubles, or too small or too large. In any rounding mode.
  std::optional<DoubleOperands<std::tuple<double>>> double_tangent(HalfEdge h, End end, int coordinate) const;

  /// Whether all control points of the edge, or the nodes it interpolates, have one weight (or none).
  bool equal_weights(HalfEdge h) const { return equal_weights(nodes(h)); }

 private:
  /// The coefficients of an end's tangent in the nodes (empty if they are no doubles or too large), and the
  /// error of their sum, in units of the largest difference to the end.
  struct TangentSum {
    std::vector<double> coefficients;
    double error = 0;
  };
  /// Positions of the nodes along each edge, in elements of one shape, and the tangents.
  struct ShapeEdges {
    Basis basis;
    std::array<std::vector<std::uint16_t>, 4> along;
    std::array<TangentSum, 4> tangent;
  };
  static TangentSum tangent_sum(Basis basis, std::size_t count);

  bool equal_weights(const EdgeNodes& nodes) const;
  std::size_t shape_of(std::size_t element) const { return shapes_.size() == 1 ? 0 : shape_[element]; }

  const Mesh& mesh_;
  std::size_t count_ = 0;
  std::size_t sides_ = 0;        // of every element, if all have as many; else 0, and then
  std::vector<HalfEdge> first_;  // of each element, and the end
  std::vector<std::uint32_t> element_;
  std::vector<ShapeEdges> shapes_;
  std::vector<std::uint16_t> shape_;  // of each element
  std::size_t stride_ = 0;  // nodes of every element, if all have as many and follow each other; else 0
};

}  // namespace bezcert
