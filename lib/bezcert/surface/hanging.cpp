#include "bezcert/curve/distance.hpp"
#include "bezcert/curve/incidence.hpp"
#include "bezcert/surface/element_frame.hpp"
#include "bezcert/surface/surface.hpp"

#include <algorithm>

namespace bezcert {

// Looks at vertices where two or more boundary edges begin. The short edges begin at an end of the long one
// and run exactly along it; or there are two of them, between its ends, close to it (element_frame.hpp).
class Surface::HangingNodes {
 public:
  HangingNodes(Surface& surface, ObstacleList& obstacles) : surface_(surface), obstacles_(obstacles) {}

  void run() {
    for (std::uint32_t vertex = 0; vertex < surface_.vertex_limit(); ++vertex) {
      // With very many parts at one vertex it is no hanging node, and comparing them all would take long.
      constexpr std::ptrdiff_t many = 32;
      const auto corners = surface_.corners(vertex);
      const auto parts =
          std::count_if(corners.begin(), corners.end(), [&](HalfEdge h) { return is_single(h); });
      if (parts < 2 || parts > many) continue;
      for (const HalfEdge h : leaving(vertex)) look_at(h);
      for (const HalfEdge h : arriving(vertex)) look_at(h);
    }
  }

 private:
  bool is_single(HalfEdge h) const { return surface_.is_boundary(h) && !surface_.is_faulty(h); }

  // Boundary edges that begin, or end, at a vertex.
  std::vector<HalfEdge> leaving(std::uint32_t vertex) const {
    std::vector<HalfEdge> result;
    for (const HalfEdge corner : surface_.corners(vertex)) {
      if (is_single(corner)) result.push_back(corner);
    }
    return result;
  }
  std::vector<HalfEdge> arriving(std::uint32_t vertex) const {
    std::vector<HalfEdge> result;
    for (const HalfEdge corner : surface_.corners(vertex)) {
      const HalfEdge h = surface_.previous(corner);
      if (is_single(h)) result.push_back(h);
    }
    return result;
  }

  std::uint32_t begin(HalfEdge h) const { return surface_.begin(h); }
  std::uint32_t end(HalfEdge h) const { return surface_.end(h); }

  void look_at(HalfEdge h) {
    if (!is_single(h)) return;  // named meanwhile
    const CurveNet<Integer> net = surface_.exact(h);
    std::vector<HalfEdge> chain = edges_along(h, net);
    if (chain.empty()) chain = near_chain(h, net);
    if (!chain.empty()) name_chain(h, net, chain);
  }

  // Whether an edge between points of `net` runs along it: the middle too, as a straight way between two
  // points of a curved edge does not.
  bool runs_along(const CurveNet<Integer>& net, HalfEdge one) const {
    return passes_inside(net, point_at(surface_.exact(one), Rational(1, 2)));
  }

  // Short edges along `h`: from its end towards its beginning as far as they go, and from there on from its
  // beginning. Empty unless there is an inner vertex on it.
  std::vector<HalfEdge> edges_along(HalfEdge h, const CurveNet<Integer>& net) const {
    constexpr std::size_t longest = 256;
    std::vector<HalfEdge> chain;
    const auto fits = [&](HalfEdge one) {
      return surface_.element(one) != surface_.element(h) &&
             std::find(chain.begin(), chain.end(), one) == chain.end() && runs_along(net, one);
    };
    for (std::uint32_t at = end(h); chain.size() < longest;) {
      HalfEdge next = no_half_edge;
      for (const HalfEdge one : leaving(at)) {
        const bool last = end(one) == begin(h);
        if (last && chain.empty()) continue;  // another edge between the same two vertices
        if ((last || passes_inside(net, surface_.point(end(one)))) && fits(one)) next = one;
      }
      if (next == no_half_edge) break;
      chain.push_back(next);
      at = end(next);
      if (at == begin(h)) return chain;
    }
    for (std::uint32_t at = begin(h); chain.size() < longest;) {
      HalfEdge previous = no_half_edge;
      for (const HalfEdge one : arriving(at)) {
        if (passes_inside(net, surface_.point(begin(one))) && fits(one)) previous = one;
      }
      if (previous == no_half_edge) break;
      chain.push_back(previous);
      at = begin(previous);
    }
    return chain;
  }

  // Two edges back with a node near `h`.
  std::vector<HalfEdge> near_chain(HalfEdge h, const CurveNet<Integer>& net) const {
    const ElementFrame frame(surface_, h);
    const auto is_beside = [&](const Point& point) { return is_near(frame, net, point); };
    for (const HalfEdge first : leaving(end(h))) {
      if (end(first) == begin(h) || surface_.element(first) == surface_.element(h)) continue;
      for (const HalfEdge second : leaving(end(first))) {
        if (end(second) != begin(h) || surface_.element(second) == surface_.element(h)) continue;
        // Not the node alone: the short edges run beside the long one.
        if (is_beside(surface_.point(end(first))) &&
            is_beside(point_at(surface_.exact(first), Rational(1, 2))) &&
            is_beside(point_at(surface_.exact(second), Rational(1, 2)))) {
          return {first, second};
        }
      }
    }
    return {};
  }

  void name_chain(HalfEdge h, const CurveNet<Integer>& net, const std::vector<HalfEdge>& chain) {
    surface_.faulty_[h] = true;
    std::vector<std::uint32_t> nodes;  // between the ends of `h`
    for (const HalfEdge one : chain) {
      surface_.faulty_[one] = true;
      if (begin(one) == end(h)) surface_.meant_.emplace_back(h, one);
      if (end(one) == begin(h)) surface_.meant_.emplace_back(one, h);
      for (const std::uint32_t node : {begin(one), end(one)}) {
        const bool inner = node != begin(h) && node != end(h);
        if (inner && std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
      }
    }
    for (const std::uint32_t node : nodes) {
      obstacles_.add(MeshVerdict::non_conforming, [&] { return obstacle(h, net, chain, node); });
    }
  }

  MeshObstacle obstacle(HalfEdge h, const CurveNet<Integer>& net, const std::vector<HalfEdge>& chain,
                        std::uint32_t node) const {
    const bool exactly = passes_inside(net, surface_.point(node));
    MeshObstacle result;
    result.cause = exactly ? Cause::hanging_inside : Cause::hanging_beside;
    result.add_edge(surface_, h);
    for (const HalfEdge one : chain) {
      if (begin(one) == node || end(one) == node) result.add_edge(surface_, one);
    }
    sort_unique(result.elements);
    result.add_node(surface_, node);
    result.distance = exactly ? DistanceBounds{} : distance_bounds(net, surface_.point(node));
    return result;
  }

  Surface& surface_;
  ObstacleList& obstacles_;
};

void Surface::find_hanging_nodes(ObstacleList& obstacles) { HangingNodes(*this, obstacles).run(); }

}  // namespace bezcert
