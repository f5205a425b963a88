#include "bezcert/mesh/vertex_fans.hpp"

#include "bezcert/curve/same_curve.hpp"
#include "bezcert/mesh/branches.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace bezcert {
namespace {

// Where a direction lies relative to a reference direction: along it, to its left, opposite, to its right.
enum class Side { along, left, opposite, right };

Side side_of(int cross_sign, int dot_sign) {
  if (cross_sign != 0) return cross_sign > 0 ? Side::left : Side::right;
  return dot_sign > 0 ? Side::along : Side::opposite;
}

// Whether a sector [d, e) of less than half a turn holds the reference direction: d is along it, or the
// sector leads from its right to its left.
bool passes(Side d, Side e) { return d == Side::along || (d == Side::right && e == Side::left); }

// The corners of the fan that holds `corner`: how many, the first and the last of them (of a closed one any).
struct FanEnds {
  std::size_t count = 0;
  EdgeUse first = no_edge, last = no_edge;
  bool closed = false;
};

FanEnds fan_around(const MeshEdges& edges, const Gluing& gluing, EdgeUse corner) {
  FanEnds fan{1, corner, corner, false};
  for (;; ++fan.count) {  // counter-clockwise
    const EdgeUse across = gluing.twin[edges.previous(fan.last)];
    if (across == no_edge) break;
    if (across == corner) {
      fan.closed = true;
      return fan;
    }
    fan.last = across;
  }
  for (; gluing.twin[fan.first] != no_edge; ++fan.count) fan.first = edges.next(gluing.twin[fan.first]);
  return fan;
}

struct Tangent {
  EdgeUse use;
  End end;
};

class TurnCounter {
 public:
  explicit TurnCounter(const MeshEdges& edges) : edges_(edges) {}

  // The number of sectors at each vertex that hold +x: of a closed fan, its full turns. Element by
  // element, as memory has them: a sector's ends are the tangents of its own element.
  std::vector<std::uint32_t> turns(const Gluing& gluing) const {
    std::vector<std::uint32_t> result(edges_.mesh().node_count(), 0);
    for (std::size_t element = 0; element < edges_.element_count(); ++element) {
      const EdgeUse first = edges_.first(element), last = edges_.first(element + 1) - 1;
      Side arriving = side_of_x({last, End::end});
      for (EdgeUse use = first; use <= last; ++use) {
        if (passes(side_of_x({use, End::begin}), arriving)) ++result[gluing.begin[use]];
        if (use != last) arriving = side_of_x({use, End::end});
      }
    }
    return result;
  }

  // Compares the angle of an open fan with a full turn: -1, 0, 1. The reference is its first direction.
  int compare_with_turn(const Fan& fan) const {
    if (fan.corners.size() < 3) return -1;  // each corner has less than half a turn
    const Tangent first{fan.corners.front(), End::begin};
    std::vector<Side> sides = {Side::along};
    for (std::size_t k = 1; k < fan.corners.size(); ++k) {
      sides.push_back(side_of_tangent(first, {fan.corners[k], End::begin}));
    }
    sides.push_back(side_of_tangent(first, {edges_.previous(fan.corners.back()), End::end}));
    int passed = 0;
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) passed += passes(sides[k], sides[k + 1]) ? 1 : 0;
    if (passed > 1) return 1;
    return sides.back() == Side::along ? 0 : -1;
  }

 private:
  Side side_of_x(Tangent tangent) const {
    if (const auto y = edges_.tangent_sign(tangent.use, tangent.end, 1)) {
      if (*y != 0) return side_of(*y, 0);
      if (const auto x = edges_.tangent_sign(tangent.use, tangent.end, 0)) return side_of(0, *x);
    }
    const Vector2<Interval> t = edges_.interval_tangent(tangent.use, tangent.end);
    if (const auto y = certain_sign(t.y)) {
      if (*y != 0) return side_of(*y, 0);
      if (const auto x = certain_sign(t.x)) return side_of(0, *x);
    }
    const Vector2<Integer> exact = edges_.exact_tangent(tangent.use, tangent.end);
    return side_of(exact.y.sign(), exact.x.sign());
  }

  Side side_of_tangent(Tangent reference, Tangent tangent) const {
    {
      const Vector2<Interval> r = edges_.interval_tangent(reference.use, reference.end);
      const Vector2<Interval> t = edges_.interval_tangent(tangent.use, tangent.end);
      if (const auto turn = certain_sign(cross(r, t))) {
        if (*turn != 0) return side_of(*turn, 0);
        if (const auto forward = certain_sign(dot(r, t))) return side_of(0, *forward);
      }
    }
    const Vector2<Integer> r = edges_.exact_tangent(reference.use, reference.end);
    const Vector2<Integer> t = edges_.exact_tangent(tangent.use, tangent.end);
    return side_of(cross(r, t).sign(), dot(r, t).sign());
  }

  const MeshEdges& edges_;
  RoundingScope scope_;
};

MeshObstacle vertex_obstacle(const MeshEdges& edges, MeshVerdict kind, std::uint32_t vertex,
                             const std::vector<EdgeUse>& corners) {
  constexpr std::size_t named = 100;
  MeshObstacle result;
  result.kind = kind;
  for (const EdgeUse corner : corners) {
    const std::uint32_t element = edges.element(corner);
    const bool known =
        std::find(result.elements.begin(), result.elements.end(), element) != result.elements.end();
    if (!known && result.elements.size() < named) result.elements.push_back(element);
  }
  name_nodes(edges, {vertex}, result);
  result.message = elements_text(edges.mesh(), result.elements);
  return result;
}

void add_folded(const MeshEdges& edges, std::uint32_t vertex, const Fan& fan, const std::string& what,
                ObstacleList& obstacles) {
  MeshObstacle obstacle = vertex_obstacle(edges, MeshVerdict::folded_vertex, vertex, fan.corners);
  obstacle.message += what + node_text(edges, vertex);
  obstacle.hint = "the elements are fine one by one, but lie on each other around that node";
  obstacles.add(std::move(obstacle));
}

std::vector<EdgeUse> corners_at(const CornersByVertex& corners, std::uint32_t vertex) {
  return {corners.corners.begin() + corners.start[vertex],
          corners.corners.begin() + corners.start[vertex + 1]};
}

// Whether the fans of a vertex at which faulty edges end are several parts, even if the edges that were meant
// to be glued join them. A faulty edge without a partner may belong anywhere: then nothing is said.
bool is_pinched(const MeshEdges& edges, const Gluing& gluing, const std::map<EdgeUse, EdgeUse>& meant,
                const std::vector<Fan>& fans) {
  std::vector<std::size_t> part(fans.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  std::vector<bool> leaves_alone(fans.size(), true);
  for (std::size_t i = 0; i < fans.size(); ++i) {
    const EdgeUse arriving = edges.previous(fans[i].corners.back());
    if (fans[i].closed || !gluing.faulty[arriving]) continue;
    const auto partner = meant.find(arriving);
    if (partner == meant.end()) return false;
    for (std::size_t j = 0; j < fans.size(); ++j) {
      if (fans[j].corners.front() != partner->second) continue;
      leaves_alone[j] = false;
      std::replace(part.begin(), part.end(), part[i], part[j]);
    }
  }
  for (std::size_t j = 0; j < fans.size(); ++j) {
    if (!fans[j].closed && gluing.faulty[fans[j].corners.front()] && leaves_alone[j]) return false;
  }
  return std::any_of(part.begin(), part.end(), [&](std::size_t one) { return one != part[0]; });
}

}  // namespace

std::vector<Fan> fans_of(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                         std::uint32_t vertex) {
  const std::vector<EdgeUse> all = corners_at(corners, vertex);  // ascending
  std::vector<bool> seen(all.size(), false);
  std::vector<Fan> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (seen[i]) continue;
    const EdgeUse seed = all[i];
    // Clockwise to where the fan begins; all around if it does not.
    EdgeUse begin = seed;
    while (gluing.twin[begin] != no_edge) {
      begin = edges.next(gluing.twin[begin]);
      if (begin == seed) break;
    }
    Fan fan;
    for (EdgeUse corner = begin;;) {
      fan.corners.push_back(corner);
      seen[static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), corner) - all.begin())] = true;
      const EdgeUse across = gluing.twin[edges.previous(corner)];
      if (across == no_edge) break;
      corner = across;
      if (corner == begin) {
        fan.closed = true;
        break;
      }
    }
    result.push_back(std::move(fan));
  }
  return result;
}

Fans link_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
               ObstacleList& obstacles) {
  Fans result;
  const std::size_t vertices = edges.mesh().node_count();
  result.next_boundary.assign(edges.count(), no_edge);
  result.open.assign(vertices, false);
  result.bad.assign(vertices, false);
  for (EdgeUse use = 0; use < edges.count(); ++use) {
    if (gluing.faulty[use]) result.bad[gluing.begin[use]] = result.bad[gluing.end(edges, use)] = true;
  }
  const std::map<EdgeUse, EdgeUse> meant(gluing.meant.begin(), gluing.meant.end());
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    if (corners.start[vertex] == corners.start[vertex + 1]) continue;
    const FanEnds one = fan_around(edges, gluing, corners.corners[corners.start[vertex]]);
    if (one.count == corners.start[vertex + 1] - corners.start[vertex]) {
      if (one.closed) continue;
      result.open[vertex] = true;
      const EdgeUse arriving = edges.previous(one.last);
      if (!gluing.faulty[arriving] && !gluing.faulty[one.first]) result.next_boundary[arriving] = one.first;
      continue;
    }
    const std::vector<Fan> fans = fans_of(edges, gluing, corners, vertex);
    for (const Fan& fan : fans) {
      const EdgeUse arriving = edges.previous(fan.corners.back());
      if (fan.closed || gluing.faulty[arriving] || gluing.faulty[fan.corners.front()]) continue;
      result.next_boundary[arriving] = fan.corners.front();
    }
    if (result.bad[vertex] && !is_pinched(edges, gluing, meant, fans)) continue;
    result.bad[vertex] = true;
    if (!obstacles.wants(MeshVerdict::non_manifold)) {
      obstacles.add_unnamed(MeshVerdict::non_manifold);
      continue;
    }
    // One element of each fan: they are what meets there.
    std::vector<EdgeUse> first_of_each;
    for (const Fan& fan : fans) {
      first_of_each.push_back(*std::min_element(fan.corners.begin(), fan.corners.end()));
    }
    MeshObstacle obstacle = vertex_obstacle(edges, MeshVerdict::non_manifold, vertex, first_of_each);
    obstacle.message += " belong to " + std::to_string(fans.size()) + " parts that touch only in " +
                        node_text(edges, vertex) + ": a pinched vertex";
    obstacle.hint =
        "parts that touch in one point; give each part a node of its own and move them apart, or join "
        "them by an edge";
    obstacles.add(std::move(obstacle));
  }
  return result;
}

std::vector<WideFan> find_wide_fans(const MeshEdges& edges, const Gluing& gluing,
                                    const CornersByVertex& corners, const Fans& fans) {
  const TurnCounter counter(edges);
  std::vector<WideFan> result;
  for (std::uint32_t vertex = 0; vertex < fans.bad.size(); ++vertex) {
    if (!fans.open[vertex] || fans.bad[vertex]) continue;
    const int more = counter.compare_with_turn(fans_of(edges, gluing, corners, vertex).front());
    if (more >= 0) result.push_back({vertex, more > 0});
  }
  return result;
}

void check_wide_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                     const std::vector<WideFan>& wide, ObstacleList& obstacles) {
  for (const auto& [vertex, more] : wide) {
    const Fan fan = fans_of(edges, gluing, corners, vertex).front();
    if (more) {
      add_folded(edges, vertex, fan, " make more than one full turn around the boundary vertex ", obstacles);
      continue;
    }
    // The edge that leaves must be left of the one that arrives, seen from the vertex. (Where they run along
    // each other the boundary is not simple: another obstacle.)
    const EdgeUse leaving = fan.corners.front(), arriving = edges.previous(fan.corners.back());
    if (compare_branches(edges.exact(leaving), reversed(edges.exact(arriving))) <= 0) continue;
    add_folded(edges, vertex, fan, " make one full turn and cover a sliver twice at the boundary vertex ",
               obstacles);
  }
}

void check_closed_fans(const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners,
                       const Fans& fans, ObstacleList& obstacles) {
  const std::vector<std::uint32_t> turns = TurnCounter(edges).turns(gluing);
  for (std::uint32_t vertex = 0; vertex < fans.bad.size(); ++vertex) {
    if (corners.start[vertex] == corners.start[vertex + 1] || fans.bad[vertex] || fans.open[vertex]) continue;
    if (turns[vertex] == 1) continue;
    add_folded(edges, vertex, fans_of(edges, gluing, corners, vertex).front(),
               " wind " + std::to_string(turns[vertex]) + " times around ", obstacles);
  }
}

}  // namespace bezcert
