#include "bezcert/curve/distance.hpp"
#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/surface/element_frame.hpp"
#include "bezcert/surface/surface.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace bezcert {
namespace {

// For every corner its node, or the first of the corner nodes at exactly the same point.
std::vector<std::uint32_t> begin_vertices(const HalfEdges& edges) {
  const Mesh& mesh = edges.mesh();
  std::vector<std::uint32_t> result(edges.count());
  for (HalfEdge h = 0; h < edges.count(); ++h) result[h] = edges.begin_node(h);
  if (mesh.glued_by_nodes()) return result;

  std::vector<std::uint32_t> nodes = result;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int order = edges.compare_points(a, b);
    return order != 0 ? order < 0 : a < b;
  });
  std::vector<std::uint32_t> vertex(mesh.coordinates(0).size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool same = i > 0 && edges.compare_points(nodes[i - 1], nodes[i]) == 0;
    vertex[nodes[i]] = same ? vertex[nodes[i - 1]] : nodes[i];
  }
  for (std::uint32_t& node : result) node = vertex[node];
  return result;
}

}  // namespace

class Surface::Gluer {
 public:
  Gluer(Surface& surface, ObstacleList& obstacles) : surface_(surface), obstacles_(obstacles) {}

  void run() {
    surface_.begin_ = begin_vertices(surface_);
    surface_.opposite_.assign(surface_.count(), no_half_edge);
    surface_.faulty_.assign(surface_.count(), false);
    sort_by_smaller_vertex();
    if (pair_plainly()) return;
    for_groups([&](std::span<const Side> sides) {
      if (sides.size() < 2 || (sides.size() == 2 && surface_.opposite(sides[0].h) == sides[1].h)) return;
      for (const Side& side : sides) surface_.opposite_[side.h] = no_half_edge;
      group(sides);
    });
  }

 private:
  // A half-edge in a group, with its direction: forward leads from the smaller to the larger vertex.
  struct Side {
    std::uint32_t smaller = 0, larger = 0;  // vertices
    HalfEdge h = 0;
    bool forward = true;
  };

  std::uint32_t smaller(HalfEdge h) const { return std::min(surface_.begin(h), surface_.end(h)); }

  // A counting sort: linear.
  void sort_by_smaller_vertex() {
    start_.assign(surface_.mesh().coordinates(0).size() + 2, 0);
    for (HalfEdge h = 0; h < surface_.count(); ++h) ++start_[smaller(h) + 2];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(surface_.count());
    for (HalfEdge h = 0; h < surface_.count(); ++h) sorted_[start_[smaller(h) + 1]++] = h;
  }

  // Calls each(sides) for every pair of vertices; a vertex of a mesh has few edges.
  template <class Each>
  void for_groups(Each each) const {
    std::vector<Side> at_vertex;
    for (std::uint32_t vertex = 0; vertex + 1 < start_.size(); ++vertex) {
      at_vertex.clear();
      for (std::uint32_t i = start_[vertex]; i < start_[vertex + 1]; ++i) {
        const std::uint32_t a = surface_.begin(sorted_[i]), b = surface_.end(sorted_[i]);
        at_vertex.push_back({vertex, std::max(a, b), sorted_[i], a < b});
      }
      std::sort(at_vertex.begin(), at_vertex.end(), [](const Side& a, const Side& b) {
        return std::tie(a.larger, a.h) < std::tie(b.larger, b.h);
      });
      for (auto first = at_vertex.begin(); first != at_vertex.end();) {
        const auto last = std::find_if(first, at_vertex.end(),
                                       [&](const Side& side) { return side.larger != first->larger; });
        each(std::span<const Side>(first, last));
        first = last;
      }
    }
  }

  void pair(HalfEdge a, HalfEdge b) {
    surface_.opposite_[a] = b;
    surface_.opposite_[b] = a;
  }

  // Pairs the two half-edges of every pair of vertices that has two, in opposite directions and through the
  // same nodes; returns whether all are such, or alone. (If not, `for_groups` looks at all again.)
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
        larger.push_back(std::max(surface_.begin(sorted_[i]), surface_.end(sorted_[i])));
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t others = 0, other = 0;
        for (std::uint32_t j = i + 1; j < count; ++j) {
          if (larger[j] != larger[i]) continue;
          ++others;
          other = j;
        }
        if (others == 0) continue;
        const HalfEdge a = sorted_[begin + i], b = sorted_[begin + other];
        if (others == 1 && surface_.begin(a) != surface_.begin(b)) {
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
    for (HalfEdge a = 0; a < surface_.count(); ++a) {
      const HalfEdge b = surface_.opposite_[a];
      if (b == no_half_edge || b < a) continue;
      if (surface_.basis(a) == surface_.basis(b) && surface_.nodes(a) == surface_.nodes(b).reversed())
        continue;
      surface_.opposite_[a] = surface_.opposite_[b] = no_half_edge;
      all = false;
    }
    return all;
  }

  // All half-edges between two vertices.
  void group(std::span<const Side> sides) {
    // An edge from a vertex to itself: its element is degenerate, and directions mean nothing.
    if (surface_.begin(sides[0].h) == surface_.end(sides[0].h)) return;
    std::vector<std::vector<Side>> classes;
    for (const Side& side : sides) {
      const auto found = std::find_if(classes.begin(), classes.end(),
                                      [&](const auto& one) { return same(one.front(), side); });
      if (found == classes.end()) {
        classes.push_back({side});
      } else {
        found->push_back(side);
      }
    }
    std::vector<Side> single;
    for (const auto& one : classes) {
      if (one.size() == 1) {
        single.push_back(one.front());
      } else if (one.size() == 2 && one[0].forward != one[1].forward) {
        pair(one[0].h, one[1].h);
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
  bool is_crack(const Side& a, const Side& b) const {
    return are_close(surface_, a.h, b.h) || have_same_image(forward_curve(a), forward_curve(b));
  }

  CurveNet<Integer> forward_curve(const Side& side) const {
    CurveNet<Integer> net = surface_.exact(side.h);
    return side.forward ? net : reversed(net);
  }

  bool same(const Side& a, const Side& b) const {
    if (surface_.basis(a.h) == surface_.basis(b.h)) {
      const EdgeNodes nodes = surface_.nodes(b.h);
      if (surface_.nodes(a.h) == (a.forward == b.forward ? nodes : nodes.reversed())) return true;
    }
    return same_curve(forward_curve(a), forward_curve(b));
  }

  MeshObstacle obstacle(Cause cause, const std::vector<Side>& sides) const {
    constexpr std::size_t named = 100;
    MeshObstacle result;
    result.cause = cause;
    result.count = sides.size();
    for (const Side& side : sides) {
      if (result.elements.size() < named) result.add_edge(surface_, side.h);
    }
    result.add_node(surface_, sides[0].smaller);
    result.add_node(surface_, sides[0].larger);
    return result;
  }

  void mark_faulty(const std::vector<Side>& sides) {
    for (const Side& side : sides) surface_.faulty_[side.h] = true;
  }

  void not_manifold(const std::vector<Side>& sides) {
    mark_faulty(sides);
    obstacles_.add(obstacle(sides.size() > 2 ? Cause::too_many_elements : Cause::one_side, sides));
  }

  void not_conforming(const std::vector<Side>& sides) {
    mark_faulty(sides);
    surface_.meant_.emplace_back(sides[0].h, sides[1].h);
    surface_.meant_.emplace_back(sides[1].h, sides[0].h);
    obstacles_.add(MeshVerdict::non_conforming, [&] {
      const CurveNet<Integer> a = forward_curve(sides[0]), b = forward_curve(sides[1]);
      MeshObstacle result = obstacle(have_same_image(a, b) ? Cause::crack_in_one_shape : Cause::crack, sides);
      result.distance = largest_distance(a, b);
      return result;
    });
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

  Surface& surface_;
  ObstacleList& obstacles_;
  std::vector<HalfEdge> sorted_;      // by smaller vertex
  std::vector<std::uint32_t> start_;  // where a vertex's begin, and the end
};

void Surface::glue(ObstacleList& obstacles) { Gluer(*this, obstacles).run(); }

}  // namespace bezcert
