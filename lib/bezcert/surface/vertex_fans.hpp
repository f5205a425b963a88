// The elements around every vertex, and how often they turn around it.
//
// Corners at a vertex that share a glued edge follow each other counter-clockwise: they form closed fans
// (around an interior vertex) and open ones (from boundary edge to boundary edge). More than one fan is a
// pinched vertex. At a corner of a regular element the tangents span an angle between 0 and half a turn, so
// full turns are counted exactly by signs: how many sectors hold a reference direction. Definitions and
// proof: docs/mesh.md, "Vertices".
#pragma once

#include "bezcert/surface/gluing.hpp"

namespace bezcert {

/// The corners around a vertex from one boundary edge to the next, or all around, counter-clockwise.
struct Fan {
  bool closed = false;
  std::vector<EdgeUse> corners;
};

struct Fans {
  /// For every boundary use the boundary use that begins where it ends; no_edge for others and at faulty
  /// vertices.
  std::vector<EdgeUse> next_boundary;
  /// Vertices with one fan, an open one.
  std::vector<bool> open;
  /// Vertices that are not manifold, or that a faulty edge ends at.
  std::vector<bool> bad;
};

/// The fans of the corners of one vertex, in the order of their first corners.
std::vector<Fan> fans_of(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                         std::uint32_t vertex);

/// Links the boundary; adds non_manifold obstacles for pinched vertices.
Fans link_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
               ObstacleList& obstacles);

/// A vertex of the boundary around which elements make a full turn, or more than one.
struct WideFan {
  std::uint32_t vertex = 0;
  bool more = false;
};

/// All of them, of manifold vertices. Means nothing where elements are not regular.
std::vector<WideFan> find_wide_fans(const MeshEdges& edges, const Gluing& gluing,
                                    const CornersByVertex& corners, const Fans& fans);

/// Adds a folded_vertex obstacle for those with more than one turn. A vertex may have exactly one (a cusp) if
/// its two boundary edges leave a sliver out between them, not if the sliver is covered twice. Precondition:
/// all elements are regular.
void check_wide_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                     const std::vector<WideFan>& wide, ObstacleList& obstacles);

/// The same for all manifold vertices inside, which must have one turn.
void check_closed_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                       const Fans& fans, ObstacleList& obstacles);

}  // namespace bezcert
