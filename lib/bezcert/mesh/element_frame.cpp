#include "bezcert/mesh/element_frame.hpp"

namespace bezcert {
namespace {

Vector2<Rational> difference(const Point& p, const Point& q) { return {q.x - p.x, q.y - p.y}; }

}  // namespace

ElementFrame::ElementFrame(const MeshEdges& edges, EdgeUse use) {
  const MeshElement& element = edges.mesh().elements[edges.element(use)];
  const Point origin = edges.point(edges.begin_node(use));
  along_ = difference(origin, edges.point(edges.begin_node(edges.next(use))));
  for (std::size_t i = 0; i < coefficient_count(element.shape); ++i) {
    const auto to = difference(origin, edges.point(edges.mesh().connectivity[element.first_node + i]));
    const Rational area = cross(along_, to);
    if (abs(area) <= abs(area_)) continue;
    area_ = area;
    across_ = to;
  }
}

bool ElementFrame::is_small(const Point& p, const Point& q) const {
  if (area_.is_zero()) return false;
  const Vector2<Rational> d = difference(p, q);
  const Rational limit = abs(area_) / 8;
  return abs(cross(d, across_)) <= limit && abs(cross(along_, d)) <= limit;
}

}  // namespace bezcert
