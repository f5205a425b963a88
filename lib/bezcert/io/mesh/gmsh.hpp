// Gmsh .msh, versions 2.x and 4.1, ASCII and binary.
//
// Triangles and quadrangles of orders 1 to 10 with equispaced nodes; points, lines and volumes are counted
// and ignored; serendipity types are refused by name. The mesh must be planar: all nodes of its surface
// elements have the same z.
#pragma once

#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"

namespace bezcert {

/// Throws InputError.
MeshBuilder read_gmsh(const std::string& file, std::string_view bytes, const ReadOptions& options);

}  // namespace bezcert
