#include "surface.hpp"

#include <algorithm>
#include <map>

namespace verifier {

Surface::Surface(const Elements& of) : elements(of) {
  const std::size_t bound = 4 * elements.count();
  if (bound >= none) throw Malformed{"limit: 2^30 elements"};
  vertex.resize(bound), mate.resize(bound, none);
  std::map<Point, Index> points;
  for (std::size_t i = 0; i < elements.count(); ++i) {
    begin_line();  // what is done for every element, or edge, has the limit of a line each time
    const bool by_nodes = elements.is_glued_by_nodes();
    const Element e = by_nodes ? Element{} : elements.element(i);
    for (std::size_t k = 0; k < static_cast<std::size_t>(elements.corner_count(i)); ++k) {
      const Use u = uses.emplace_back(static_cast<Use>(4 * i + k));
      const auto corner = [&] { return element_point(e, edge_place(e.triangle, e.p, e.q, k, 0)); };
      vertex[u] = by_nodes ? elements.edge_node(i, k, 0)
                           : points.emplace(corner(), static_cast<Index>(points.size())).first->second;
    }
  }
}

void Surface::glue() {
  const auto same_nodes = [&](Use u, Use v) {
    const std::size_t n = elements.edge_degree(u / 4, u % 4);
    bool same =
        n == elements.edge_degree(v / 4, v % 4) && elements.lagrange(u / 4) == elements.lagrange(v / 4);
    for (std::size_t k = 0; k <= n && same; ++k)
      same = elements.edge_node(u / 4, u % 4, k) == elements.edge_node(v / 4, v % 4, n - k);
    return same;
  };
  std::vector<std::pair<std::pair<Index, Index>, Use>> sorted;
  for (const Use u : uses) sorted.push_back({std::minmax<Index>({begin(u), end(u)}), u});
  std::sort(sorted.begin(), sorted.end());
  for (auto i = sorted.begin(); i != sorted.end(); ++i) {
    begin_line();
    const Use u = i->second;
    for (auto j = i + 1; j != sorted.end() && j->first == i->first && mate[u] == none; ++j) {
      const Use v = j->second;
      spend(1);
      if (mate[v] == none && opposite(u, v) && (same_nodes(u, v) || one_edge(u, v))) mate[u] = v, mate[v] = u;
    }
  }
}

Use Surface::named(const EdgeName& name) const {
  if (name.element >= elements.count() || name.edge >= elements.corner_count(name.element))
    throw Malformed{"there is no such edge"};
  return static_cast<Use>(4 * name.element) + static_cast<Use>(name.edge);
}

bool Surface::one_edge(Use u, Use v) const {
  return opposite(u, v) && one_curve(curve(u), reversed(curve(v)));
}

}  // namespace verifier
