#include "bezcert/surface/turns.hpp"

#include "bezcert/curve/branches.hpp"

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

struct Tangent {
  HalfEdge h;
  End end;
};

class TurnCounter {
 public:
  explicit TurnCounter(const Surface& surface) : surface_(surface) {}

  // The number of sectors at each vertex that hold +x: of a closed fan, its full turns. Element by
  // element, as memory has them: a sector's ends are the tangents of its own element.
  std::vector<std::uint32_t> turns() const {
    std::vector<std::uint32_t> result(surface_.vertex_limit(), 0);
    for (std::size_t element = 0; element < surface_.element_count(); ++element) {
      const HalfEdge first = surface_.first(element), last = surface_.first(element + 1) - 1;
      Side arriving = side_of_x({last, End::end});
      for (HalfEdge h = first; h <= last; ++h) {
        if (passes(side_of_x({h, End::begin}), arriving)) ++result[surface_.begin(h)];
        if (h != last) arriving = side_of_x({h, End::end});
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
    sides.push_back(side_of_tangent(first, {surface_.previous(fan.corners.back()), End::end}));
    int passed = 0;
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) passed += passes(sides[k], sides[k + 1]) ? 1 : 0;
    if (passed > 1) return 1;
    return sides.back() == Side::along ? 0 : -1;
  }

 private:
  int coordinate_sign(Tangent t, int coordinate) const {
    const auto pick = [&](const auto& v) { return std::tuple(coordinate == 0 ? v.x : v.y); };
    return filtered_sign(
        Filter::on, [](const auto& value) { return value; },
        [&] { return surface_.double_tangent(t.h, t.end, coordinate); },
        [&](const RoundUp& up) { return pick(surface_.interval_tangent(up, t.h, t.end)); },
        [&] { return pick(surface_.exact_tangent(t.h, t.end)); });
  }
  Side side_of_x(Tangent tangent) const {
    const int y = coordinate_sign(tangent, 1);
    return side_of(y, y != 0 ? 0 : coordinate_sign(tangent, 0));
  }

  Side side_of_tangent(Tangent reference, Tangent tangent) const {
    const auto sign_of = [&](auto expression) {
      return filtered_sign(
          Filter::on, expression,
          [&](const RoundUp& up) {
            return std::tuple(surface_.interval_tangent(up, reference.h, reference.end),
                              surface_.interval_tangent(up, tangent.h, tangent.end));
          },
          [&] {
            return std::tuple(surface_.exact_tangent(reference.h, reference.end),
                              surface_.exact_tangent(tangent.h, tangent.end));
          });
    };
    const int turn = sign_of([](const auto& r, const auto& t) { return cross(r, t); });
    return side_of(turn, turn != 0 ? 0 : sign_of([](const auto& r, const auto& t) { return dot(r, t); }));
  }

  const Surface& surface_;
};

MeshObstacle folded(const Surface& surface, Cause cause, std::uint32_t vertex) {
  MeshObstacle result;
  result.cause = cause;
  const std::vector<Fan> fans = surface.fans(vertex);
  for (const HalfEdge corner : fans.front().corners) result.add_element(surface.element(corner));
  result.add_node(surface, vertex);
  return result;
}

}  // namespace

std::vector<WideFan> find_wide_fans(const Surface& surface) {
  const TurnCounter counter(surface);
  std::vector<WideFan> result;
  for (std::uint32_t vertex = 0; vertex < surface.vertex_limit(); ++vertex) {
    if (!surface.is_open(vertex) || surface.is_bad(vertex)) continue;
    const int more = counter.compare_with_turn(surface.fans(vertex).front());
    if (more >= 0) result.push_back({vertex, more > 0});
  }
  return result;
}

void check_wide_fans(const Surface& surface, std::span<const WideFan> wide, ObstacleList& obstacles) {
  for (const auto& [vertex, more] : wide) {
    if (more) {
      obstacles.add(folded(surface, Cause::more_than_one_turn, vertex));
      continue;
    }
    // The edge that leaves must be left of the one that arrives, seen from the vertex. (Where they run along
    // each other the boundary is not simple: another obstacle.)
    const Fan fan = surface.fans(vertex).front();
    const HalfEdge leaving = fan.corners.front(), arriving = surface.previous(fan.corners.back());
    if (compare_branches(surface.exact(leaving), reversed(surface.exact(arriving))) <= 0) continue;
    obstacles.add(folded(surface, Cause::sliver_covered_twice, vertex));
  }
}

void check_closed_fans(const Surface& surface, ObstacleList& obstacles) {
  const std::vector<std::uint32_t> turns = TurnCounter(surface).turns();
  for (std::uint32_t vertex = 0; vertex < surface.vertex_limit(); ++vertex) {
    if (surface.corners(vertex).empty() || surface.is_bad(vertex) || surface.is_open(vertex)) continue;
    if (turns[vertex] == 1) continue;
    MeshObstacle obstacle = folded(surface, Cause::several_turns, vertex);
    obstacle.count = turns[vertex];
    obstacles.add(std::move(obstacle));
  }
}

}  // namespace bezcert
