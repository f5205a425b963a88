// A planar mesh: nodes given exactly, elements of mixed kind and degree that refer to them. It does not
// change once it is made, and only MeshBuilder makes one: whatever a Mesh holds has been checked there.
#pragma once

#include "bezcert/element/element.hpp"
#include "bezcert/mesh/mesh_origin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bezcert {

struct MeshElement {
  Shape shape;
  Basis basis = Basis::bernstein;
  std::size_t first_node = 0;  ///< its nodes are connectivity()[first_node ...], in the order of shape.hpp
};

class Mesh {
 public:
  /// Coordinates of a node: 2.
  std::size_t dimension() const { return coordinates_.size(); }
  std::size_t node_count() const { return coordinates_[0].size(); }
  /// The k-th coordinate of every node. Precondition: k < dimension().
  const ExactVector& coordinates(std::size_t k) const { return coordinates_[k]; }
  /// Weights of the nodes, all positive; empty if none were given.
  const ExactVector& weights() const { return weights_; }
  /// Nodes of elements: all are below node_count().
  const std::vector<std::uint32_t>& connectivity() const { return connectivity_; }
  /// At least one.
  const std::vector<MeshElement>& elements() const { return elements_; }
  /// Whether elements are neighbours by common nodes (.msh); otherwise by edges that are exactly equal, and
  /// corners are one vertex if they are one point (.bez.json with elements that list their own points).
  bool glued_by_nodes() const { return glued_by_nodes_; }
  const MeshOrigin& origin() const { return origin_; }

  /// The i-th element with its own copy of its points. Precondition: i < elements().size().
  Element element(std::size_t i) const;

  /// Whether the i-th element has different weights: it is not polynomial.
  bool rational(std::size_t i) const;

 private:
  friend class MeshBuilder;
  Mesh() = default;

  std::array<ExactVector, 2> coordinates_;
  ExactVector weights_;
  std::vector<std::uint32_t> connectivity_;
  std::vector<MeshElement> elements_;
  bool glued_by_nodes_ = true;
  MeshOrigin origin_;
};

}  // namespace bezcert
