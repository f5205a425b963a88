#include "bezcert/surface/boundary_loops.hpp"

#include <algorithm>
#include <limits>

namespace bezcert {

Components find_components(const Surface& surface) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Components result;
  result.of_element.assign(surface.element_count(), none);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < result.of_element.size(); ++seed) {
    if (result.of_element[seed] != none) continue;
    const auto number = static_cast<std::uint32_t>(result.count++);
    result.of_element[seed] = number;
    open.push_back(seed);
    while (!open.empty()) {
      const std::uint32_t element = open.back();
      open.pop_back();
      for (HalfEdge h = surface.first(element); h < surface.first(element + 1); ++h) {
        if (surface.opposite(h) == no_half_edge) continue;
        std::uint32_t& other = result.of_element[surface.element(surface.opposite(h))];
        if (other != none) continue;
        other = number;
        open.push_back(surface.element(surface.opposite(h)));
      }
    }
  }
  return result;
}

std::vector<BoundaryLoop> find_loops(const Surface& surface, const Components& components) {
  std::vector<BoundaryLoop> result;
  std::vector<bool> seen(surface.count(), false);
  for (HalfEdge seed = 0; seed < surface.count(); ++seed) {
    if (!surface.is_boundary(seed) || seen[seed]) continue;
    BoundaryLoop loop;
    loop.component = components.of_element[surface.element(seed)];
    HalfEdge h = seed;
    // `next_boundary` is injective, so a chain returns to its seed or ends; it may have been entered in its
    // middle.
    while (h != no_half_edge && !seen[h]) {
      seen[h] = true;
      loop.edges.push_back(h);
      h = surface.next_boundary(h);
    }
    if (h == seed) result.push_back(std::move(loop));
  }
  return result;
}

std::vector<long> euler_characteristics(const Surface& surface, const Components& components) {
  if (components.count == 1) {  // no need to ask where each belongs
    long vertices = 0, boundary = 0;
    for (std::uint32_t vertex = 0; vertex < surface.vertex_limit(); ++vertex) {
      vertices += surface.corners(vertex).empty() ? 0 : 1;
    }
    for (HalfEdge h = 0; h < surface.count(); ++h) boundary += surface.is_boundary(h) ? 1 : 0;
    const auto half_edges = static_cast<long>(surface.count());
    return {vertices - (half_edges + boundary) / 2 + static_cast<long>(surface.element_count())};
  }
  std::vector<long> result(components.count, 0);
  for (HalfEdge h = 0; h < surface.count(); ++h) {
    const bool counted = surface.is_boundary(h) || h < surface.opposite(h);
    if (counted) --result[components.of_element[surface.element(h)]];
  }
  for (const std::uint32_t component : components.of_element) ++result[component];
  for (std::uint32_t vertex = 0; vertex < surface.vertex_limit(); ++vertex) {
    const auto corners = surface.corners(vertex);
    if (!corners.empty()) ++result[components.of_element[surface.element(corners[0])]];
  }
  return result;
}

}  // namespace bezcert
