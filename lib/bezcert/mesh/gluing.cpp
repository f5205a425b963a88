#include "bezcert/mesh/gluing.hpp"

#include "bezcert/curve/same_curve.hpp"
#include "bezcert/mesh/curve_parameters.hpp"
#include "bezcert/mesh/edge_distance.hpp"
#include "bezcert/mesh/element_frame.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace bezcert {
namespace {

// For every corner its node, or the first of the corner nodes at exactly the same point.
std::vector<std::uint32_t> begin_vertices(const MeshEdges& edges) {
  const Mesh& mesh = edges.mesh();
  std::vector<std::uint32_t> result(edges.count());
  for (EdgeUse use = 0; use < edges.count(); ++use) result[use] = edges.begin_node(use);
  if (mesh.glued_by_nodes()) return result;

  std::vector<std::uint32_t> nodes = result;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const bool doubles = mesh.coordinates(0).binary64() && mesh.coordinates(1).binary64();
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    if (doubles) {
      const auto key = [&](std::uint32_t n) {
        return std::pair(mesh.coordinates(0).doubles()[n], mesh.coordinates(1).doubles()[n]);
      };
      return key(a) < key(b) ? -1 : key(b) < key(a) ? 1 : 0;
    }
    const Rational xa = mesh.coordinates(0)[a], xb = mesh.coordinates(0)[b];
    if (xa != xb) return xa < xb ? -1 : 1;
    const Rational ya = mesh.coordinates(1)[a], yb = mesh.coordinates(1)[b];
    return ya < yb ? -1 : ya == yb ? 0 : 1;
  };
  std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int order = compare(a, b);
    return order != 0 ? order < 0 : a < b;
  });
  std::vector<std::uint32_t> vertex(mesh.node_count());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool same = i > 0 && compare(nodes[i - 1], nodes[i]) == 0;
    vertex[nodes[i]] = same ? vertex[nodes[i - 1]] : nodes[i];
  }
  for (std::uint32_t& node : result) node = vertex[node];
  return result;
}

// One use in a group, with its direction: forward leads from the smaller to the larger vertex.
struct Use {
  std::uint32_t smaller = 0, larger = 0;  // vertices
  EdgeUse use = 0;
  bool forward = true;
};

class Gluer {
 public:
  Gluer(const MeshEdges& edges, ObstacleList& obstacles) : edges_(edges), obstacles_(obstacles) {}

  Gluing run() {
    gluing_.begin = begin_vertices(edges_);
    gluing_.twin.assign(edges_.count(), no_edge);
    gluing_.faulty.assign(edges_.count(), false);
    sort_by_smaller_vertex();
    if (!pair_plainly()) {
      for_groups([&](std::span<const Use> uses) {
        if (uses.size() < 2 || (uses.size() == 2 && gluing_.twin[uses[0].use] == uses[1].use)) return;
        for (const Use& use : uses) gluing_.twin[use.use] = no_edge;
        group(uses);
      });
    }
    return std::move(gluing_);
  }

 private:
  std::uint32_t smaller(EdgeUse use) const { return std::min(gluing_.begin[use], gluing_.end(edges_, use)); }

  // A counting sort: linear.
  void sort_by_smaller_vertex() {
    start_.assign(edges_.mesh().node_count() + 2, 0);
    for (EdgeUse use = 0; use < edges_.count(); ++use) ++start_[smaller(use) + 2];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(edges_.count());
    for (EdgeUse use = 0; use < edges_.count(); ++use) sorted_[start_[smaller(use) + 1]++] = use;
  }

  // Calls each(uses) for every pair of vertices; a vertex of a mesh has few edges.
  template <class Each>
  void for_groups(Each each) const {
    std::vector<Use> at_vertex;
    for (std::uint32_t vertex = 0; vertex + 1 < start_.size(); ++vertex) {
      at_vertex.clear();
      for (std::uint32_t i = start_[vertex]; i < start_[vertex + 1]; ++i) {
        const std::uint32_t a = gluing_.begin[sorted_[i]], b = gluing_.end(edges_, sorted_[i]);
        at_vertex.push_back({vertex, std::max(a, b), sorted_[i], a < b});
      }
      std::sort(at_vertex.begin(), at_vertex.end(), [](const Use& a, const Use& b) {
        return std::tie(a.larger, a.use) < std::tie(b.larger, b.use);
      });
      for (auto first = at_vertex.begin(); first != at_vertex.end();) {
        const auto last =
            std::find_if(first, at_vertex.end(), [&](const Use& use) { return use.larger != first->larger; });
        each(std::span<const Use>(first, last));
        first = last;
      }
    }
  }

  void pair(EdgeUse a, EdgeUse b) {
    gluing_.twin[a] = b;
    gluing_.twin[b] = a;
  }

  // Pairs the two uses of every pair of vertices that has two, in opposite directions and through the same
  // nodes; returns whether all are such, or alone. (If not, `for_groups` looks at all again.)
  bool pair_plainly() {
    bool all = true;
    std::vector<std::uint32_t> larger;
    for (std::uint32_t vertex = 0; vertex + 1 < start_.size(); ++vertex) {
      const std::uint32_t begin = start_[vertex], count = start_[vertex + 1] - begin;
      if (count > 32) {  // here all are compared with all
        all = false;
        continue;
      }
      larger.clear();
      for (std::uint32_t i = begin; i < begin + count; ++i) {
        larger.push_back(std::max(gluing_.begin[sorted_[i]], gluing_.end(edges_, sorted_[i])));
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t others = 0, other = 0;
        for (std::uint32_t j = i + 1; j < count; ++j) {
          if (larger[j] != larger[i]) continue;
          ++others;
          other = j;
        }
        if (others == 0) continue;
        const EdgeUse a = sorted_[begin + i], b = sorted_[begin + other];
        if (others == 1 && gluing_.begin[a] != gluing_.begin[b]) {
          pair(a, b);
        } else {
          all = false;
        }
      }
    }
    return keep_plain_pairs() && all;
  }

  // Pairs stay if both run through the same nodes, the ordinary case; returns whether all do. In the order of
  // the elements: by vertices most of the time is waiting for memory.
  bool keep_plain_pairs() {
    bool all = true;
    for (EdgeUse a = 0; a < edges_.count(); ++a) {
      const EdgeUse b = gluing_.twin[a];
      if (b == no_edge || b < a) continue;
      if (edges_.basis(a) == edges_.basis(b) && edges_.nodes(a) == edges_.nodes(b).reversed()) continue;
      gluing_.twin[a] = gluing_.twin[b] = no_edge;
      all = false;
    }
    return all;
  }

  // All uses between two vertices.
  void group(std::span<const Use> uses) {
    // An edge from a vertex to itself: its element is degenerate, and directions mean nothing.
    if (gluing_.begin[uses[0].use] == gluing_.end(edges_, uses[0].use)) return;
    std::vector<std::vector<Use>> classes;
    for (const Use& use : uses) {
      const auto found = std::find_if(classes.begin(), classes.end(),
                                      [&](const auto& one) { return same(one.front(), use); });
      if (found == classes.end()) {
        classes.push_back({use});
      } else {
        found->push_back(use);
      }
    }
    std::vector<Use> single;
    for (const auto& one : classes) {
      if (one.size() == 1) {
        single.push_back(one.front());
      } else if (one.size() == 2 && one[0].forward != one[1].forward) {
        pair(one[0].use, one[1].use);
      } else {
        not_manifold(one);
      }
    }
    if (single.size() == 2 && single[0].forward != single[1].forward && is_crack(single[0], single[1])) {
      not_conforming(single);
    }
  }

  // Two different curves between the same two vertices, with an element on each side: a common edge that went
  // wrong where they are one shape or close to each other, as seen from one of the elements; else boundary.
  bool is_crack(const Use& a, const Use& b) const {
    return are_close(edges_, a.use, b.use) || have_same_image(forward_curve(a), forward_curve(b));
  }

  CurveNet<Integer> forward_curve(const Use& use) const {
    CurveNet<Integer> net = edges_.exact(use.use);
    return use.forward ? net : reversed(net);
  }

  bool same(const Use& a, const Use& b) const {
    if (edges_.basis(a.use) == edges_.basis(b.use)) {
      const EdgeNodes nodes = edges_.nodes(b.use);
      if (edges_.nodes(a.use) == (a.forward == b.forward ? nodes : nodes.reversed())) return true;
    }
    return same_curve(forward_curve(a), forward_curve(b));
  }

  MeshObstacle obstacle(MeshVerdict kind, const std::vector<Use>& uses) {
    constexpr std::size_t named = 100;
    MeshObstacle result;
    result.kind = kind;
    for (const Use& use : uses) {
      gluing_.faulty[use.use] = true;
      if (result.elements.size() == named) continue;
      result.elements.push_back(edges_.element(use.use));
      name_edge(edges_, use.use, result);
    }
    const std::uint32_t a = uses[0].smaller, b = uses[0].larger;
    name_nodes(edges_, {a, b}, result);
    result.message = elements_text(edges_.mesh(), result.elements);
    if (uses.size() > named) result.message += " (" + std::to_string(uses.size()) + " in all)";
    where_ = "the edge from " + node_text(edges_, a) + " to " + node_text(edges_, b);
    return result;
  }

  void not_manifold(const std::vector<Use>& uses) {
    MeshObstacle result = obstacle(MeshVerdict::non_manifold, uses);
    if (uses.size() > 2) {
      result.message += " share " + where_ + ": an edge has two elements at most";
      result.hint = "an element is there twice, or sheets of elements meet as they do in a surface in space";
    } else {
      result.message += " share " + where_ + " and both lie on the same side of it";
      result.hint = "one of them is turned over (a Moebius-like gluing), or an element is there twice";
    }
    obstacles_.add(std::move(result));
  }

  void not_conforming(const std::vector<Use>& uses) {
    gluing_.meant.emplace_back(uses[0].use, uses[1].use);
    gluing_.meant.emplace_back(uses[1].use, uses[0].use);
    MeshObstacle result = obstacle(MeshVerdict::non_conforming, uses);
    if (!obstacles_.wants(result.kind)) return obstacles_.add_unnamed(result.kind);
    const CurveNet<Integer> a = forward_curve(uses[0]), b = forward_curve(uses[1]);
    result.distance = largest_distance(a, b);
    result.message += " have different curves on " + where_ + ", " + text_of(*result.distance) +
                      " apart at most at equal parameters";
    result.hint = have_same_image(a, b)
                      ? "they have one shape, but run through it differently: inner nodes (or "
                        "weights) are placed differently along the edge"
                      : "inner nodes (control points, weights) of the edge differ";
    obstacles_.add(std::move(result));
  }

  // As far as some of their points tell: for a hint.
  static bool have_same_image(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
    constexpr int samples = 16;
    for (int k = 1; k < samples; ++k) {
      const Rational t(k, samples);
      if (!passes_inside(b, point_at(a, t)) || !passes_inside(a, point_at(b, t))) return false;
    }
    return true;
  }

  const MeshEdges& edges_;
  ObstacleList& obstacles_;
  Gluing gluing_;
  std::vector<EdgeUse> sorted_;       // by smaller vertex
  std::vector<std::uint32_t> start_;  // where a vertex's begin, and the end
  std::string where_;
};

}  // namespace

Gluing glue(const MeshEdges& edges, ObstacleList& obstacles) { return Gluer(edges, obstacles).run(); }

CornersByVertex corners_by_vertex(const MeshEdges& edges, const Gluing& gluing) {
  CornersByVertex result;
  result.start.assign(edges.mesh().node_count() + 2, 0);
  for (const std::uint32_t vertex : gluing.begin) ++result.start[vertex + 2];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.corners.resize(edges.count());
  for (EdgeUse use = 0; use < edges.count(); ++use)
    result.corners[result.start[gluing.begin[use] + 1]++] = use;
  result.start.pop_back();
  return result;
}

}  // namespace bezcert
