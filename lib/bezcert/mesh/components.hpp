// The last step of the decision of a mesh: what the boundary loops, all simple and disjoint, say of its
// components.
#pragma once

#include "bezcert/mesh/loop_area.hpp"

namespace bezcert {

/// The area of all components, after checking that no component lies in another (overlapping_boundary).
/// Preconditions: no obstacle so far, loops are simple and disjoint. Throws std::logic_error if a component
/// has other loops than the theorem allows: one counter-clockwise, and as many as make its genus 0.
AreaBounds check_components(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                            const Components& components, const std::vector<BoundaryLoop>& loops,
                            ObstacleList& obstacles);

}  // namespace bezcert
