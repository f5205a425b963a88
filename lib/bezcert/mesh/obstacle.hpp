// What stands in the way of a mesh being an embedding, and where.
#pragma once

#include "bezcert/mesh/mesh_edges.hpp"
#include "bezcert/number/dyadic.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// Of a mesh: `embedding`, or the kind of its first obstacle in this order. `undecided`: a budget ran out
/// somewhere, and nothing else is wrong.
enum class MeshVerdict {
  embedding,
  invalid_element,
  non_manifold,
  non_conforming,
  folded_vertex,
  overlapping_boundary,
  undecided
};

inline constexpr std::size_t mesh_verdict_count = 7;

std::string_view name(MeshVerdict verdict);

/// Proven bounds of a distance.
struct DistanceBounds {
  Dyadic lower, upper;
};

/// Edge `edge` of an element, from its corner of that number to the next.
struct ElementEdge {
  std::uint32_t element = 0;  ///< index into the mesh's elements
  int edge = 0;
};

struct MeshObstacle {
  MeshVerdict kind = MeshVerdict::undecided;
  std::vector<std::uint32_t> elements;  ///< indices into the mesh's elements
  std::vector<ElementEdge> edges;       ///< those that are not as they should be, if it is about edges
  std::vector<std::uint32_t> nodes;     ///< indices into the mesh's nodes; empty if it is glued by points
  std::vector<Point> points;            ///< of the nodes, or where it is; exact
  std::optional<DistanceBounds> distance;
  std::string message;  ///< names the elements, nodes and coordinates
  std::string hint;     ///< the likely cause; may be empty
};

/// The first obstacles of each kind (or the first that name one element), and how many there are.
class ObstacleList {
 public:
  static constexpr std::size_t kept = 20;

  ObstacleList() = default;
  /// Keeps those only that name the element, an index into the mesh's elements; counts all.
  explicit ObstacleList(std::optional<std::uint32_t> element) : element_(element) {}

  /// The element that is asked about, if it is one.
  const std::optional<std::uint32_t>& element() const { return element_; }

  /// Whether one more of the kind might be kept: otherwise its message need not be made.
  bool wants(MeshVerdict kind) const { return element_ || count(kind) < kept; }
  void add(MeshObstacle obstacle);
  /// Counts one that is not kept.
  void add_unnamed(MeshVerdict kind) { ++counts_[static_cast<std::size_t>(kind)]; }

  /// Grouped by kind, in the order of MeshVerdict.
  std::vector<MeshObstacle> all() const;
  std::size_t count(MeshVerdict kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  bool empty() const;
  /// The first kind there is, or embedding.
  MeshVerdict verdict() const;

 private:
  std::array<std::vector<MeshObstacle>, mesh_verdict_count> by_kind_;
  std::array<std::size_t, mesh_verdict_count> counts_{};
  std::optional<std::uint32_t> element_;
};

/// "(0.5, 0.25)": six digits, for people.
std::string text_of(const Point& point);

/// "node 7 at (0.5, 0.25)", or "the point (0.5, 0.25)" in a mesh that is glued by points.
std::string node_text(const MeshEdges& edges, std::uint32_t node);

/// "element 12", "elements 12 and 40", "elements 12, 40 and 41": as the file numbers them.
std::string elements_text(const Mesh& mesh, const std::vector<std::uint32_t>& elements);

/// Adds an edge to an obstacle, without its element.
inline void name_edge(const MeshEdges& edges, EdgeUse use, MeshObstacle& obstacle) {
  obstacle.edges.push_back({edges.element(use), edges.edge(use)});
}

/// Adds nodes with their points to an obstacle.
void name_nodes(const MeshEdges& edges, const std::vector<std::uint32_t>& nodes, MeshObstacle& obstacle);

/// "0.01 to 0.011": for people.
std::string text_of(const DistanceBounds& distance);

}  // namespace bezcert
