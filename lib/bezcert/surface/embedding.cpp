#include "bezcert/surface/embedding.hpp"

#include "bezcert/surface/components.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

// One obstacle for all elements of a state: it names the first few.
void list_elements(std::span<const ElementState> states, ElementState state, Cause cause,
                   ObstacleList& obstacles) {
  constexpr std::size_t listed = 10;
  MeshObstacle obstacle;
  obstacle.cause = cause;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    if (states[i] == state && ++obstacle.count <= listed) obstacle.elements.push_back(i);
  }
  const std::size_t count = obstacle.count;
  if (count > 0) obstacles.add(std::move(obstacle), count);
}

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh, std::optional<std::uint32_t> element)
    : obstacles_(element), surface_(std::make_shared<Surface>(mesh, obstacles_)) {
  components_ = find_components(*surface_);
  wide_ = find_wide_fans(*surface_);
  near_ = find_near_edges(*surface_, element, 1000 + 4 * surface_->count());
  is_surface_ = !surface_->has_bad_vertices();
  if (!is_surface_) return;
  loops_ = find_loops(*surface_, components_);
  if (element || !obstacles_.empty()) return;
  for (const BoundaryLoop& loop : loops_) areas_.push_back(plain_loop_area(*surface_, loop));
  characteristics_ = euler_characteristics(*surface_, components_);
}

MeshResult examine_mesh(const Mesh& mesh, std::span<const ElementState> states, const MeshOptions& options) {
  return examine_mesh(MeshTopology(mesh, options.element), states, options.contact);
}

MeshResult examine_mesh(const MeshTopology& topology, std::span<const ElementState> states,
                        const ContactBudget& budget) {
  const auto& [known, shared, components, wide, near, is_surface, loops, areas, characteristics] = topology;
  const Surface& surface = *shared;
  if (states.size() != surface.element_count())
    throw std::invalid_argument("examine_mesh: one state an element");
  MeshResult result;
  result.surface = shared;
  result.obstacles = known;
  result.components = components.count;
  ObstacleList& obstacles = result.obstacles;
  list_elements(states, ElementState::invalid, Cause::not_injective, obstacles);
  list_elements(states, ElementState::open, Cause::not_decided, obstacles);
  const bool all_injective = std::all_of(states.begin(), states.end(),
                                         [](ElementState state) { return state == ElementState::injective; });
  if (all_injective) {
    check_wide_fans(surface, wide, obstacles);
    check_boundary(surface, near, budget, obstacles);
  }
  if (is_surface) {
    result.loops = loops.size();
    result.holes = loops.size() - std::min(loops.size(), components.count);
  }
  std::optional<LoopFacts> facts;
  if (obstacles.empty() && !obstacles.element()) {
    facts.emplace();
    facts->characteristics = characteristics;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      facts->areas.push_back(areas[i] ? *areas[i] : loop_area(surface, loops[i]));
    }
  }
  // Loops that are simple and disjoint tell whether all turns inside are one; else each is looked at.
  if (all_injective && !(facts && facts->extra_turns() == 0)) check_closed_fans(surface, obstacles);
  if (facts && obstacles.empty()) {
    const AreaBounds area = check_components(surface, components, loops, *facts, obstacles);
    if (obstacles.empty()) result.area = area;
  }
  result.verdict = obstacles.verdict();
  return result;
}

}  // namespace bezcert
