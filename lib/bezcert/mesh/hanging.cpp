#include "bezcert/mesh/hanging.hpp"

#include "bezcert/mesh/curve_parameters.hpp"
#include "bezcert/mesh/edge_distance.hpp"

#include <algorithm>

namespace bezcert {
namespace {

class Search {
 public:
  Search(const MeshEdges& edges, const CornersByVertex& corners, Gluing& gluing, ObstacleList& obstacles)
      : edges_(edges), corners_(corners), gluing_(gluing), obstacles_(obstacles) {}

  void run() {
    for (std::uint32_t vertex = 0; vertex + 1 < corners_.start.size(); ++vertex) {
      if (leaving(vertex).size() < 2) continue;
      for (const EdgeUse use : leaving(vertex)) look_at(use);
      for (const EdgeUse use : arriving(vertex)) look_at(use);
    }
  }

 private:
  bool is_single(EdgeUse use) const { return gluing_.is_boundary(use) && !gluing_.faulty[use]; }

  // Boundary edges that begin, or end, at a vertex.
  std::vector<EdgeUse> leaving(std::uint32_t vertex) const {
    std::vector<EdgeUse> result;
    for (std::uint32_t i = corners_.start[vertex]; i < corners_.start[vertex + 1]; ++i) {
      if (is_single(corners_.corners[i])) result.push_back(corners_.corners[i]);
    }
    return result;
  }
  std::vector<EdgeUse> arriving(std::uint32_t vertex) const {
    std::vector<EdgeUse> result;
    for (std::uint32_t i = corners_.start[vertex]; i < corners_.start[vertex + 1]; ++i) {
      const EdgeUse use = edges_.previous(corners_.corners[i]);
      if (is_single(use)) result.push_back(use);
    }
    return result;
  }

  std::uint32_t end(EdgeUse use) const { return gluing_.end(edges_, use); }

  void look_at(EdgeUse use) {
    if (!is_single(use)) return;  // named meanwhile
    const CurveNet<Integer> net = edges_.exact(use);
    std::vector<EdgeUse> chain = exact_chain(use, net);
    if (chain.empty()) chain = near_chain(use, net);
    if (!chain.empty()) name_chain(use, net, chain);
  }

  // Edges from the end of `use` back to its beginning, with inner vertices on it.
  std::vector<EdgeUse> exact_chain(EdgeUse use, const CurveNet<Integer>& net) const {
    constexpr std::size_t longest = 256;
    std::vector<EdgeUse> chain;
    std::uint32_t at = end(use);
    while (chain.size() < longest) {
      EdgeUse next = no_edge;
      for (const EdgeUse one : leaving(at)) {
        if (edges_.element(one) == edges_.element(use)) continue;
        if (std::find(chain.begin(), chain.end(), one) != chain.end()) continue;
        const bool last = end(one) == gluing_.begin[use];
        if (last && chain.empty()) continue;  // another edge between the same two vertices
        if (!last && !passes_inside(net, edges_.point(end(one)))) continue;
        // The middle of the short edge too: a straight way between two points of a curved edge is not along
        // it.
        if (!passes_inside(net, point_at(edges_.exact(one), Rational(1, 2)))) continue;
        next = one;
        break;
      }
      if (next == no_edge) return {};
      chain.push_back(next);
      at = end(next);
      if (at == gluing_.begin[use]) return chain;
    }
    return {};
  }

  // Two edges back with a node near `use`.
  std::vector<EdgeUse> near_chain(EdgeUse use, const CurveNet<Integer>& net) const {
    const Point a = edges_.point(gluing_.begin[use]), b = edges_.point(end(use));
    const Rational chord = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
    for (const EdgeUse first : leaving(end(use))) {
      if (end(first) == gluing_.begin[use]) continue;
      for (const EdgeUse second : leaving(end(first))) {
        if (end(second) != gluing_.begin[use]) continue;
        if (edges_.element(first) == edges_.element(use) || edges_.element(second) == edges_.element(use))
          continue;
        const Rational distance = to_rational(distance_bounds(net, edges_.point(end(first))).upper);
        if (distance * distance * 64 <= chord) return {first, second};
      }
    }
    return {};
  }

  void name_chain(EdgeUse use, const CurveNet<Integer>& net, const std::vector<EdgeUse>& chain) {
    gluing_.faulty[use] = true;
    for (const EdgeUse one : chain) gluing_.faulty[one] = true;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (!obstacles_.wants(MeshVerdict::non_conforming)) {
        obstacles_.add_unnamed(MeshVerdict::non_conforming);
        continue;
      }
      const std::uint32_t node = end(chain[i]);
      const bool exactly = passes_inside(net, edges_.point(node));
      MeshObstacle obstacle;
      obstacle.kind = MeshVerdict::non_conforming;
      obstacle.elements = {edges_.element(use), edges_.element(chain[i]), edges_.element(chain[i + 1])};
      std::sort(obstacle.elements.begin(), obstacle.elements.end());
      obstacle.elements.erase(std::unique(obstacle.elements.begin(), obstacle.elements.end()),
                              obstacle.elements.end());
      for (const EdgeUse one : {use, chain[i], chain[i + 1]}) name_edge(edges_, one, obstacle);
      name_nodes(edges_, {node}, obstacle);
      obstacle.distance = exactly ? DistanceBounds{} : distance_bounds(net, edges_.point(node));
      const std::vector<std::uint32_t> neighbours = {edges_.element(chain[i]), edges_.element(chain[i + 1])};
      obstacle.message =
          node_text(edges_, node) + ", a corner of " + elements_text(edges_.mesh(), neighbours) +
          (exactly ? ", lies inside edge " : ", lies beside edge ") + std::to_string(edges_.edge(use)) +
          " of element " + std::to_string(edges_.element_number(use));
      if (!exactly) {
        obstacle.message += ", at most " + to_decimal(to_rational(obstacle.distance->upper)) + " from it";
      }
      obstacle.hint = "a hanging node: split that element there, or remove the node";
      obstacles_.add(std::move(obstacle));
    }
  }

  const MeshEdges& edges_;
  const CornersByVertex& corners_;
  Gluing& gluing_;
  ObstacleList& obstacles_;
};

}  // namespace

void find_hanging_nodes(const MeshEdges& edges, const CornersByVertex& corners, Gluing& gluing,
                        ObstacleList& obstacles) {
  Search(edges, corners, gluing, obstacles).run();
}

}  // namespace bezcert
