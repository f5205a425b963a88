#include "bezcert/surface/half_edges.hpp"

#include "bezcert/curve/separation.hpp"
#include "bezcert/element/lagrange.hpp"
#include "bezcert/number/static_bound.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace bezcert {
namespace {

const BasisChange& segment_change(std::size_t count) {
  return lagrange_to_bernstein(Shape::segment(static_cast<int>(count) - 1));
}

// x and y of the nodes over one factor: values[i] and values[count + i] times `scale`.
ScaledIntegers common_coordinates(const Mesh& mesh, const EdgeNodes& nodes) {
  const auto gather = [&]<class T>(auto number) {
    std::vector<T> all;
    for (const ExactVector* numbers : {&mesh.coordinates(0), &mesh.coordinates(1)}) {
      for (std::size_t i = 0; i < nodes.size(); ++i) all.push_back(number(*numbers, nodes[i]));
    }
    return scaled_integers(all);
  };
  if (mesh.coordinates(0).binary64() && mesh.coordinates(1).binary64()) {
    return gather.operator()<double>(
        [](const ExactVector& from, std::uint32_t i) { return from.doubles()[i]; });
  }
  return gather.operator()<Rational>([](const ExactVector& from, std::uint32_t i) { return from[i]; });
}

// Differences to an origin are taken first: of equal numbers they are exactly 0, and a straight edge along an
// axis is seen as such without exact numbers.
Interval difference(const ExactVector& numbers, std::uint32_t node, std::uint32_t origin) {
  if (numbers.binary64()) return Interval(numbers.doubles()[node]) - Interval(numbers.doubles()[origin]);
  return to_interval(Rational(numbers.rationals()[node] - numbers.rationals()[origin]));
}

std::vector<Interval> relative(const ExactVector& numbers, const EdgeNodes& nodes) {
  std::vector<Interval> result;
  result.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) result.push_back(difference(numbers, nodes[i], nodes[0]));
  return result;
}

// The sum of c_j (x_j - x_0), j > 0, from the differences: in double, or its error.
template <class T, class Difference>
T sum_of(const std::vector<double>& c, Difference difference) {
  T sum = difference(std::size_t{1}) * c[1];
  for (std::size_t j = 2; j < c.size(); ++j) sum = sum + difference(j) * c[j];
  return sum;
}

}  // namespace

// The tangent at the beginning of an edge of so many nodes, times a positive number.
HalfEdges::TangentSum HalfEdges::tangent_sum(Basis basis, std::size_t count) {
  TangentSum result;
  if (basis == Basis::bernstein) {
    result.coefficients = {-1, 1};
  } else {
    result.coefficients.assign(count, 0);
    for (const auto& entry : segment_change(count).rows[1]) {
      if (entry.interval.inf() != entry.interval.sup()) return {};
      result.coefficients[entry.column] = entry.interval.inf();
    }
  }
  const auto bound = sum_of<StaticBound>(result.coefficients, [](std::size_t) { return unit_difference(); });
  if (!(bound.magnitude < 0x1p100)) return {};
  result.error = error_of(bound);
  return result;
}

HalfEdges::HalfEdges(const Mesh& mesh) : mesh_(mesh) {
  shape_.reserve(mesh.elements().size());
  std::map<std::pair<Shape, Basis>, std::uint16_t> known;
  const MeshElement* last = nullptr;
  bool triangles = false, quadrilaterals = false;
  for (const MeshElement& element : mesh.elements()) {
    const int edges = element.shape.domain == Domain::triangle ? 3 : 4;
    (edges == 3 ? triangles : quadrilaterals) = true;
    count_ += static_cast<std::size_t>(edges);
    if (count_ >= no_half_edge) throw std::length_error("a mesh of more than 2^32 - 2 element edges");
    if (last && last->shape == element.shape && last->basis == element.basis) {
      shape_.push_back(shape_.back());
      continue;
    }
    last = &element;
    const auto [place, is_new] =
        known.try_emplace({element.shape, element.basis}, static_cast<std::uint16_t>(shapes_.size()));
    shape_.push_back(place->second);
    if (!is_new) continue;
    ShapeEdges& tables = shapes_.emplace_back();
    tables.basis = element.basis;
    for (int edge = 0; edge < edges; ++edge) {
      const auto at = static_cast<std::size_t>(edge);
      const std::vector<std::size_t> positions = edge_positions(element.shape, edge);
      tables.along[at].assign(positions.begin(), positions.end());
      tables.tangent[at] = tangent_sum(element.basis, positions.size());
    }
  }
  if (shapes_.size() == 1) {
    stride_ = coefficient_count(mesh.elements()[0].shape);
    for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
      if (mesh.elements()[i].first_node != i * stride_) stride_ = 0;
    }
  }
  if (!triangles || !quadrilaterals) {
    sides_ = triangles ? 3 : 4;
    return;
  }
  first_.reserve(mesh.elements().size() + 1);
  element_.reserve(count_);
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    first_.push_back(static_cast<HalfEdge>(element_.size()));
    const std::size_t edges = mesh.elements()[i].shape.domain == Domain::triangle ? 3 : 4;
    element_.insert(element_.end(), edges, static_cast<std::uint32_t>(i));
  }
  first_.push_back(static_cast<HalfEdge>(count_));
}

int HalfEdges::compare_points(std::uint32_t a, std::uint32_t b) const {
  const auto compare = [](const auto& p, const auto& q) { return p == q ? 0 : p < q ? -1 : 1; };
  if (mesh_.coordinates(0).binary64() && mesh_.coordinates(1).binary64()) {
    const int x = compare(mesh_.coordinates(0).doubles()[a], mesh_.coordinates(0).doubles()[b]);
    return x != 0 ? x : compare(mesh_.coordinates(1).doubles()[a], mesh_.coordinates(1).doubles()[b]);
  }
  const Point p = point(a), q = point(b);
  return p.x != q.x ? compare(p.x, q.x) : compare(p.y, q.y);
}

bool HalfEdges::equal_weights(const EdgeNodes& nodes) const {
  if (mesh_.weights().empty()) return true;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const bool equal = mesh_.weights().binary64()
                           ? mesh_.weights().doubles()[nodes[i]] == mesh_.weights().doubles()[nodes[0]]
                           : mesh_.weights().rationals()[nodes[i]] == mesh_.weights().rationals()[nodes[0]];
    if (!equal) return false;
  }
  return true;
}

CurveNet<Integer> HalfEdges::exact(HalfEdge h) const {
  const EdgeNodes along = nodes(h);
  const std::size_t count = along.size();
  ScaledIntegers coordinates = common_coordinates(mesh_, along);
  const Integer multiple = numerator(coordinates.scale), unit = denominator(coordinates.scale);
  CurveNet<Integer> net;
  for (std::size_t i = 0; i < count; ++i) {
    net.x.push_back(coordinates.values[i] * multiple);
    net.y.push_back(coordinates.values[count + i] * multiple);
  }
  net.w.assign(count, unit);
  if (!equal_weights(along)) {
    std::vector<Rational> weights;
    for (std::size_t i = 0; i < count; ++i) weights.push_back(mesh_.weights()[along[i]]);
    const std::vector<Integer> integers = scaled_integers(weights).values;
    for (std::size_t i = 0; i < count; ++i) {
      for (auto* values : {&net.x, &net.y, &net.w}) (*values)[i] *= integers[i];
    }
  }
  if (basis(h) == Basis::lagrange) {
    // All three are multiplied by the matrix's denominator, which is the factor of the curve.
    for (auto* values : {&net.x, &net.y, &net.w}) change_basis(segment_change(count), *values);
  }
  return net;
}

CurveNet<Interval> HalfEdges::interval(const RoundUp&, HalfEdge h) const {
  const EdgeNodes along = nodes(h);
  const std::size_t count = along.size();
  const bool polynomial = equal_weights(along);
  CurveNet<Interval> net;
  if (basis(h) == Basis::lagrange && polynomial) {
    const BasisChange& change = segment_change(count);
    net.x = relative(mesh_.coordinates(0), along);
    net.y = relative(mesh_.coordinates(1), along);
    change_basis(change, net.x);
    change_basis(change, net.y);
    const Interval unit = to_interval(change.denominator);
    const Interval x = interval_at(mesh_.coordinates(0), along[0]),
                   y = interval_at(mesh_.coordinates(1), along[0]);
    for (Interval& value : net.x) value = x + value / unit;
    for (Interval& value : net.y) value = y + value / unit;
    net.w.assign(count, Interval(1));
    // The end points are nodes: exact.
    net.x.front() = x;
    net.y.front() = y;
    net.x.back() = interval_at(mesh_.coordinates(0), along.back());
    net.y.back() = interval_at(mesh_.coordinates(1), along.back());
    return net;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t node = along[i];
    const Interval w = polynomial ? Interval(1) : interval_at(mesh_.weights(), node);
    net.x.push_back(interval_at(mesh_.coordinates(0), node) * w);
    net.y.push_back(interval_at(mesh_.coordinates(1), node) * w);
    net.w.push_back(w);
  }
  if (basis(h) == Basis::lagrange) {
    for (auto* values : {&net.x, &net.y, &net.w}) change_basis(segment_change(count), *values);
  }
  return net;
}

Vector2<Interval> HalfEdges::interval_tangent(const RoundUp& up, HalfEdge h, End end) const {
  const EdgeNodes along = end == End::begin ? nodes(h) : nodes(h).reversed();
  const auto to = [&](std::size_t i) {
    return Vector2<Interval>{difference(mesh_.coordinates(0), along[i], along[0]),
                             difference(mesh_.coordinates(1), along[i], along[0])};
  };
  // The weights of the first two control points only scale it.
  if (basis(h) == Basis::bernstein) return to(1);
  if (equal_weights(along)) {
    Vector2<Interval> result{Interval(0), Interval(0)};
    for (const auto& entry : segment_change(along.size()).rows[1]) {
      const Vector2<Interval> d = to(entry.column);
      result.x += entry.interval * d.x;
      result.y += entry.interval * d.y;
    }
    return result;
  }
  const CurveNet<Interval> net = interval(up, h);
  const std::size_t last = net.size() - 1;
  return end == End::begin ? between(net, 0, net, 1) : between(net, last, net, last - 1);
}

// The unit is the largest difference. Where it is 0, all are, exactly.
std::optional<DoubleOperands<std::tuple<double>>> HalfEdges::double_tangent(HalfEdge h, End end,
                                                                            int coordinate) const {
  const ExactVector& numbers = coordinate == 0 ? mesh_.coordinates(0) : mesh_.coordinates(1);
  if (!numbers.binary64()) return std::nullopt;
  const TangentSum& tangent = shapes_[shape_of(element(h))].tangent[static_cast<std::size_t>(edge(h))];
  if (tangent.coefficients.empty()) return std::nullopt;
  const EdgeNodes along = end == End::begin ? nodes(h) : nodes(h).reversed();
  if (!mesh_.weights().empty() && basis(h) == Basis::lagrange && !equal_weights(along)) return std::nullopt;
  const double* x = numbers.doubles().data();
  const double origin = x[along[0]];
  double unit = 0;
  const double sum = sum_of<double>(tangent.coefficients, [&](std::size_t j) {
    const double difference = x[along[j]] - origin;
    unit = std::max(unit, std::abs(difference));
    return difference;
  });
  if (!(unit == 0 || (unit > least_unit && unit < 0x1p900))) return std::nullopt;
  return DoubleOperands{std::tuple(sum), tangent.error * unit};
}

Vector2<Integer> HalfEdges::exact_tangent(HalfEdge h, End end) const {
  const CurveNet<Integer> net = exact(h);
  const std::size_t last = net.size() - 1;
  return end == End::begin ? between(net, 0, net, 1) : between(net, last, net, last - 1);
}

}  // namespace bezcert
