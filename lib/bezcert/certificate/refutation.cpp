#include "bezcert/certificate/refutation.hpp"

#include "bezcert/certificate/coverage.hpp"
#include "bezcert/certificate/meet_evidence.hpp"
#include "bezcert/certificate/mesh_evidence.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/mesh/curve_parameters.hpp"
#include "bezcert/mesh/element_frame.hpp"

#include <algorithm>

namespace bezcert {
namespace {

using Refutation = std::optional<std::string>;

class Refuter {
 public:
  Refuter(const Mesh& mesh, const MeshSurface& surface, std::span<const ElementState> claims)
      : edges_(mesh), gluing_(surface.gluing), surface_(surface), coverage_(edges_, claims) {}

  Refutation of(const MeshObstacle& obstacle) {
    std::vector<EdgeUse> uses;
    for (const ElementEdge& edge : obstacle.edges) {
      uses.push_back(edges_.first(edge.element) + static_cast<EdgeUse>(edge.edge));
    }
    switch (obstacle.kind) {
      case MeshVerdict::non_manifold: return uses.empty() ? pinched_vertex(obstacle) : one_side_twice(uses);
      case MeshVerdict::non_conforming: return not_conforming(uses);
      case MeshVerdict::folded_vertex: return folded_vertex(obstacle);
      case MeshVerdict::overlapping_boundary: return uses.empty() ? nested(obstacle) : contact_of_any(uses);
      default: return std::nullopt;
    }
  }

 private:
  std::uint32_t begin(EdgeUse use) const { return gluing_.begin[use]; }
  std::uint32_t end(EdgeUse use) const { return gluing_.end(edges_, use); }

  // Calls attempt(a, b) for pairs of different elements until one succeeds.
  template <class Attempt>
  Refutation any_pair(const std::vector<EdgeUse>& uses, Attempt attempt) {
    constexpr std::size_t most = 16;
    const std::size_t count = std::min(uses.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        if (edges_.element(uses[i]) == edges_.element(uses[j])) continue;
        if (auto found = attempt(uses[i], uses[j])) return found;
      }
    }
    return std::nullopt;
  }

  // Two of the uses have one direction: their elements lie on the same side.
  Refutation one_side_twice(const std::vector<EdgeUse>& uses) {
    return any_pair(uses, [&](EdgeUse a, EdgeUse b) -> Refutation {
      if (begin(a) != begin(b) || end(a) != end(b)) return std::nullopt;
      return coverage_.beside_edge(a, b);
    });
  }

  // The corners at the vertex that an obstacle names.
  std::vector<Fan> fans_at(const MeshObstacle& obstacle) {
    if (obstacle.points.empty()) return {};
    for (const std::uint32_t element : obstacle.elements) {
      for (EdgeUse use = edges_.first(element); use < edges_.first(element + 1); ++use) {
        const bool is_there = obstacle.nodes.empty() ? edges_.point(begin(use)) == obstacle.points[0]
                                                     : begin(use) == obstacle.nodes[0];
        if (is_there) return fans_of(edges_, gluing_, surface_.corners, begin(use));
      }
    }
    return {};
  }

  Refutation pinched_vertex(const MeshObstacle& obstacle) {
    const std::vector<Fan> fans = fans_at(obstacle);
    if (fans.size() < 2) return std::nullopt;
    return "pinch " + edge_name(edges_, fans[0].corners[0]) + ' ' + edge_name(edges_, fans[1].corners[0]);
  }

  Refutation folded_vertex(const MeshObstacle& obstacle) {
    for (const Fan& fan : fans_at(obstacle)) {
      if (auto found = coverage_.around_vertex(fan)) return found;
    }
    return std::nullopt;
  }

  Refutation nested(const MeshObstacle& obstacle) {
    for (const std::uint32_t element : obstacle.elements) {
      if (auto found = coverage_.with_any(element)) return found;
    }
    return std::nullopt;
  }

  Refutation contact_of_any(const std::vector<EdgeUse>& uses) {
    return any_pair(uses, [&](EdgeUse a, EdgeUse b) { return touch(a, b); });
  }

  // A contact is the stronger refutation; else edges are close to each other.
  Refutation not_conforming(const std::vector<EdgeUse>& uses) {
    if (auto found = contact_of_any(uses)) return found;
    if (auto found = any_pair(uses, [&](EdgeUse a, EdgeUse b) { return gap(a, b); })) return found;
    return uses.size() == 3 ? gap_at_node(uses) : std::nullopt;
  }

  Refutation touch(EdgeUse a, EdgeUse b) {
    const bool same_way = begin(a) == begin(b) || end(a) == end(b);
    NamedCurve first{edges_.exact(a), edge_name(edges_, a)}, second{edges_.exact(b), edge_name(edges_, b)};
    const std::uint32_t ends_a[] = {begin(a), end(a)}, ends_b[] = {begin(b), end(b)};
    CommonPlaces common;
    for (const int i : {0, 1}) {
      for (const int j : {0, 1}) common.ends[i][j] = ends_a[i] == ends_b[j];
    }
    // One curve between the same vertices: meant to be glued, or to be on one side of it.
    const bool opposite = common.ends[0][1] && common.ends[1][0],
               equal = common.ends[0][0] && common.ends[1][1];
    if (opposite && same_curve(first.net, reversed(second.net))) return std::nullopt;
    if (equal && same_curve(first.net, second.net)) return std::nullopt;
    if (auto found = meet_at_ends(first, second, common)) return "touch " + *found;
    // find_contact knows of joints of an end and a beginning.
    const auto interval = [&](EdgeUse use) { return edges_.interval(RoundUp(), use); };
    DyadicCurve curve_a(interval(a), first.net);
    DyadicCurve curve_b = same_way ? DyadicCurve(reversed(interval(b)), reversed(second.net))
                                   : DyadicCurve(interval(b), second.net);
    const int b_begin = same_way ? 1 : 0;
    const Joints joints{common.ends[1][b_begin], common.ends[0][1 - b_begin]};
    const ContactResult result = find_contact(curve_a, curve_b, joints);
    if (!result.contact) return std::nullopt;
    Contact contact = *result.contact;
    if (same_way) contact.second = {1 - contact.second.upper, 1 - contact.second.lower};
    const auto found = meet_evidence(first, second, common, contact);
    if (!found) return std::nullopt;
    return "touch " + *found;
  }

  // A crack: edges between the same two vertices, near each other at equal parameters.
  Refutation gap(EdgeUse a, EdgeUse b) {
    if (begin(a) != end(b) || end(a) != begin(b)) return std::nullopt;
    if (!are_close(edges_, a, b)) return std::nullopt;
    const CurveNet<Integer> net_a = edges_.exact(a), net_b = edges_.exact(b);
    // The middle first, where the edges are likely to be farthest apart.
    for (const int k : {8, 4, 12, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15}) {
      const Rational t(k, 16);
      if (!is_off(net_b, point_at(net_a, t))) continue;
      return "gap " + edge_name(edges_, a) + ' ' + edge_name(edges_, b) + ' ' + to_string(t);
    }
    return std::nullopt;
  }

  // A hanging node: the second and the third edge lead back beside the first.
  Refutation gap_at_node(const std::vector<EdgeUse>& uses) {
    const EdgeUse a = uses[0], b = uses[1], c = uses[2];
    if (begin(b) != end(a) || begin(c) != end(b) || end(c) != begin(a)) return std::nullopt;
    if (edges_.element(b) == edges_.element(a) || edges_.element(c) == edges_.element(a)) return std::nullopt;
    const CurveNet<Integer> net_a = edges_.exact(a), net_b = edges_.exact(b), net_c = edges_.exact(c);
    const ElementFrame frame(edges_, a);
    const auto is_beside = [&](const Point& point) { return is_near(frame, net_a, point); };
    const Point node = point_at(net_c, 0);
    const Rational half(1, 2);
    if (!is_beside(node) || !is_beside(point_at(net_b, half)) || !is_beside(point_at(net_c, half)) ||
        !is_off(net_a, node)) {
      return std::nullopt;
    }
    return "gap " + edge_name(edges_, a) + ' ' + edge_name(edges_, b) + ' ' + edge_name(edges_, c);
  }

  MeshEdges edges_;
  const Gluing& gluing_;
  const MeshSurface& surface_;
  Coverage coverage_;
};

}  // namespace

std::optional<std::string> find_refutation(const Mesh& mesh, const MeshResult& result,
                                           std::span<const ElementState> claims) {
  const auto invalid = std::find(claims.begin(), claims.end(), ElementState::invalid);
  if (invalid != claims.end()) return "element " + std::to_string(invalid - claims.begin() + 1);
  Refuter refuter(mesh, *result.surface, claims);
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    if (auto found = refuter.of(obstacle)) return found;
  }
  return std::nullopt;
}

}  // namespace bezcert
