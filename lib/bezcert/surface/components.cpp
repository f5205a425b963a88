#include "bezcert/surface/components.hpp"

#include "bezcert/curve/box.hpp"
#include "bezcert/curve/winding.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

class ComponentCheck {
 public:
  ComponentCheck(const Surface& surface, const Components& components, const std::vector<BoundaryLoop>& loops,
                 const LoopFacts& facts, ObstacleList& obstacles)
      : surface_(surface), components_(components), loops_(loops), facts_(facts), obstacles_(obstacles) {
    loops_of_.resize(components.count);
    for (std::size_t i = 0; i < loops.size(); ++i) loops_of_[loops[i].component].push_back(i);
  }

  AreaBounds run() {
    AreaBounds result;
    outer_.assign(components_.count, 0);
    std::vector<std::size_t> outer_loops(components_.count, 0);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const LoopArea& area = facts_.areas[i];
      result += area.bounds;
      if (area.orientation < 0) continue;
      ++outer_loops[loops_[i].component];
      outer_[loops_[i].component] = i;
    }
    for (std::uint32_t component = 0; component < components_.count; ++component) {
      const auto genus_0 =
          facts_.characteristics[component] == 2 - static_cast<long>(loops_of_[component].size());
      if (outer_loops[component] == 1 && genus_0) continue;
      throw std::logic_error("component " + std::to_string(component + 1) + " of the mesh has " +
                             std::to_string(outer_loops[component]) +
                             " outer loops, against a theorem: a defect of bezcert");
    }
    check_pairs();
    return result;
  }

 private:
  // Two components overlap if and only if the outer loop of one lies in the other (docs/mesh.md): one vertex
  // tells.
  void check_pairs() {
    if (components_.count < 2) return;
    for (const BoundaryLoop& loop : loops_) loop_boxes_.push_back(loop_box(loop));
    std::vector<Box> boxes;
    for (std::size_t component = 0; component < components_.count; ++component) {
      boxes.push_back(loop_boxes_[outer_[component]]);
    }
    for_overlapping_boxes(boxes, [&](std::size_t a, std::size_t b) {
      if (!is_inside(a, b)) is_inside(b, a);
      return obstacles_.wants(MeshVerdict::overlapping_boundary);
    });
  }

  Box loop_box(const BoundaryLoop& loop) {
    const RoundUp up;
    std::vector<Box>& each = edge_boxes_.emplace_back();
    for (const HalfEdge h : loop.edges) each.push_back(surface_.box(up, h));
    Box box = each[0];
    for (const Box& other : each) box.add(other);
    return box;
  }

  // Whether the outer loop of `inner` lies in `outer`; then it is an obstacle.
  bool is_inside(std::size_t inner, std::size_t outer) {
    const HalfEdge there = loops_[outer_[inner]].edges[0];
    const std::uint32_t vertex = surface_.begin(there);
    const Point point = surface_.point(vertex);
    int winding = 0;
    const Interval x = to_interval(point.x), y = to_interval(point.y);
    for (const std::size_t loop : loops_of_[outer]) {
      // Around a point outside its box a loop does not run, and an edge above, below or left of it misses the
      // ray.
      const Box& whole = loop_boxes_[loop];
      if (whole.y_low > y.sup() || whole.y_high < y.inf() || whole.x_low > x.sup() || whole.x_high < x.inf())
        continue;
      for (std::size_t i = 0; i < loops_[loop].edges.size(); ++i) {
        const Box& box = edge_boxes_[loop][i];
        if (box.y_low > y.sup() || box.y_high < y.inf() || box.x_high < x.inf()) continue;
        const HalfEdge h = loops_[loop].edges[i];
        DyadicCurve curve = surface_.curve(h);
        const std::optional<int> share = winding_share(curve, point);
        if (!share) {
          MeshObstacle open;
          open.cause = Cause::nesting_open;
          open.components = {inner, outer};
          obstacles_.add(std::move(open));
          return false;
        }
        winding += *share;
      }
    }
    if (winding == 0) return false;
    MeshObstacle result;
    result.cause = Cause::nested;
    result.components = {inner, outer};
    result.elements = {surface_.element(there), surface_.element(loops_[outer_[outer]].edges[0])};
    result.add_node(surface_, vertex);
    obstacles_.add(std::move(result));
    return true;
  }

  const Surface& surface_;
  const Components& components_;
  const std::vector<BoundaryLoop>& loops_;
  const LoopFacts& facts_;
  ObstacleList& obstacles_;
  std::vector<std::vector<std::size_t>> loops_of_;
  std::vector<Box> loop_boxes_;
  std::vector<std::vector<Box>> edge_boxes_;  // of each loop
  std::vector<std::size_t> outer_;            // the counter-clockwise loop of each component
};

}  // namespace

long LoopFacts::extra_turns() const {
  long result = 0;
  for (const LoopArea& area : areas) result += area.orientation;
  for (const long characteristic : characteristics) result -= characteristic;
  return result;
}

AreaBounds check_components(const Surface& surface, const Components& components,
                            const std::vector<BoundaryLoop>& loops, const LoopFacts& facts,
                            ObstacleList& obstacles) {
  return ComponentCheck(surface, components, loops, facts, obstacles).run();
}

}  // namespace bezcert
