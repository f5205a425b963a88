#include "bezcert/surface/one_way.hpp"

#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/element/lagrange.hpp"
#include "bezcert/number/static_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bezcert {
namespace {

constexpr std::size_t most_nodes = 64;

// Control edges, times one positive number, as sums of products of nodes with d, in double or their errors.
struct ControlEdges {
  struct Sum {
    std::size_t first;      // node of the first coefficient
    std::vector<double> c;  // integers
    double error = 0;       // in units of the largest |d_x| or |d_y| times the largest difference of nodes
  };
  std::vector<Sum> sums;  // none: too many nodes, or too large numbers
};

// The product of d with a node, relative to the first.
template <class T>
T along(const Vector2<T>& d, const Vector2<T>& node) {
  return d.x * node.x + d.y * node.y;
}

template <class T, class Along>
T sum_of(const ControlEdges::Sum& sum, Along along) {
  T result = along(sum.first) * sum.c[0];
  for (std::size_t k = 1; k < sum.c.size(); ++k) result = result + along(sum.first + k) * sum.c[k];
  return result;
}

ControlEdges build(std::size_t count, Basis basis) {
  ControlEdges result;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    ControlEdges::Sum sum{i, {-1, 1}};
    if (basis == Basis::lagrange) {
      const BasisChange& change = lagrange_to_bernstein(Shape::segment(static_cast<int>(count) - 1));
      std::vector<Integer> exact(count, 0);
      for (const auto& entry : change.rows[i + 1]) exact[entry.column] += entry.exact;
      for (const auto& entry : change.rows[i]) exact[entry.column] -= entry.exact;
      sum = {0, {}};
      for (const Integer& c : exact) {
        if (abs(c) >= Integer(1) << 40) return {};
        sum.c.push_back(c.convert_to<double>());
      }
    }
    const Vector2<StaticBound> d{{1, 0}, {1, 0}}, node{unit_difference(), unit_difference()};
    const StaticBound product = along(d, node);
    sum.error = error_of(sum_of<StaticBound>(sum, [&](std::size_t) { return product; }));
    result.sums.push_back(std::move(sum));
  }
  return result;
}

const ControlEdges& control_edges(std::size_t count, Basis basis) {
  static TableCache<ControlEdges> caches[2];
  return caches[basis == Basis::lagrange].get(Shape::segment(static_cast<int>(count) - 1),
                                              [&](Shape) { return build(count, basis); });
}

double size_of(const Vector2<double>& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

bool runs_along(const HalfEdges& edges, HalfEdge h, const Vector2<double>& d) {
  const EdgeNodes nodes = edges.nodes(h);
  const double* const x = edges.mesh().coordinates(0).doubles().data();
  const double* const y = edges.mesh().coordinates(1).doubles().data();
  std::array<double, most_nodes> products;
  double largest = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vector2<double> node{x[nodes[k]] - x[nodes[0]], y[nodes[k]] - y[nodes[0]]};
    products[k] = along(d, node);
    largest = std::max(largest, size_of(node));
  }
  const double unit = largest * size_of(d);
  if (!(unit > least_unit && unit < 0x1p850 && largest < 0x1p900)) return false;
  const ControlEdges& table = control_edges(nodes.size(), edges.basis(h));
  for (const ControlEdges::Sum& sum : table.sums) {
    const double value = sum_of<double>(sum, [&](std::size_t k) { return products[k]; });
    if (certain_sign(value, sum.error * unit) != 1) return false;
  }
  return !table.sums.empty();
}

}  // namespace

bool run_one_way(const HalfEdges& edges, HalfEdge first, HalfEdge second) {
  const Mesh& mesh = edges.mesh();
  if (!mesh.coordinates(0).binary64() || !mesh.coordinates(1).binary64()) return false;
  if (!edges.equal_weights(first) || !edges.equal_weights(second)) return false;
  const EdgeNodes from = edges.nodes(first), to = edges.nodes(second);
  if (from.size() > most_nodes || to.size() > most_nodes) return false;
  const Vector2<double> d{
      mesh.coordinates(0).doubles()[to.back()] - mesh.coordinates(0).doubles()[from.front()],
      mesh.coordinates(1).doubles()[to.back()] - mesh.coordinates(1).doubles()[from.front()]};
  if (!(size_of(d) < 0x1p900)) return false;
  return runs_along(edges, first, d) && runs_along(edges, second, d);
}

}  // namespace bezcert
