// The surface of a mesh: its half-edges, what is glued to what, and the elements around every vertex.
//
// Gluing. Half-edges are grouped by their two end vertices (a counting sort: linear), and within a group by
// being the same curve (same_curve.hpp). Two half-edges of one curve in opposite directions are glued. Three
// or more, or two in the same direction, are non_manifold. Two that are left alone in their group in opposite
// directions have different curves: non_conforming, if these are close to each other or of one shape (a
// crack; far apart they bound a hole or the whole). What else is left alone is boundary. Definitions:
// docs/mesh.md, "Gluing".
//
// Hanging nodes that tear the elements around a vertex apart. A long edge from a to b faces two or more short
// ones between the same vertices. None of them is glued, so the elements at a and b fall into several fans,
// as if parts of the mesh only touched there. What is wrong is the node in between: it is named, as
// non_conforming, before vertices are looked at. (Hanging nodes at vertices with one fan are found where the
// boundary meets itself: boundary_contacts.hpp.)
//
// Fans. Corners at a vertex that share a glued edge follow each other counter-clockwise: they form closed
// fans (around an interior vertex) and open ones (from boundary edge to boundary edge). More than one fan is
// a pinched vertex, non_manifold. docs/mesh.md, "Vertices".
#pragma once

#include "bezcert/surface/half_edges.hpp"
#include "bezcert/surface/obstacle.hpp"

#include <span>

namespace bezcert {

/// The corners around a vertex from one boundary edge to the next, or all around, counter-clockwise.
struct Fan {
  bool closed = false;
  std::vector<HalfEdge> corners;
};

/// A corner is named by the half-edge that begins there, a vertex by a node: the first of the corner nodes
/// that are the same vertex.
class Surface : public HalfEdges {
 public:
  /// Glues the elements, whether or not they are regular; adds non_manifold and non_conforming obstacles.
  /// Keeps a reference: `mesh` must outlive this. Throws std::length_error beyond 2^32 - 2 edges.
  Surface(const Mesh& mesh, ObstacleList& obstacles);

  /// The vertices where a half-edge begins and ends.
  std::uint32_t begin(HalfEdge h) const { return begin_[h]; }
  std::uint32_t end(HalfEdge h) const { return begin_[next(h)]; }
  /// The half-edge it is glued to, or no_half_edge.
  HalfEdge opposite(HalfEdge h) const { return opposite_[h]; }
  bool is_boundary(HalfEdge h) const { return opposite_[h] == no_half_edge; }
  /// Whether an obstacle of the gluing names it: it is neither glued nor counts as boundary.
  bool is_faulty(HalfEdge h) const { return faulty_[h]; }

  /// Vertices are numbers below this; those without corners are none.
  std::uint32_t vertex_limit() const { return static_cast<std::uint32_t>(corner_start_.size() - 1); }
  /// The corners at a vertex, ascending.
  std::span<const HalfEdge> corners(std::uint32_t vertex) const {
    return {corners_.data() + corner_start_[vertex], corners_.data() + corner_start_[vertex + 1]};
  }
  /// The fans of a vertex, in the order of their first corners.
  std::vector<Fan> fans(std::uint32_t vertex) const;
  /// Whether the vertex has one fan, an open one.
  bool is_open(std::uint32_t vertex) const { return open_[vertex]; }
  /// Whether the vertex is not manifold, or a faulty edge ends there.
  bool is_bad(std::uint32_t vertex) const { return bad_[vertex]; }
  bool has_bad_vertices() const;
  /// For a boundary half-edge the one that begins where it ends; no_half_edge for others and at faulty
  /// vertices.
  HalfEdge next_boundary(HalfEdge h) const { return next_boundary_[h]; }
  /// The other way round. Precondition: is_boundary(h).
  HalfEdge previous_boundary(HalfEdge h) const;

 private:
  class Gluer;         // gluing.cpp
  class HangingNodes;  // hanging.cpp
  class FanLinker;     // surface.cpp
  // The stages of the construction, in this order.
  void glue(ObstacleList& obstacles);
  void sort_corners();
  void find_hanging_nodes(ObstacleList& obstacles);
  void link_fans(ObstacleList& obstacles);

  std::vector<std::uint32_t> begin_;
  std::vector<HalfEdge> opposite_;
  std::vector<bool> faulty_;
  // Pairs of faulty half-edges of which the second begins where the first ends, and which were to be glued
  // there: around that vertex their elements are neighbours.
  std::vector<std::pair<HalfEdge, HalfEdge>> meant_;
  std::vector<std::uint32_t> corner_start_;  // of each vertex, and the end
  std::vector<HalfEdge> corners_;
  std::vector<HalfEdge> next_boundary_;
  std::vector<bool> open_, bad_;
};

}  // namespace bezcert
