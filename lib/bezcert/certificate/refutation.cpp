#include "bezcert/certificate/refutation.hpp"

#include "bezcert/certificate/coverage.hpp"
#include "bezcert/certificate/meet_evidence.hpp"
#include "bezcert/certificate/mesh_evidence.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/surface/element_frame.hpp"

#include <algorithm>

namespace bezcert {
namespace {

using Refutation = std::optional<std::string>;

class Refuter {
 public:
  Refuter(const Surface& surface, std::span<const ElementState> claims)
      : surface_(surface), coverage_(surface, claims) {}

  Refutation of(const MeshObstacle& obstacle) {
    std::vector<HalfEdge> edges;
    for (const ElementEdge& edge : obstacle.edges) edges.push_back(surface_.half_edge(edge));
    switch (obstacle.kind()) {
      case MeshVerdict::non_manifold: return edges.empty() ? pinched_vertex(obstacle) : one_side_twice(edges);
      case MeshVerdict::non_conforming: return not_conforming(edges);
      case MeshVerdict::folded_vertex: return folded_vertex(obstacle);
      case MeshVerdict::overlapping_boundary: return edges.empty() ? nested(obstacle) : contact_of_any(edges);
      default: return std::nullopt;
    }
  }

 private:
  std::uint32_t begin(HalfEdge h) const { return surface_.begin(h); }
  std::uint32_t end(HalfEdge h) const { return surface_.end(h); }

  // Calls attempt(a, b) for pairs of different elements until one succeeds.
  template <class Attempt>
  Refutation any_pair(const std::vector<HalfEdge>& edges, Attempt attempt) {
    constexpr std::size_t most = 16;
    const std::size_t count = std::min(edges.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        if (surface_.element(edges[i]) == surface_.element(edges[j])) continue;
        if (auto found = attempt(edges[i], edges[j])) return found;
      }
    }
    return std::nullopt;
  }

  // Two of the half-edges have one direction: their elements lie on the same side.
  Refutation one_side_twice(const std::vector<HalfEdge>& edges) {
    return any_pair(edges, [&](HalfEdge a, HalfEdge b) -> Refutation {
      if (begin(a) != begin(b) || end(a) != end(b)) return std::nullopt;
      return coverage_.beside_edge(a, b);
    });
  }

  // The corners at the vertex that an obstacle names.
  std::vector<Fan> fans_at(const MeshObstacle& obstacle) {
    if (obstacle.points.empty()) return {};
    for (const std::uint32_t element : obstacle.elements) {
      for (HalfEdge h = surface_.first(element); h < surface_.first(element + 1); ++h) {
        const bool is_there = obstacle.nodes.empty() ? surface_.point(begin(h)) == obstacle.points[0]
                                                     : begin(h) == obstacle.nodes[0];
        if (is_there) return surface_.fans(begin(h));
      }
    }
    return {};
  }

  Refutation pinched_vertex(const MeshObstacle& obstacle) {
    const std::vector<Fan> fans = fans_at(obstacle);
    if (fans.size() < 2) return std::nullopt;
    return "pinch " + edge_name(surface_, fans[0].corners[0]) + ' ' + edge_name(surface_, fans[1].corners[0]);
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

  Refutation contact_of_any(const std::vector<HalfEdge>& edges) {
    return any_pair(edges, [&](HalfEdge a, HalfEdge b) { return touch(a, b); });
  }

  // A contact is the stronger refutation; else edges are close to each other.
  Refutation not_conforming(const std::vector<HalfEdge>& edges) {
    if (auto found = contact_of_any(edges)) return found;
    if (auto found = any_pair(edges, [&](HalfEdge a, HalfEdge b) { return gap(a, b); })) return found;
    return edges.size() == 3 ? gap_at_node(edges) : std::nullopt;
  }

  Refutation touch(HalfEdge a, HalfEdge b) {
    const bool same_way = begin(a) == begin(b) || end(a) == end(b);
    NamedCurve first{surface_.exact(a), edge_name(surface_, a)},
        second{surface_.exact(b), edge_name(surface_, b)};
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
    const auto interval = [&](HalfEdge h) { return surface_.interval(RoundUp(), h); };
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
  Refutation gap(HalfEdge a, HalfEdge b) {
    if (begin(a) != end(b) || end(a) != begin(b)) return std::nullopt;
    if (!are_close(surface_, a, b)) return std::nullopt;
    const CurveNet<Integer> net_a = surface_.exact(a), net_b = surface_.exact(b);
    // The middle first, where the edges are likely to be farthest apart.
    for (const int k : {8, 4, 12, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15}) {
      const Rational t(k, 16);
      if (!is_off(net_b, point_at(net_a, t))) continue;
      return "gap " + edge_name(surface_, a) + ' ' + edge_name(surface_, b) + ' ' + to_string(t);
    }
    return std::nullopt;
  }

  // A hanging node: the second and the third edge lead back beside the first.
  Refutation gap_at_node(const std::vector<HalfEdge>& edges) {
    const HalfEdge a = edges[0], b = edges[1], c = edges[2];
    if (begin(b) != end(a) || begin(c) != end(b) || end(c) != begin(a)) return std::nullopt;
    if (surface_.element(b) == surface_.element(a) || surface_.element(c) == surface_.element(a))
      return std::nullopt;
    const CurveNet<Integer> net_a = surface_.exact(a), net_b = surface_.exact(b), net_c = surface_.exact(c);
    const ElementFrame frame(surface_, a);
    const auto is_beside = [&](const Point& point) { return is_near(frame, net_a, point); };
    const Point node = point_at(net_c, 0);
    const Rational half(1, 2);
    if (!is_beside(node) || !is_beside(point_at(net_b, half)) || !is_beside(point_at(net_c, half)) ||
        !is_off(net_a, node)) {
      return std::nullopt;
    }
    return "gap " + edge_name(surface_, a) + ' ' + edge_name(surface_, b) + ' ' + edge_name(surface_, c);
  }

  const Surface& surface_;
  Coverage coverage_;
};

}  // namespace

std::optional<std::string> find_refutation(const MeshResult& result, std::span<const ElementState> claims) {
  const auto invalid = std::find(claims.begin(), claims.end(), ElementState::invalid);
  if (invalid != claims.end()) return "element " + std::to_string(invalid - claims.begin() + 1);
  Refuter refuter(*result.surface, claims);
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    if (auto found = refuter.of(obstacle)) return found;
  }
  return std::nullopt;
}

}  // namespace bezcert
