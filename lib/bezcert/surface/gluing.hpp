// Which edges of elements are one edge of the mesh.
//
// Uses of an edge are grouped by their two end vertices (a counting sort: linear), and within a group by
// being the same curve (same_curve.hpp). Two uses of one curve in opposite directions are glued. Three or
// more, or two in the same direction, are non_manifold. Two uses that are left alone in their group in
// opposite directions have different curves: non_conforming, if these are close to each other or of one shape
// (a crack; far apart they bound a hole or the whole). What else is left alone is boundary. Definitions:
// docs/mesh.md, "Gluing".
#pragma once

#include "bezcert/surface/obstacle.hpp"

#include <vector>

namespace bezcert {

struct Gluing {
  /// The vertex where each use begins: a node, the first of those that are the same vertex.
  std::vector<std::uint32_t> begin;
  /// The use it is glued to, or no_edge.
  std::vector<EdgeUse> twin;
  /// Uses that an obstacle names: they are neither glued nor a boundary.
  std::vector<bool> faulty;
  /// Pairs of faulty uses of which the second begins where the first ends, and which were to be glued there:
  /// around that vertex their elements are neighbours.
  std::vector<std::pair<EdgeUse, EdgeUse>> meant;

  std::uint32_t end(const MeshEdges& edges, EdgeUse use) const { return begin[edges.next(use)]; }
  bool is_boundary(EdgeUse use) const { return twin[use] == no_edge; }
};

/// Adds non_manifold and non_conforming obstacles.
Gluing glue(const MeshEdges& edges, ObstacleList& obstacles);

/// The corners (uses that begin there) of every vertex: those of vertex v are corners[start[v]] ...
/// corners[start[v+1]-1].
struct CornersByVertex {
  std::vector<std::uint32_t> start;
  std::vector<EdgeUse> corners;
};
CornersByVertex corners_by_vertex(const MeshEdges& edges, const Gluing& gluing);

}  // namespace bezcert
