#include "bezcert/certificate/coverage.hpp"

#include "bezcert/algebra/real_root.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/curve/separation.hpp"
#include "bezcert/curve/winding.hpp"

#include <algorithm>
#include <cmath>

namespace bezcert {
namespace {

// Halvings of an edge: half of what a checker takes.
constexpr int deepest = 2048;

// The point of the smallest denominators within `distance` in x and y.
Point simplest_near(const Point& point, const Rational& distance) {
  return {simplest_between(point.x - distance, point.x + distance),
          simplest_between(point.y - distance, point.y + distance)};
}

std::string cover_text(std::uint32_t a, std::uint32_t b, const Point& point) {
  return "cover " + std::to_string(a + std::size_t{1}) + ' ' + std::to_string(b + std::size_t{1}) + ' ' +
         to_string(point.x) + ' ' + to_string(point.y);
}

// From the beginning of the curve, in true lengths.
Vector2<Rational> tangent_of(const CurveNet<Integer>& net) {
  const Vector2<Integer> d = between(net, 0, net, 1);
  const Integer scale = net.w[0] * net.w[1];
  return {Rational(d.x, scale), Rational(d.y, scale)};
}

Rational size_of(const Vector2<Rational>& v) { return std::max(Rational(abs(v.x)), Rational(abs(v.y))); }

Point moved(const Point& point, const Vector2<Rational>& along, const Rational& factor) {
  return {point.x + along.x * factor, point.y + along.y * factor};
}

// Grows with the angle of a vector, by signs and one division: the same everywhere.
Rational angle_of(const Vector2<Rational>& v) {
  const Rational slope = v.y / (abs(v.x) + abs(v.y));
  if (v.x.sign() >= 0) return slope;
  return v.y.sign() >= 0 ? 2 - slope : -2 - slope;
}

Box box_of_edges(const HalfEdges& edges, std::uint32_t element) {
  const RoundUp up;
  Box box = edges.box(up, edges.first(element));
  for (HalfEdge h = edges.first(element) + 1; h < edges.first(element + 1); ++h) box.add(edges.box(up, h));
  return box;
}

}  // namespace

// No box of control points of a piece holds the point, when pieces are small enough.
bool is_off(const CurveNet<Integer>& curve, const Point& point) {
  DyadicCurve pieces(std::nullopt, curve);
  const auto box_holds = [&](const CurveNet<Integer>& net) {
    const auto is_inside = [&](const std::vector<Integer>& values, const Rational& at) {
      const Integer p = numerator(at), q = denominator(at);
      bool below = false, above = false;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const int sign = (values[i] * q).compare(p * net.w[i]);
        below = below || sign <= 0;
        above = above || sign >= 0;
      }
      return below && above;
    };
    return is_inside(net.x, point.x) && is_inside(net.y, point.y);
  };
  std::vector<DyadicCurve::Piece> open = {DyadicCurve::whole};
  while (!open.empty()) {
    const DyadicCurve::Piece piece = open.back();
    open.pop_back();
    if (!box_holds(pieces.exact(piece))) continue;
    if (pieces.depth(piece) == deepest) return false;
    const auto [first, second] = pieces.halves(piece);
    open.push_back(first);
    open.push_back(second);
  }
  return true;
}

bool Coverage::covers(std::uint32_t element, const Point& point) const {
  if (claims_[element] != ElementState::injective) return false;
  const HalfEdge first = edges_.first(element), end = edges_.first(element + 1);
  std::vector<DyadicCurve> boundary;
  for (HalfEdge h = first; h < end; ++h) boundary.push_back(edges_.curve(h));
  if (winding_number(boundary, point, deepest) != 1) return false;
  for (DyadicCurve& curve : boundary) {
    if (!is_off(curve.exact(DyadicCurve::whole), point)) return false;
  }
  return true;
}

std::optional<Point> Coverage::left_of(HalfEdge h, const std::function<bool(const Point&)>& accepts) const {
  const CurveNet<Integer> half = part_of(edges_.exact(h), Rational(1, 2), 1);
  const Vector2<Rational> along = tangent_of(half);
  const Vector2<Rational> left{-along.y, along.x};
  const Point middle{Rational(half.x[0], half.w[0]), Rational(half.y[0], half.w[0])};
  // Nearer and nearer, at last in leaps: overlaps may be very thin.
  for (long k = 1; k <= 1024; k += k < 32 ? 1 : k) {
    const Rational step = power_of_two(-k);
    const Point point = simplest_near(moved(middle, left, step), size_of(left) * step / 4);
    if (accepts(point)) return point;
  }
  return std::nullopt;
}

std::optional<std::string> Coverage::beside_edge(HalfEdge a, HalfEdge b) const {
  const std::uint32_t first = edges_.element(a), second = edges_.element(b);
  if (first == second) return std::nullopt;
  const auto point = left_of(a, [&](const Point& p) { return covers(first, p) && covers(second, p); });
  if (!point) return std::nullopt;
  return cover_text(first, second, *point);
}

std::optional<std::string> Coverage::with_any(std::uint32_t element) const {
  for (HalfEdge h = edges_.first(element); h < edges_.first(element + 1); ++h) {
    const auto inside = left_of(h, [&](const Point& p) { return covers(element, p); });
    if (!inside) continue;
    const Interval x = to_interval(inside->x), y = to_interval(inside->y);
    const Box at{x.inf(), x.sup(), y.inf(), y.sup()};
    for (std::uint32_t other = 0; other < edges_.element_count(); ++other) {
      if (other == element) continue;
      // A point inside is left of some edge and right of another, or level with an edge.
      if (box_of_edges(edges_, other).overlaps(at) && covers(other, *inside))
        return cover_text(element, other, *inside);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Coverage::around_vertex(const Fan& fan) const {
  const Point vertex = point_at(edges_.exact(fan.corners[0]), 0);
  std::vector<Vector2<Rational>> tangents;
  for (const HalfEdge corner : fan.corners) tangents.push_back(tangent_of(edges_.exact(corner)));
  if (!fan.closed)
    tangents.push_back(tangent_of(reversed(edges_.exact(edges_.previous(fan.corners.back())))));
  // Between neighbouring tangents, wherever two corners lie on each other: the sum of unit vectors, about.
  std::vector<std::pair<Rational, Vector2<Rational>>> directions;
  for (const Vector2<Rational>& v : tangents) directions.emplace_back(angle_of(v), v);
  std::sort(directions.begin(), directions.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto is_in_corner = [&](std::size_t corner, const Vector2<Rational>& v) {
    const Vector2<Rational>&from = tangents[corner], &to = tangents[(corner + 1) % tangents.size()];
    return cross(from, v).sign() > 0 && cross(v, to).sign() > 0;
  };
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector2<Rational>&from = directions[i].second, &to = directions[(i + 1) % directions.size()].second;
    const Rational from_size = size_of(from), to_size = size_of(to);
    const Vector2<Rational> middle{from.x / from_size + to.x / to_size, from.y / from_size + to.y / to_size};
    std::vector<std::uint32_t> elements;
    for (std::size_t corner = 0; corner < fan.corners.size(); ++corner) {
      if (is_in_corner(corner, middle)) elements.push_back(edges_.element(fan.corners[corner]));
    }
    if (elements.size() < 2) continue;
    // The rounding must keep the direction between the two tangents.
    const Rational width = abs(cross(from, to)) / (from_size * to_size) / 8;
    constexpr int tries = 40;
    Rational step = std::min(from_size, to_size) / 2;
    for (int k = 0; k < tries; ++k, step /= 2) {
      const Point point = simplest_near(moved(vertex, middle, step), step * width);
      std::vector<std::uint32_t> covering;
      for (const std::uint32_t element : elements) {
        if (covers(element, point)) covering.push_back(element);
        if (covering.size() == 2 && covering[0] != covering[1])
          return cover_text(covering[0], covering[1], point);
      }
    }
  }
  if (fan.closed) return std::nullopt;
  return in_sliver(fan.corners.front(), edges_.previous(fan.corners.back()));
}

// Both edges leave the vertex in one direction, and the sliver between them is covered from both sides:
// halfway from a point of the first to the point of the second that is as far along the tangent.
std::optional<std::string> Coverage::in_sliver(HalfEdge leaving, HalfEdge arriving) const {
  const std::uint32_t first = edges_.element(leaving), second = edges_.element(arriving);
  if (first == second) return std::nullopt;
  const CurveNet<Integer> a = edges_.exact(leaving), b = reversed(edges_.exact(arriving));
  const Point vertex = point_at(a, 0);
  const Vector2<Rational> tangent = tangent_of(a);
  const auto distance = [&](const Point& p) {
    return dot(tangent, Vector2<Rational>{p.x - vertex.x, p.y - vertex.y});
  };
  constexpr int tries = 24, halvings = 60;
  Rational s(1, 2);
  for (int k = 0; k < tries; ++k, s /= 2) {
    const Point p = point_at(a, s);
    const Rational wanted = distance(p);
    Rational low = 0, high = 1;
    for (int i = 0; i < halvings; ++i) {
      const Rational middle = (low + high) / 2;
      (distance(point_at(b, middle)) < wanted ? low : high) = middle;
    }
    const Point q = point_at(b, low);
    const Rational apart = std::max(Rational(abs(p.x - q.x)), Rational(abs(p.y - q.y)));
    const Point point = simplest_near({(p.x + q.x) / 2, (p.y + q.y) / 2}, apart / 16);
    if (covers(first, point) && covers(second, point)) return cover_text(first, second, point);
  }
  return std::nullopt;
}

}  // namespace bezcert
