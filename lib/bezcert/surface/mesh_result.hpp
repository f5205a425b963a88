// The verdict of a mesh as a whole (embedding.hpp), with what stands in its way.
#pragma once

#include "bezcert/curve/area.hpp"
#include "bezcert/surface/obstacle.hpp"

#include <memory>

namespace bezcert {

class Surface;

struct MeshResult {
  MeshVerdict verdict = MeshVerdict::undecided;
  ObstacleList obstacles;
  /// Elements connected through common edges.
  std::size_t components = 0;
  /// Closed boundary chains, and those of them beyond one a component; known where the elements glue to a
  /// surface (no non_manifold or non_conforming edges and vertices). Of an embedding these are the holes one
  /// sees.
  std::optional<std::size_t> loops;
  std::optional<std::size_t> holes;
  /// Set for an embedding.
  std::optional<AreaBounds> area;
  /// How the elements were put together; refers to the mesh.
  std::shared_ptr<const Surface> surface;
};

}  // namespace bezcert
