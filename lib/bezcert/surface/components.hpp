// The last step of the decision of a mesh: what the boundary loops, all simple and disjoint, say of its
// components.
#pragma once

#include "bezcert/surface/loop_area.hpp"

namespace bezcert {

/// What is known of simple and disjoint loops: area and orientation of each, V - E + F of every component.
struct LoopFacts {
  std::vector<LoopArea> areas;
  std::vector<long> characteristics;

  /// Sum of (turns - 1) over all vertices inside: counter-clockwise loops less clockwise ones, less the Euler
  /// characteristics (docs/mesh.md, "The theorem"). Precondition: open fans have at most one turn.
  long extra_turns() const;
};

/// The area of all components, after checking that no component lies in another (overlapping_boundary).
/// Preconditions: no obstacle so far, loops are simple and disjoint. Throws std::logic_error if a component
/// has other loops than the theorem allows: one counter-clockwise, and as many as make its genus 0.
AreaBounds check_components(const Surface& surface, const Components& components,
                            const std::vector<BoundaryLoop>& loops, const LoopFacts& facts,
                            ObstacleList& obstacles);

}  // namespace bezcert
