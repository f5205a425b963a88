#include "bezcert/mesh/obstacle.hpp"

#include <algorithm>

namespace bezcert {

std::string_view name(MeshVerdict verdict) {
  switch (verdict) {
    case MeshVerdict::embedding: return "embedding";
    case MeshVerdict::invalid_element: return "invalid_element";
    case MeshVerdict::non_manifold: return "non_manifold";
    case MeshVerdict::non_conforming: return "non_conforming";
    case MeshVerdict::folded_vertex: return "folded_vertex";
    case MeshVerdict::overlapping_boundary: return "overlapping_boundary";
    case MeshVerdict::undecided: return "undecided";
  }
  return "";
}

void ObstacleList::add(MeshObstacle obstacle) {
  const auto kind = static_cast<std::size_t>(obstacle.kind);
  ++counts_[kind];
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

bool ObstacleList::empty() const {
  return std::all_of(counts_.begin(), counts_.end(), [](std::size_t count) { return count == 0; });
}

MeshVerdict ObstacleList::verdict() const {
  for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
    if (counts_[kind] > 0) return static_cast<MeshVerdict>(kind);
  }
  return MeshVerdict::embedding;
}

std::string text_of(const Point& point) {
  return "(" + to_decimal(point.x) + ", " + to_decimal(point.y) + ")";
}

std::string node_text(const MeshEdges& edges, std::uint32_t node) {
  const std::string where = text_of(edges.point(node));
  if (!edges.mesh().glued_by_nodes()) return "the point " + where;
  return "node " + std::to_string(edges.mesh().origin().node_number(node)) + " at " + where;
}

std::string elements_text(const Mesh& mesh, const std::vector<std::uint32_t>& elements) {
  constexpr std::size_t listed = 8;
  std::string text = elements.size() == 1 ? "element " : "elements ";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i == listed) return text + " and " + std::to_string(elements.size() - listed) + " more";
    if (i > 0) text += i + 1 == elements.size() ? " and " : ", ";
    text += std::to_string(mesh.origin().number(elements[i]));
  }
  return text;
}

void name_nodes(const MeshEdges& edges, const std::vector<std::uint32_t>& nodes, MeshObstacle& obstacle) {
  for (const std::uint32_t node : nodes) {
    if (edges.mesh().glued_by_nodes()) obstacle.nodes.push_back(node);
    obstacle.points.push_back(edges.point(node));
  }
}

std::string text_of(const DistanceBounds& distance) {
  const std::string lower = to_decimal(to_rational(distance.lower));
  const std::string upper = to_decimal(to_rational(distance.upper));
  return lower == upper ? lower : lower + " to " + upper;
}

}  // namespace bezcert
