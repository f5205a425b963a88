#include "bezcert/surface/boundary_loops.hpp"

#include <algorithm>
#include <limits>

namespace bezcert {

Components find_components(const MeshEdges& edges, const Gluing& gluing) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Components result;
  result.of_element.assign(edges.element_count(), none);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < result.of_element.size(); ++seed) {
    if (result.of_element[seed] != none) continue;
    const auto number = static_cast<std::uint32_t>(result.count++);
    result.of_element[seed] = number;
    open.push_back(seed);
    while (!open.empty()) {
      const std::uint32_t element = open.back();
      open.pop_back();
      for (EdgeUse use = edges.first(element); use < edges.first(element + 1); ++use) {
        if (gluing.twin[use] == no_edge) continue;
        std::uint32_t& other = result.of_element[edges.element(gluing.twin[use])];
        if (other != none) continue;
        other = number;
        open.push_back(edges.element(gluing.twin[use]));
      }
    }
  }
  return result;
}

std::vector<BoundaryLoop> find_loops(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
                                     const Components& components) {
  std::vector<BoundaryLoop> result;
  std::vector<bool> seen(edges.count(), false);
  for (EdgeUse seed = 0; seed < edges.count(); ++seed) {
    if (!gluing.is_boundary(seed) || seen[seed]) continue;
    BoundaryLoop loop;
    loop.component = components.of_element[edges.element(seed)];
    EdgeUse use = seed;
    // `next_boundary` is injective, so a chain returns to its seed or ends; it may have been entered in its
    // middle.
    while (use != no_edge && !seen[use]) {
      seen[use] = true;
      loop.uses.push_back(use);
      use = fans.next_boundary[use];
    }
    if (use == seed) result.push_back(std::move(loop));
  }
  return result;
}

std::vector<long> euler_characteristics(const MeshEdges& edges, const Gluing& gluing,
                                        const CornersByVertex& corners, const Components& components) {
  const auto is_used = [&](std::size_t vertex) { return corners.start[vertex] != corners.start[vertex + 1]; };
  const std::size_t vertices = corners.start.size() - 1;
  if (components.count == 1) {  // no need to ask where each belongs
    long used = 0;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) used += is_used(vertex) ? 1 : 0;
    const auto uses = static_cast<long>(edges.count());
    const auto boundary = static_cast<long>(std::count(gluing.twin.begin(), gluing.twin.end(), no_edge));
    return {used - (uses + boundary) / 2 + static_cast<long>(edges.element_count())};
  }
  std::vector<long> result(components.count, 0);
  for (EdgeUse use = 0; use < edges.count(); ++use) {
    const bool counted = gluing.is_boundary(use) || use < gluing.twin[use];
    if (counted) --result[components.of_element[edges.element(use)]];
  }
  for (const std::uint32_t component : components.of_element) ++result[component];
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    if (!is_used(vertex)) continue;
    ++result[components.of_element[edges.element(corners.corners[corners.start[vertex]])]];
  }
  return result;
}

}  // namespace bezcert
