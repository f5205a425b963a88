// Gmsh's element types and node orders.
#pragma once

#include "bezcert/bernstein/shape.hpp"

#include <string_view>
#include <vector>

namespace bezcert {

enum class GmshClass { point, line, surface, volume, serendipity, unsupported };

struct GmshType {
  GmshClass type_class = GmshClass::unsupported;
  int nodes = 0;          ///< nodes an element has
  Shape shape;            ///< of a surface element
  std::string_view name;  ///< of types that are refused
};

/// The type of a number; unsupported with 0 nodes if gmsh has none of that number that has a fixed count.
GmshType gmsh_type(long number);

/// For each node in gmsh's order (corners, edges counter-clockwise, then the interior as the same scheme,
/// recursively) its position in the order of shape.hpp.
std::vector<std::size_t> gmsh_node_order(Shape shape);

}  // namespace bezcert
