// The connected components of a mesh and the closed chains of its boundary surface.
#pragma once

#include "bezcert/surface/surface.hpp"

namespace bezcert {

/// Elements connected through glued edges, numbered from 0 by their first elements.
struct Components {
  std::vector<std::uint32_t> of_element;
  std::size_t count = 0;
};

Components find_components(const Surface& surface);

/// Boundary edges in order, each beginning where the one before ends; the component lies on their left.
struct BoundaryLoop {
  std::vector<HalfEdge> edges;
  std::uint32_t component = 0;
};

/// All loops, in the order of their first half-edges. Chains that a bad vertex breaks are left out.
std::vector<BoundaryLoop> find_loops(const Surface& surface, const Components& components);

/// V - E + F of every component. Precondition: no vertex is bad.
std::vector<long> euler_characteristics(const Surface& surface, const Components& components);

}  // namespace bezcert
