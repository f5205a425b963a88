// Whether the boundary edges of a mesh meet anywhere but where they are joined.
//
// Boxes that do not overlap part most pairs; the others are decided exactly (curve/contact.hpp). Each contact
// is put in the words of its likely cause: two nodes at one point or unmerged edges, a hanging node, or parts
// that overlap.
#pragma once

#include "bezcert/curve/contact.hpp"
#include "bezcert/mesh/vertex_fans.hpp"

namespace bezcert {

/// Compares all boundary edges that no obstacle of the gluing names. Adds overlapping_boundary,
/// non_conforming and undecided obstacles; stops when ObstacleList::kept have been found. Precondition: all
/// elements are injective.
void check_boundary(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
                    const ContactBudget& budget, ObstacleList& obstacles);

}  // namespace bezcert
