// The connected components of a mesh and the closed chains of its boundary edges.
#pragma once

#include "bezcert/surface/vertex_fans.hpp"

namespace bezcert {

/// Elements connected through glued edges, numbered from 0 by their first elements.
struct Components {
  std::vector<std::uint32_t> of_element;
  std::size_t count = 0;
};

Components find_components(const MeshEdges& edges, const Gluing& gluing);

/// Boundary edges in order, each beginning where the one before ends; the component lies on their left.
struct BoundaryLoop {
  std::vector<EdgeUse> uses;
  std::uint32_t component = 0;
};

/// All loops, in the order of their first uses. Chains that a bad vertex breaks are left out.
std::vector<BoundaryLoop> find_loops(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
                                     const Components& components);

/// V - E + F of every component. Precondition: no vertex is bad.
std::vector<long> euler_characteristics(const MeshEdges& edges, const Gluing& gluing,
                                        const CornersByVertex& corners, const Components& components);

}  // namespace bezcert
