#include "bezcert/surface/obstacle.hpp"

#include "bezcert/surface/half_edges.hpp"

#include <algorithm>

namespace bezcert {

MeshVerdict kind_of(Cause cause) {
  switch (cause) {
    case Cause::not_injective: return MeshVerdict::invalid_element;
    case Cause::too_many_elements:
    case Cause::one_side:
    case Cause::pinched_vertex: return MeshVerdict::non_manifold;
    case Cause::crack:
    case Cause::crack_in_one_shape:
    case Cause::hanging_inside:
    case Cause::hanging_beside:
    case Cause::hanging_on_border:
    case Cause::hanging_in_gap: return MeshVerdict::non_conforming;
    case Cause::more_than_one_turn:
    case Cause::sliver_covered_twice:
    case Cause::several_turns: return MeshVerdict::folded_vertex;
    case Cause::unmerged_edges:
    case Cause::unmerged_nodes:
    case Cause::edges_meet:
    case Cause::edges_overlap:
    case Cause::nested: return MeshVerdict::overlapping_boundary;
    case Cause::not_decided:
    case Cause::contact_open:
    case Cause::nesting_open: break;
  }
  return MeshVerdict::undecided;
}

void MeshObstacle::add_edge(const HalfEdges& half_edges, HalfEdge h) {
  elements.push_back(half_edges.element(h));
  edges.push_back(half_edges.element_edge(h));
}

void MeshObstacle::add_element(std::uint32_t element) {
  constexpr std::size_t named = 100;
  if (elements.size() == named || std::find(elements.begin(), elements.end(), element) != elements.end())
    return;
  elements.push_back(element);
}

void MeshObstacle::add_node(const HalfEdges& half_edges, std::uint32_t node) {
  if (half_edges.mesh().glued_by_nodes()) nodes.push_back(node);
  points.push_back(half_edges.point(node));
}

void sort_unique(std::vector<std::uint32_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

void ObstacleList::add(MeshObstacle obstacle, std::size_t count) {
  const auto kind = static_cast<std::size_t>(obstacle.kind());
  counts_[kind] += count;
  if (element_ &&
      std::find(obstacle.elements.begin(), obstacle.elements.end(), *element_) == obstacle.elements.end()) {
    return;
  }
  if (by_kind_[kind].size() < kept) by_kind_[kind].push_back(std::move(obstacle));
}

std::vector<MeshObstacle> ObstacleList::all() const {
  std::vector<MeshObstacle> result;
  for (const auto& kind : by_kind_) result.insert(result.end(), kind.begin(), kind.end());
  return result;
}

MeshVerdict ObstacleList::verdict() const {
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    if (counts_[kind] > 0) return static_cast<MeshVerdict>(kind);
  }
  return MeshVerdict::embedding;
}

}  // namespace bezcert
