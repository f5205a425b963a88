#include "bezcert/mesh/embedding.hpp"

#include "bezcert/mesh/components.hpp"
#include "bezcert/mesh/hanging.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

// One obstacle for all elements of a state: it names the first few.
void list_elements(const Mesh& mesh, std::span<const ElementState> states, ElementState state,
                   MeshVerdict kind, const std::string& what, ObstacleList& obstacles) {
  constexpr std::size_t listed = 10;
  MeshObstacle obstacle;
  obstacle.kind = kind;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    if (states[i] == state && ++count <= listed) obstacle.elements.push_back(i);
  }
  if (count == 0) return;
  std::vector<std::uint32_t> shown = obstacle.elements;
  obstacle.message = elements_text(mesh, shown);
  if (count > shown.size()) obstacle.message += " and others, " + std::to_string(count) + " in all,";
  obstacle.message += (count == 1 ? " is " : " are ") + what;
  obstacles.add(std::move(obstacle));
  for (std::size_t more = 1; more < count; ++more) obstacles.add_unnamed(kind);
}

}  // namespace

MeshTopology::MeshTopology(const Mesh& mesh, std::optional<std::uint32_t> element)
    : obstacles_(element),
      edges_(mesh),
      gluing_(glue(edges_, obstacles_)),
      corners_(corners_by_vertex(edges_, gluing_)) {
  find_hanging_nodes(edges_, corners_, gluing_, obstacles_);
  fans_ = link_fans(edges_, gluing_, corners_, obstacles_);
  components_ = find_components(edges_, gluing_);
  wide_ = find_wide_fans(edges_, gluing_, corners_, fans_);
  near_ = find_near_edges(edges_, gluing_, fans_, element, 1000 + 4 * edges_.count());
  is_surface_ = std::find(fans_.bad.begin(), fans_.bad.end(), true) == fans_.bad.end();
  if (!is_surface_) return;
  loops_ = find_loops(edges_, gluing_, fans_, components_);
  if (element || !obstacles_.empty()) return;
  for (const BoundaryLoop& loop : loops_) areas_.push_back(plain_loop_area(edges_, loop));
  characteristics_ = euler_characteristics(edges_, gluing_, corners_, components_);
}

MeshResult examine_mesh(const Mesh& mesh, std::span<const ElementState> states, const MeshOptions& options) {
  if (states.size() != mesh.elements().size())
    throw std::invalid_argument("examine_mesh: one state an element");
  return examine_mesh(MeshTopology(mesh, options.element), states, options);
}

MeshResult examine_mesh(MeshTopology&& topology, std::span<const ElementState> states,
                        const MeshOptions& options) {
  const auto& [known, edges, gluing, corners, fans, components, wide, near, is_surface, loops, areas,
               characteristics] = topology;
  const Mesh& mesh = edges.mesh();
  if (states.size() != mesh.elements().size())
    throw std::invalid_argument("examine_mesh: one state an element");
  MeshResult result;
  ObstacleList& obstacles = result.obstacles;
  obstacles = known;
  result.components = components.count;
  const bool all_injective = std::all_of(states.begin(), states.end(),
                                         [](ElementState state) { return state == ElementState::injective; });
  list_elements(mesh, states, ElementState::invalid, MeshVerdict::invalid_element, "not injective",
                obstacles);
  list_elements(mesh, states, ElementState::open, MeshVerdict::undecided, "not decided", obstacles);
  if (all_injective) {
    check_wide_fans(edges, gluing, corners, wide, obstacles);
    check_boundary(edges, gluing, fans, near, options.contact, obstacles);
  }
  if (is_surface) {
    result.loops = loops.size();
    result.holes = loops.size() - std::min(loops.size(), components.count);
  }
  std::optional<LoopFacts> facts;
  if (obstacles.empty() && !options.element) {
    facts.emplace();
    facts->characteristics = characteristics;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      facts->areas.push_back(areas[i] ? *areas[i] : loop_area(edges, loops[i]));
    }
  }
  // Loops that are simple and disjoint tell whether all turns inside are one; else each is looked at.
  if (all_injective && !(facts && facts->extra_turns() == 0)) {
    check_closed_fans(edges, gluing, corners, fans, obstacles);
  }
  if (facts && obstacles.empty()) {
    const AreaBounds area = check_components(edges, gluing, components, loops, *facts, obstacles);
    if (obstacles.empty()) result.area = area;
  }
  result.verdict = obstacles.verdict();
  result.surface = std::make_shared<MeshSurface>(
      MeshSurface{std::move(topology.gluing_), std::move(topology.corners_), std::move(topology.fans_)});
  return result;
}

}  // namespace bezcert
