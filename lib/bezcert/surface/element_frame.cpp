#include "bezcert/surface/element_frame.hpp"

#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/same_curve.hpp"

namespace bezcert {
namespace {

Vector2<Rational> difference(const Point& p, const Point& q) { return {q.x - p.x, q.y - p.y}; }

}  // namespace

ElementFrame::ElementFrame(const HalfEdges& edges, HalfEdge h) {
  const MeshElement& element = edges.mesh().elements()[edges.element(h)];
  const Point origin = edges.point(edges.begin_node(h));
  along_ = difference(origin, edges.point(edges.begin_node(edges.next(h))));
  for (std::size_t i = 0; i < coefficient_count(element.shape); ++i) {
    const auto to = difference(origin, edges.point(edges.mesh().connectivity()[element.first_node + i]));
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

bool are_close(const HalfEdges& edges, HalfEdge a, HalfEdge b) {
  const CurveNet<Integer> net_a = edges.exact(a), net_b = reversed(edges.exact(b));
  const ElementFrame frame_a(edges, a), frame_b(edges, b);
  bool small_a = true, small_b = true;
  constexpr int samples = 16;
  for (int i = 1; i < samples && (small_a || small_b); ++i) {
    const Rational t(i, samples);
    const Point p = point_at(net_a, t), q = point_at(net_b, t);
    small_a = small_a && frame_a.is_small(p, q);
    small_b = small_b && frame_b.is_small(p, q);
  }
  return small_a || small_b;
}

bool is_near(const ElementFrame& frame, const CurveNet<Integer>& edge, const Point& point) {
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i) {
    if (frame.is_small(point, point_at(edge, Rational(i, samples)))) return true;
  }
  return false;
}

}  // namespace bezcert
