// What stands in the way of a mesh being an embedding, and where. Causes are typed here; their words are made
// in report/obstacle_text.hpp.
#pragma once

#include "bezcert/curve/contact_result.hpp"
#include "bezcert/curve/distance.hpp"
#include "bezcert/surface/element_edge.hpp"
#include "bezcert/verdict/mesh_verdict.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace bezcert {

class HalfEdges;

/// What is wrong, as it was found. With each: its kind, and what the obstacle holds beside elements and
/// (where there are any) edges, nodes and points.
enum class Cause {
  // invalid_element, undecided. `elements`: the first ten; `count` of all.
  not_injective,
  not_decided,
  // non_manifold. An edge: nodes are its ends, `count` half-edges, of which a hundred are named.
  too_many_elements,  ///< an edge of more than two elements
  one_side,           ///< both elements of an edge lie on the same side of it
  pinched_vertex,     ///< `count` parts touch in a node only; one element of each part
  // non_conforming. An edge: nodes are its ends; `distance` at equal parameters.
  crack,               ///< its two sides are different curves
  crack_in_one_shape,  ///< they have one shape, but different parameters
  // non_conforming. A node inside a long edge, at `distance` from it, and the short edges that end there.
  hanging_inside,     ///< on the first of `edges`, which tears the elements around a vertex apart
  hanging_beside,     ///< near the first of `edges`, the same
  hanging_on_border,  ///< on the last of `edges`, a boundary edge, which boundary edges run along
  hanging_in_gap,     ///< between the ends of the first of `edges`: a hole of three edges that is not open
  // folded_vertex. The elements around a node.
  more_than_one_turn,    ///< at the boundary
  sliver_covered_twice,  ///< one full turn, at the boundary
  several_turns,         ///< `count` of them, inside
  // overlapping_boundary. Two edges.
  unmerged_edges,  ///< one curve, but not one edge
  unmerged_nodes,  ///< two nodes of theirs are one point
  edges_meet,      ///< in a point, at the parameters `at` of the two; points[0] is about there
  edges_overlap,   ///< the same, along a piece
  nested,  ///< the first of `components` lies inside the second; an element of each, a node of the first
  // undecided.
  contact_open,  ///< whether two edges meet; `exceeded`
  nesting_open,  ///< whether the first of `components` lies inside the second
};

/// The kind of verdict that a cause leads to.
MeshVerdict kind_of(Cause cause);

struct MeshObstacle {
  Cause cause = Cause::not_decided;
  std::vector<std::uint32_t> elements;  ///< indices into the mesh's elements
  std::vector<ElementEdge> edges;       ///< those that are not as they should be, if it is about edges
  std::vector<std::uint32_t> nodes;     ///< indices into the mesh's nodes; empty if it is glued by points
  std::vector<Point> points;            ///< of the nodes, or where it is; exact
  std::optional<DistanceBounds> distance;
  std::size_t count = 0;
  std::array<ParameterRange, 2> at;
  std::array<std::size_t, 2> components{};  ///< numbered from 0
  std::optional<ExceededBits> exceeded;

  MeshVerdict kind() const { return kind_of(cause); }
  /// Adds an edge and its element.
  void add_edge(const HalfEdges& half_edges, HalfEdge h);
  /// Adds an element, unless it is named already or a hundred are.
  void add_element(std::uint32_t element);
  /// Adds a node (a vertex of the surface) with its point.
  void add_node(const HalfEdges& half_edges, std::uint32_t node);
};

/// Sorts indices and drops those that are there already.
void sort_unique(std::vector<std::uint32_t>& indices);

/// The first obstacles of each kind (or the first that name one element), and how many there are.
class ObstacleList {
 public:
  static constexpr std::size_t kept = 20;

  ObstacleList() = default;
  /// Keeps those only that name the element, an index into the mesh's elements; counts all.
  explicit ObstacleList(std::optional<std::uint32_t> element) : element_(element) {}

  /// The element that is asked about, if it is one.
  const std::optional<std::uint32_t>& element() const { return element_; }

  /// Whether one more of the kind might be kept: otherwise it need not be made (distances take long).
  bool wants(MeshVerdict kind) const { return element_ || count(kind) < kept; }
  /// Adds one that stands for so many.
  void add(MeshObstacle obstacle, std::size_t count = 1);
  /// Counts one of the kind, and adds make() if it might be kept.
  template <class Make>
  void add(MeshVerdict kind, Make make) {
    if (wants(kind)) return add(make());
    ++counts_[static_cast<std::size_t>(kind)];
  }

  /// Grouped by kind, in the order of MeshVerdict.
  std::vector<MeshObstacle> all() const;
  std::size_t count(MeshVerdict kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  bool empty() const { return verdict() == MeshVerdict::embedding; }
  /// The first kind there is, or embedding.
  MeshVerdict verdict() const;

 private:
  std::array<std::vector<MeshObstacle>, mesh_verdict_count> by_kind_;
  std::array<std::size_t, mesh_verdict_count> counts_{};
  std::optional<std::uint32_t> element_;
};

}  // namespace bezcert
