#include "bezcert/mesh/domain.hpp"

#include "bezcert/curve/same_curve.hpp"
#include "bezcert/mesh/curve_parameters.hpp"
#include "bezcert/mesh/edge_distance.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// Vertices in the order of their points, to find those at a point.
class VertexIndex {
 public:
  VertexIndex(const MeshEdges& edges, const CornersByVertex& corners) : edges_(edges) {
    const Mesh& mesh = edges.mesh();
    for (std::uint32_t vertex = 0; vertex + 1 < corners.start.size(); ++vertex) {
      if (corners.start[vertex] < corners.start[vertex + 1]) vertices_.push_back(vertex);
    }
    const bool doubles = mesh.coordinates(0).binary64() && mesh.coordinates(1).binary64();
    std::sort(vertices_.begin(), vertices_.end(), [&](std::uint32_t a, std::uint32_t b) {
      if (doubles) {
        const auto key = [&](std::uint32_t v) {
          return std::tuple(mesh.coordinates(0).doubles()[v], mesh.coordinates(1).doubles()[v], v);
        };
        return key(a) < key(b);
      }
      const int order = compare(edges.point(a), edges.point(b));
      return order != 0 ? order < 0 : a < b;
    });
  }

  std::vector<std::uint32_t> at(const Point& point) const {
    const auto first = std::partition_point(vertices_.begin(), vertices_.end(), [&](std::uint32_t vertex) {
      return compare(edges_.point(vertex), point) < 0;
    });
    std::vector<std::uint32_t> result;
    for (auto it = first; it != vertices_.end() && edges_.point(*it) == point; ++it) result.push_back(*it);
    return result;
  }

 private:
  static int compare(const Point& a, const Point& b) {
    if (a.x != b.x) return a.x < b.x ? -1 : 1;
    return a.y < b.y ? -1 : a.y == b.y ? 0 : 1;
  }

  const MeshEdges& edges_;
  std::vector<std::uint32_t> vertices_;
};

// A mesh edge at a vertex, led away from it.
struct Departure {
  EdgeUse use = no_edge;
  bool forward = true;
  std::uint32_t to = 0;
};

class DomainCheck {
 public:
  DomainCheck(const Mesh& mesh, const MeshEdges& edges, const Gluing& gluing, const CornersByVertex& corners)
      : mesh_(mesh), edges_(edges), gluing_(gluing), corners_(corners), index_(edges, corners) {}

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
      for (std::uint32_t i = corners_.start[vertex]; i < corners_.start[vertex + 1]; ++i) {
        const EdgeUse out = corners_.corners[i], in = edges_.previous(out);
        result.push_back({out, true, gluing_.end(edges_, out)});
        result.push_back({in, false, gluing_.begin[in]});
      }
    }
    return result;
  }

  CurveNet<Integer> net_of(const Departure& departure) const {
    CurveNet<Integer> net = edges_.exact(departure.use);
    return departure.forward ? net : reversed(net);
  }

  // The nearest parameter to which an edge covers the curve from t on.
  std::optional<Rational> follow(const CurveNet<Integer>& curve, const Rational& t,
                                 const std::vector<Departure>& departures) const {
    std::optional<Rational> nearest;
    for (const Departure& departure : departures) {
      for (const Rational& end : rational_parameters(curve, edges_.point(departure.to), t)) {
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
    if (mesh_.glued_by_nodes()) result.nodes = vertices;
    for (const Departure& departure : departures) {
      const std::uint32_t element = edges_.element(departure.use);
      if (std::find(result.elements.begin(), result.elements.end(), element) == result.elements.end()) {
        result.elements.push_back(element);
      }
    }
    result.message = reason(curve, t, vertices, departures);
    return result;
  }

  std::string reason(const CurveNet<Integer>& curve, const Rational& t,
                     const std::vector<std::uint32_t>& vertices,
                     const std::vector<Departure>& departures) const {
    if (vertices.empty()) return "no element has a corner there";
    // An edge that ends on the curve, but takes another way, is the likely culprit: the one with the nearest
    // end.
    const Departure* best = nullptr;
    Rational best_end;
    for (const Departure& departure : departures) {
      const std::vector<Rational> ends = rational_parameters(curve, edges_.point(departure.to), t);
      if (ends.empty() || (best != nullptr && best_end <= ends.front())) continue;
      best = &departure;
      best_end = ends.front();
    }
    const std::string from = node_text(edges_, vertices.front());
    if (best == nullptr) return other_reason(curve, t, from, departures);
    const CurveNet<Integer> part = part_of(curve, t, best_end), edge = net_of(*best);
    return "the edge from " + from + " to " + node_text(edges_, best->to) + " of element " +
           std::to_string(edges_.element_number(best->use)) +
           " ends on the curve, but is not that part of it: " + text_of(largest_distance(edge, part)) +
           " apart at most at equal parameters";
  }

  // No edge ends on the rest of the curve at a rational parameter.
  std::string other_reason(const CurveNet<Integer>& curve, const Rational& t, const std::string& from,
                           const std::vector<Departure>& departures) const {
    const CurveNet<Integer> rest = part_of(curve, t, 1);
    const Point end = point_at(curve, 1);
    for (const Departure& departure : departures) {
      const std::string edge = "the edge from " + from + " to " + node_text(edges_, departure.to) +
                               " of element " + std::to_string(edges_.element_number(departure.use));
      if (passes_inside(net_of(departure), end)) {
        return "the curve ends at " + text_of(end) + ", inside " + edge + ": there is no node";
      }
      if (passes_inside(rest, edges_.point(departure.to))) {
        return edge + " ends on the curve, but at an irrational parameter: it runs through it differently";
      }
    }
    return "no edge from " + from + " leads to another point of the curve";
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  const Gluing& gluing_;
  const CornersByVertex& corners_;
  VertexIndex index_;
};

}  // namespace

DomainResult check_domain(const Mesh& mesh, std::span<const InputCurve> curves) {
  const MeshEdges edges(mesh);
  ObstacleList obstacles;
  const Gluing gluing = glue(edges, obstacles);
  const CornersByVertex corners = corners_by_vertex(edges, gluing);
  const DomainCheck check(mesh, edges, gluing, corners);
  DomainResult result;
  result.curves = curves.size();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (auto failure = check.check(curves[i])) {
      failure->curve = i;
      result.failures.push_back(std::move(*failure));
    } else {
      ++result.covered;
    }
  }
  return result;
}

}  // namespace bezcert
