// The last step of the decision of a mesh: what the boundary loops, all simple and disjoint, say of its components.
#pragma once

#include "bezcert/mesh/loop_area.hpp"

namespace bezcert {

struct ComponentSummary {
  std::size_t holes = 0;
  AreaBounds area;
};

/// Checks that each component has one counter-clockwise loop and genus 0, else its cusps are folded_vertex obstacles,
/// and that no component lies in another (overlapping_boundary).
/// Preconditions: no obstacle so far, loops are simple and disjoint. Throws std::logic_error if a component without
/// cusps has other loops than the theorem allows.
ComponentSummary check_components(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                                  const Fans& fans, const Components& components,
                                  const std::vector<BoundaryLoop>& loops, ObstacleList& obstacles);

}  // namespace bezcert
