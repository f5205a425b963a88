// An edge of an element of a mesh: by name, and by its number among all half-edges (half_edges.hpp).
#pragma once

#include <cstdint>
#include <limits>

namespace bezcert {

/// One edge of one element, by its number.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge no_half_edge = std::numeric_limits<HalfEdge>::max();

/// Edge `edge` of an element, from its corner of that number to the next.
struct ElementEdge {
  std::uint32_t element = 0;  ///< index into the mesh's elements
  int edge = 0;
};

}  // namespace bezcert
