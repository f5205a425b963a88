// An edge of an element of a mesh, by name.
#pragma once

#include <cstdint>

namespace bezcert {

/// Edge `edge` of an element, from its corner of that number to the next.
struct ElementEdge {
  std::uint32_t element = 0;  ///< index into the mesh's elements
  int edge = 0;
};

}  // namespace bezcert
