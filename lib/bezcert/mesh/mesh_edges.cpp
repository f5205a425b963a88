#include "bezcert/mesh/mesh_edges.hpp"

#include "bezcert/curve/separation.hpp"
#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

const BasisChange& segment_change(std::size_t count) {
  return lagrange_to_bernstein(Shape{Domain::segment, static_cast<int>(count) - 1, 0});
}

// x and y of the nodes over one factor: values[i] and values[count + i] times `scale`.
ScaledIntegers common_coordinates(const Mesh& mesh, const std::vector<std::uint32_t>& nodes) {
  if (mesh.x.binary64() && mesh.y.binary64()) {
    std::vector<double> all;
    for (const std::uint32_t node : nodes) all.push_back(mesh.x.doubles()[node]);
    for (const std::uint32_t node : nodes) all.push_back(mesh.y.doubles()[node]);
    return scaled_integers(all);
  }
  std::vector<Rational> all;
  for (const std::uint32_t node : nodes) all.push_back(mesh.x[node]);
  for (const std::uint32_t node : nodes) all.push_back(mesh.y[node]);
  return scaled_integers(all);
}

// Differences to the first are taken first: of equal numbers they are exactly 0, and a straight edge along an
// axis is seen as such without exact numbers.
std::vector<Interval> relative(const ExactVector& numbers, const std::vector<std::uint32_t>& nodes,
                               std::uint32_t origin) {
  std::vector<Interval> result;
  result.reserve(nodes.size());
  for (const std::uint32_t node : nodes) {
    result.push_back(numbers.binary64()
                         ? Interval(numbers.doubles()[node]) - Interval(numbers.doubles()[origin])
                         : to_interval(Rational(numbers.rationals()[node] - numbers.rationals()[origin])));
  }
  return result;
}

}  // namespace

MeshEdges::MeshEdges(const Mesh& mesh) : mesh_(mesh) {
  first_.reserve(mesh.elements.size() + 1);
  std::size_t count = 0;
  for (const MeshElement& element : mesh.elements) {
    first_.push_back(static_cast<EdgeUse>(count));
    count += element.shape.domain == Domain::triangle ? 3 : 4;
    if (count >= no_edge) throw std::length_error("a mesh of more than 2^32 - 2 element edges");
  }
  first_.push_back(static_cast<EdgeUse>(count));
  element_.reserve(count);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    element_.insert(element_.end(), first_[i + 1] - first_[i], static_cast<std::uint32_t>(i));
  }
}

std::vector<std::uint32_t> MeshEdges::nodes(EdgeUse use) const {
  const MeshElement& element = mesh_.elements[element_[use]];
  std::vector<std::uint32_t> result;
  for (const std::size_t position : edge_positions(element.shape, edge(use))) {
    result.push_back(mesh_.connectivity[element.first_node + position]);
  }
  return result;
}

std::uint32_t MeshEdges::begin_node(EdgeUse use) const {
  const MeshElement& element = mesh_.elements[element_[use]];
  const Shape& shape = element.shape;
  const int corner = edge(use);
  std::size_t position = 0;
  if (corner == 1) position = coefficient_index(shape, 0, shape.p);
  if (shape.domain == Domain::triangle) {
    if (corner == 2) position = coefficient_index(shape, shape.p, 0);
  } else {
    if (corner == 2) position = coefficient_index(shape, shape.q, shape.p);
    if (corner == 3) position = coefficient_index(shape, shape.q, 0);
  }
  return mesh_.connectivity[element.first_node + position];
}

bool MeshEdges::equal_weights(const std::vector<std::uint32_t>& nodes) const {
  if (mesh_.weights.empty()) return true;
  return std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
    return mesh_.weights.binary64() ? mesh_.weights.doubles()[node] == mesh_.weights.doubles()[nodes[0]]
                                    : mesh_.weights.rationals()[node] == mesh_.weights.rationals()[nodes[0]];
  });
}

CurveNet<Integer> MeshEdges::exact(EdgeUse use) const {
  const std::vector<std::uint32_t> along = nodes(use);
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
    for (const std::uint32_t node : along) weights.push_back(mesh_.weights[node]);
    const std::vector<Integer> integers = scaled_integers(weights).values;
    for (std::size_t i = 0; i < count; ++i) {
      for (auto* values : {&net.x, &net.y, &net.w}) (*values)[i] *= integers[i];
    }
  }
  if (basis(use) == Basis::lagrange) {
    // All three are multiplied by the matrix's denominator, which is the factor of the curve.
    for (auto* values : {&net.x, &net.y, &net.w}) change_basis(segment_change(count), *values);
  }
  return net;
}

CurveNet<Interval> MeshEdges::interval(EdgeUse use) const {
  const std::vector<std::uint32_t> along = nodes(use);
  const std::size_t count = along.size();
  const bool polynomial = equal_weights(along);
  CurveNet<Interval> net;
  if (basis(use) == Basis::lagrange && polynomial) {
    const BasisChange& change = segment_change(count);
    net.x = relative(mesh_.x, along, along[0]);
    net.y = relative(mesh_.y, along, along[0]);
    change_basis(change, net.x);
    change_basis(change, net.y);
    const Interval unit = to_interval(change.denominator);
    const Interval x = mesh_.x.interval(along[0]), y = mesh_.y.interval(along[0]);
    for (Interval& value : net.x) value = x + value / unit;
    for (Interval& value : net.y) value = y + value / unit;
    net.w.assign(count, Interval(1));
    // The end points are nodes: exact.
    net.x.front() = x;
    net.y.front() = y;
    net.x.back() = mesh_.x.interval(along.back());
    net.y.back() = mesh_.y.interval(along.back());
    return net;
  }
  for (const std::uint32_t node : along) {
    const Interval w = polynomial ? Interval(1) : mesh_.weights.interval(node);
    net.x.push_back(mesh_.x.interval(node) * w);
    net.y.push_back(mesh_.y.interval(node) * w);
    net.w.push_back(w);
  }
  if (basis(use) == Basis::lagrange) {
    for (auto* values : {&net.x, &net.y, &net.w}) change_basis(segment_change(count), *values);
  }
  return net;
}

Box MeshEdges::box(EdgeUse use) const {
  const CurveNet<Interval> net = interval(use);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box box{infinite, -infinite, infinite, -infinite};
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Interval x = net.x[i] / net.w[i], y = net.y[i] / net.w[i];
    const bool known = x.inf() <= x.sup() && y.inf() <= y.sup();
    if (!known) return {-infinite, infinite, -infinite, infinite};  // a NaN: overflow
    box = {std::min(box.x_low, x.inf()), std::max(box.x_high, x.sup()), std::min(box.y_low, y.inf()),
           std::max(box.y_high, y.sup())};
  }
  return box;
}

Vector2<Interval> MeshEdges::interval_tangent(EdgeUse use, End end) const {
  std::vector<std::uint32_t> along = nodes(use);
  if (end == End::end) std::reverse(along.begin(), along.end());
  if (basis(use) == Basis::bernstein) {
    // The weights of the first two control points only scale it.
    const std::vector<std::uint32_t> second = {along[1]};
    return {relative(mesh_.x, second, along[0])[0], relative(mesh_.y, second, along[0])[0]};
  }
  if (equal_weights(along)) {
    const std::vector<Interval> x = relative(mesh_.x, along, along[0]),
                                y = relative(mesh_.y, along, along[0]);
    Vector2<Interval> result{Interval(0), Interval(0)};
    for (const auto& entry : segment_change(along.size()).rows[1]) {
      result.x += entry.interval * x[entry.column];
      result.y += entry.interval * y[entry.column];
    }
    return result;
  }
  const CurveNet<Interval> net = interval(use);
  const std::size_t last = net.size() - 1;
  return end == End::begin ? between(net, 0, net, 1) : between(net, last, net, last - 1);
}

Vector2<Integer> MeshEdges::exact_tangent(EdgeUse use, End end) const {
  const CurveNet<Integer> net = exact(use);
  const std::size_t last = net.size() - 1;
  return end == End::begin ? between(net, 0, net, 1) : between(net, last, net, last - 1);
}

}  // namespace bezcert
