// The surface of a mesh: its elements, glued along edges that are one curve in opposite directions.
#pragma once

#include "map.hpp"

namespace verifier {

using Index = std::uint32_t;
using Use = Index;  ///< an edge of an element: 4 * element + edge; also the corner it begins at
constexpr Use none = ~Use{0};

struct Surface {
  const Elements& elements;
  std::vector<Use> uses;      ///< all
  std::vector<Index> vertex;  ///< of corners
  std::vector<Use> mate;      ///< glued to, or none

  /// Nothing is glued.
  explicit Surface(const Elements& of);
  /// Glues edges that are one curve. Any choice is sound: the surface made by it is the one that is embedded.
  void glue();

  Use corners(Use u) const { return static_cast<Use>(elements.corner_count(u / 4)); }
  Use following(Use u) const { return u % 4 + 1 == corners(u) ? u - u % 4 : u + 1; }
  Use preceding(Use u) const { return u % 4 == 0 ? u + corners(u) - 1 : u - 1; }
  /// The use that follows on the boundary, around the vertex across glued edges.
  Use follower(Use u) const {
    while (mate[u = following(u)] != none) u = mate[u];
    return u;
  }
  Index begin(Use u) const { return vertex[u]; }
  Index end(Use u) const { return vertex[following(u)]; }
  Curve curve(Use u) const { return edge_curves(elements.element(u / 4))[u % 4]; }
  /// Throws Malformed if there is no such edge.
  Use named(const EdgeName& name) const;
  /// Whether they lead between the same two vertices in opposite directions.
  bool opposite(Use u, Use v) const { return begin(u) == end(v) && end(u) == begin(v) && begin(u) != end(u); }
  /// Whether that is one edge, by whatever change of the parameter.
  bool one_edge(Use u, Use v) const;
};

}  // namespace verifier
