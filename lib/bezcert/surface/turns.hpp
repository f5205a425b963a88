// How often the elements around a vertex turn around it.
//
// At a corner of a regular element the tangents span an angle between 0 and half a turn, so full turns are
// counted exactly by signs: how many sectors hold a reference direction. Definitions and proof: docs/mesh.md,
// "Vertices".
#pragma once

#include "bezcert/surface/surface.hpp"

namespace bezcert {

/// A vertex of the boundary around which elements make a full turn, or more than one.
struct WideFan {
  std::uint32_t vertex = 0;
  bool more = false;
};

/// All of them, of manifold vertices. Means nothing where elements are not regular.
std::vector<WideFan> find_wide_fans(const Surface& surface);

/// Adds a folded_vertex obstacle for those with more than one turn. A vertex may have exactly one (a cusp) if
/// its two boundary edges leave a sliver out between them, not if the sliver is covered twice. Precondition:
/// all elements are regular.
void check_wide_fans(const Surface& surface, std::span<const WideFan> wide, ObstacleList& obstacles);

/// The same for all manifold vertices inside, which must have one turn.
void check_closed_fans(const Surface& surface, ObstacleList& obstacles);

}  // namespace bezcert
