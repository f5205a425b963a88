#include "bezcert/surface/domain.hpp"

#include "bezcert/surface/surface.hpp"
#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/same_curve.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// Vertices in the order of their points, to find those at a point.
class VertexIndex {
 public:
  explicit VertexIndex(const Surface& surface) : surface_(surface) {
    for (std::uint32_t vertex = 0; vertex < surface.vertex_limit(); ++vertex) {
      if (!surface.corners(vertex).empty()) vertices_.push_back(vertex);
    }
    std::sort(vertices_.begin(), vertices_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const int order = surface.compare_points(a, b);
      return order != 0 ? order < 0 : a < b;
    });
  }

  std::vector<std::uint32_t> at(const Point& point) const {
    const auto first = std::partition_point(vertices_.begin(), vertices_.end(), [&](std::uint32_t vertex) {
      const Point p = surface_.point(vertex);
      return p.x != point.x ? p.x < point.x : p.y < point.y;
    });
    std::vector<std::uint32_t> result;
    for (auto it = first; it != vertices_.end() && surface_.point(*it) == point; ++it) result.push_back(*it);
    return result;
  }

 private:
  const Surface& surface_;
  std::vector<std::uint32_t> vertices_;
};

// A mesh edge at a vertex, led away from it.
struct Departure {
  HalfEdge h = no_half_edge;
  bool forward = true;
  std::uint32_t to = 0;
};

class DomainCheck {
 public:
  explicit DomainCheck(const Surface& surface) : surface_(surface), index_(surface) {}

  std::optional<DomainFailure> check(const InputCurve& input) const {
    const CurveNet<Integer> curve = input.exact();
    Rational t = 0;
    while (t < 1) {
      const Point point = point_at(curve, t);
      const std::vector<std::uint32_t> vertices = index_.at(point);
      const std::vector<Departure> departures = departures_at(vertices);
      const std::optional<Rational> next = follow(curve, t, departures);
      if (!next) return failure(curve, t, point, vertices, departures);
      t = *next;
    }
    return std::nullopt;
  }

 private:
  std::vector<Departure> departures_at(const std::vector<std::uint32_t>& vertices) const {
    std::vector<Departure> result;
    for (const std::uint32_t vertex : vertices) {
      for (const HalfEdge out : surface_.corners(vertex)) {
        const HalfEdge in = surface_.previous(out);
        result.push_back({out, true, surface_.end(out)});
        result.push_back({in, false, surface_.begin(in)});
      }
    }
    return result;
  }

  CurveNet<Integer> net_of(const Departure& departure) const {
    CurveNet<Integer> net = surface_.exact(departure.h);
    return departure.forward ? net : reversed(net);
  }

  // The nearest parameter to which an edge covers the curve from t on.
  std::optional<Rational> follow(const CurveNet<Integer>& curve, const Rational& t,
                                 const std::vector<Departure>& departures) const {
    std::optional<Rational> nearest;
    for (const Departure& departure : departures) {
      for (const Rational& end : rational_parameters(curve, surface_.point(departure.to), t)) {
        if (nearest && *nearest <= end) break;
        if (same_curve(net_of(departure), part_of(curve, t, end))) {
          nearest = end;
          break;
        }
      }
    }
    return nearest;
  }

  DomainFailure failure(const CurveNet<Integer>& curve, const Rational& t, const Point& point,
                        const std::vector<std::uint32_t>& vertices,
                        const std::vector<Departure>& departures) const {
    DomainFailure result;
    result.parameter = t;
    result.point = point;
    if (surface_.mesh().glued_by_nodes()) result.nodes = vertices;
    for (const Departure& departure : departures) {
      const std::uint32_t element = surface_.element(departure.h);
      if (std::find(result.elements.begin(), result.elements.end(), element) == result.elements.end()) {
        result.elements.push_back(element);
      }
    }
    if (vertices.empty()) {
      result.cause = DomainCause::no_corner;
    } else {
      find_cause(curve, departures, result);
    }
    return result;
  }

  void name_edge(DomainCause cause, const Departure& departure, DomainFailure& failure) const {
    failure.cause = cause;
    failure.edge = surface_.element_edge(departure.h);
    failure.forward = departure.forward;
  }

  void find_cause(const CurveNet<Integer>& curve, const std::vector<Departure>& departures,
                  DomainFailure& failure) const {
    const Rational& t = failure.parameter;
    // An edge that ends on the curve, but takes another way, is the likely culprit: the one with the nearest
    // end.
    const Departure* best = nullptr;
    Rational best_end;
    for (const Departure& departure : departures) {
      const std::vector<Rational> ends = rational_parameters(curve, surface_.point(departure.to), t);
      if (ends.empty() || (best != nullptr && best_end <= ends.front())) continue;
      best = &departure;
      best_end = ends.front();
    }
    if (best != nullptr) {
      name_edge(DomainCause::other_way, *best, failure);
      failure.distance = largest_distance(net_of(*best), part_of(curve, t, best_end));
      return;
    }
    // No edge ends on the rest of the curve at a rational parameter.
    const CurveNet<Integer> rest = part_of(curve, t, 1);
    failure.end = point_at(curve, 1);
    for (const Departure& departure : departures) {
      if (passes_inside(net_of(departure), failure.end)) {
        return name_edge(DomainCause::ends_inside_edge, departure, failure);
      }
      if (passes_inside(rest, surface_.point(departure.to))) {
        return name_edge(DomainCause::irrational_parameter, departure, failure);
      }
    }
    failure.cause = DomainCause::no_edge;
  }

  const Surface& surface_;
  VertexIndex index_;
};

}  // namespace

DomainResult check_domain(const Surface& surface, std::span<const InputCurve> curves) {
  const DomainCheck check(surface);
  DomainResult result;
  result.curves = curves.size();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (auto failure = check.check(curves[i])) {
      failure->curve = i;
      failure->curve_name = curves[i].name;
      result.failures.push_back(std::move(*failure));
    } else {
      ++result.covered;
    }
  }
  return result;
}

}  // namespace bezcert
