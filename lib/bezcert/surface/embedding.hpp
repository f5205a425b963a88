// Whether a mesh as a whole is an embedding of its domain, or where it is not.
//
// Theorem (docs/mesh.md): let all elements be injective; glue them along edges that are equal curves, at most
// two to an edge and from opposite sides; let the corner angles make one turn around every interior vertex
// and less than one around every boundary vertex (or exactly one that leaves out a sliver: a cusp), and let
// the boundary loops be simple and disjoint. Then every component has genus 0 and one counter-clockwise loop,
// and its map is injective. Components do not overlap if in addition no component's outer loop lies in
// another component. All of it is decided exactly, in time near linear in the number of elements.
#pragma once

#include "bezcert/surface/boundary_contacts.hpp"
#include "bezcert/surface/loop_area.hpp"
#include "bezcert/surface/mesh_result.hpp"
#include "bezcert/surface/turns.hpp"

#include <memory>

namespace bezcert {

struct MeshOptions {
  ContactBudget contact;
  /// Asks about one element: the obstacles that name it are listed, and the boundary is compared with its
  /// edges only, so that the verdict is not that of the mesh.
  std::optional<std::uint32_t> element;
};

/// What the decision of a mesh knows before it asks for those of its elements, so that another thread can
/// make it meanwhile.
class MeshTopology {
 public:
  /// Keeps a reference: `mesh` must outlive this. `element` as in MeshOptions. Throws std::length_error
  /// beyond 2^32 - 2 edges.
  explicit MeshTopology(const Mesh& mesh, std::optional<std::uint32_t> element = std::nullopt);

  const Surface& surface() const { return *surface_; }

 private:
  friend MeshResult examine_mesh(const MeshTopology&, std::span<const ElementState>, const ContactBudget&);

  ObstacleList obstacles_;
  std::shared_ptr<const Surface> surface_;
  Components components_;
  std::vector<WideFan> wide_;
  std::optional<std::vector<NearEdges>> near_;
  bool is_surface_ = false;          // no vertex is bad; then also:
  std::vector<BoundaryLoop> loops_;  // and, if there is no obstacle yet and the whole mesh is asked about:
  std::vector<std::optional<LoopArea>> areas_;  // of each loop, where it is plain
  std::vector<long> characteristics_;           // Euler's, of every component
};

/// Precondition: one state an element, and true: the theorem rests on it. Throws std::invalid_argument if
/// there are more or fewer, and std::logic_error if the mesh contradicts the theorem (a defect of bezcert).
MeshResult examine_mesh(const MeshTopology& topology, std::span<const ElementState> states,
                        const ContactBudget& budget = {});
/// The same, all at once.
MeshResult examine_mesh(const Mesh& mesh, std::span<const ElementState> states,
                        const MeshOptions& options = {});

}  // namespace bezcert
