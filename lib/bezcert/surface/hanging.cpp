#include "bezcert/surface/hanging.hpp"

#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/distance.hpp"
#include "bezcert/surface/element_frame.hpp"

#include <algorithm>

namespace bezcert {
namespace {

class Search {
 public:
  Search(const MeshEdges& edges, const CornersByVertex& corners, Gluing& gluing, ObstacleList& obstacles)
      : edges_(edges), corners_(corners), gluing_(gluing), obstacles_(obstacles) {}

  void run() {
    for (std::uint32_t vertex = 0; vertex + 1 < corners_.start.size(); ++vertex) {
      // With very many parts at one vertex it is no hanging node, and comparing them all would take long.
      constexpr std::size_t many = 32;
      std::size_t parts = 0;
      for (std::uint32_t i = corners_.start[vertex]; i < corners_.start[vertex + 1]; ++i) {
        if (is_single(corners_.corners[i])) ++parts;
      }
      if (parts < 2 || parts > many) continue;
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
    std::vector<EdgeUse> chain = edges_along(use, net);
    if (chain.empty()) chain = near_chain(use, net);
    if (!chain.empty()) name_chain(use, net, chain);
  }

  // Whether an edge between points of `net` runs along it: the middle too, as a straight way between two
  // points of a curved edge does not.
  bool runs_along(const CurveNet<Integer>& net, EdgeUse one) const {
    return passes_inside(net, point_at(edges_.exact(one), Rational(1, 2)));
  }

  // Short edges along `use`: from its end towards its beginning as far as they go, and from there on from its
  // beginning. Empty unless there is an inner vertex on it.
  std::vector<EdgeUse> edges_along(EdgeUse use, const CurveNet<Integer>& net) const {
    constexpr std::size_t longest = 256;
    std::vector<EdgeUse> chain;
    const auto fits = [&](EdgeUse one) {
      return edges_.element(one) != edges_.element(use) &&
             std::find(chain.begin(), chain.end(), one) == chain.end() && runs_along(net, one);
    };
    for (std::uint32_t at = end(use); chain.size() < longest;) {
      EdgeUse next = no_edge;
      for (const EdgeUse one : leaving(at)) {
        const bool last = end(one) == gluing_.begin[use];
        if (last && chain.empty()) continue;  // another edge between the same two vertices
        if ((last || passes_inside(net, edges_.point(end(one)))) && fits(one)) next = one;
      }
      if (next == no_edge) break;
      chain.push_back(next);
      at = end(next);
      if (at == gluing_.begin[use]) return chain;
    }
    for (std::uint32_t at = gluing_.begin[use]; chain.size() < longest;) {
      EdgeUse previous = no_edge;
      for (const EdgeUse one : arriving(at)) {
        if (passes_inside(net, edges_.point(gluing_.begin[one])) && fits(one)) previous = one;
      }
      if (previous == no_edge) break;
      chain.push_back(previous);
      at = gluing_.begin[previous];
    }
    return chain;
  }

  // Two edges back with a node near `use`.
  std::vector<EdgeUse> near_chain(EdgeUse use, const CurveNet<Integer>& net) const {
    const ElementFrame frame(edges_, use);
    const auto is_beside = [&](const Point& point) { return is_near(frame, net, point); };
    for (const EdgeUse first : leaving(end(use))) {
      if (end(first) == gluing_.begin[use] || edges_.element(first) == edges_.element(use)) continue;
      for (const EdgeUse second : leaving(end(first))) {
        if (end(second) != gluing_.begin[use] || edges_.element(second) == edges_.element(use)) continue;
        // Not the node alone: the short edges run beside the long one.
        if (is_beside(edges_.point(end(first))) && is_beside(point_at(edges_.exact(first), Rational(1, 2))) &&
            is_beside(point_at(edges_.exact(second), Rational(1, 2)))) {
          return {first, second};
        }
      }
    }
    return {};
  }

  void name_chain(EdgeUse use, const CurveNet<Integer>& net, const std::vector<EdgeUse>& chain) {
    gluing_.faulty[use] = true;
    std::vector<std::uint32_t> nodes;  // between the ends of `use`
    for (const EdgeUse one : chain) {
      gluing_.faulty[one] = true;
      if (gluing_.begin[one] == end(use)) gluing_.meant.emplace_back(use, one);
      if (end(one) == gluing_.begin[use]) gluing_.meant.emplace_back(one, use);
      for (const std::uint32_t node : {gluing_.begin[one], end(one)}) {
        const bool inner = node != gluing_.begin[use] && node != end(use);
        if (inner && std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
      }
    }
    for (const std::uint32_t node : nodes) name_node(use, net, chain, node);
  }

  void name_node(EdgeUse use, const CurveNet<Integer>& net, const std::vector<EdgeUse>& chain,
                 std::uint32_t node) {
    if (!obstacles_.wants(MeshVerdict::non_conforming)) {
      return obstacles_.add_unnamed(MeshVerdict::non_conforming);
    }
    MeshObstacle obstacle;
    obstacle.kind = MeshVerdict::non_conforming;
    std::vector<std::uint32_t> neighbours;
    name_edge(edges_, use, obstacle);
    for (const EdgeUse one : chain) {
      if (gluing_.begin[one] != node && end(one) != node) continue;
      name_edge(edges_, one, obstacle);
      neighbours.push_back(edges_.element(one));
    }
    sort_unique(neighbours);
    obstacle.elements = neighbours;
    obstacle.elements.push_back(edges_.element(use));
    sort_unique(obstacle.elements);
    name_nodes(edges_, {node}, obstacle);
    const bool exactly = passes_inside(net, edges_.point(node));
    obstacle.distance = exactly ? DistanceBounds{} : distance_bounds(net, edges_.point(node));
    obstacle.message = node_text(edges_, node) + ", a corner of " + elements_text(edges_.mesh(), neighbours) +
                       (exactly ? ", lies inside edge " : ", lies beside edge ") +
                       std::to_string(edges_.edge(use)) + " of element " +
                       std::to_string(edges_.element_number(use));
    if (!exactly) {
      obstacle.message += ", at most " + to_decimal(to_rational(obstacle.distance->upper)) + " from it";
    }
    obstacle.hint = "a hanging node: split that element there, or remove the node";
    obstacles_.add(std::move(obstacle));
  }

  static void sort_unique(std::vector<std::uint32_t>& elements) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
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
