// Whether the boundary edges of a mesh meet anywhere but where they are joined.
//
// Boxes that do not overlap part most pairs, and directions most neighbours; the others are decided exactly
// (curve/contact.hpp). Each contact is given its likely cause: two nodes at one point or
// unmerged edges, a hanging node, or parts that overlap.
#pragma once

#include "bezcert/curve/contact.hpp"
#include "bezcert/surface/surface.hpp"

namespace bezcert {

/// Two boundary edges that no obstacle of the gluing names and which may meet, as far as their boxes, their
/// joints and their directions (one_way.hpp) tell.
using NearEdges = std::pair<HalfEdge, HalfEdge>;

/// All of them (with `element` those that belong to it), or nothing if more than `limit` boxes overlap. Pairs
/// of one element, and of edges with a common begin or end, are left out: they are no matter of the boundary.
std::optional<std::vector<NearEdges>> find_near_edges(const Surface& surface,
                                                      const std::optional<std::uint32_t>& element,
                                                      std::size_t limit);

/// Compares near edges; those that are given, or all as they are found. Adds overlapping_boundary,
/// non_conforming and undecided obstacles; stops when ObstacleList::kept have been found. Preconditions: all
/// elements are injective; `near` was found for the element of the obstacles.
void check_boundary(const Surface& surface, const std::optional<std::vector<NearEdges>>& near,
                    const ContactBudget& budget, ObstacleList& obstacles);

}  // namespace bezcert
