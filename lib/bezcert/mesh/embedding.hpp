// Whether a mesh as a whole is an embedding of its domain, or where it is not.
//
// Theorem (docs/mesh.md): let all elements be injective; glue them along edges that are equal curves, at most two to an
// edge and from opposite sides; let the corner angles make one turn around every interior vertex and less than one
// around every boundary vertex, and let the boundary loops be simple and disjoint. Then every component has genus 0 and
// one counter-clockwise loop, and its map is injective. Components do not overlap if in addition no component's outer
// loop lies in another component. All of it is decided exactly, in time near linear in the number of elements.
#pragma once

#include "bezcert/mesh/loop_area.hpp"
#include "bezcert/mesh/obstacle.hpp"

#include <span>

namespace bezcert {

/// What is known of one element alone.
enum class ElementState : std::uint8_t { injective, invalid, open };

struct MeshResult {
  MeshVerdict verdict = MeshVerdict::undecided;
  ObstacleList obstacles;
  /// Elements connected through common edges.
  std::size_t components = 0;
  /// Closed boundary chains; known where no vertex and no edge has an obstacle.
  std::optional<std::size_t> loops;
  /// Set for an embedding.
  std::optional<std::size_t> holes;
  std::optional<AreaBounds> area;
};

/// Precondition: one state an element, and true: the theorem rests on it. Throws std::length_error beyond 2^32 - 2 edges,
/// and std::logic_error if the mesh contradicts the theorem (a defect of bezcert).
MeshResult examine_mesh(const Mesh& mesh, std::span<const ElementState> states);

}  // namespace bezcert
