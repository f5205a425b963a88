#include "bezcert/mesh/one_way.hpp"

#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <cmath>

namespace bezcert {
namespace {

constexpr std::size_t most_nodes = 64;

// Differences of control points as sums of nodal values, times one positive number.
struct Differences {
  struct Row {
    std::vector<double> c;
    double size;  // sum of |c|
  };
  std::vector<Row> rows;  // none: there are too many nodes, or too large numbers
};

Differences build(Shape segment) {
  Differences result;
  const BasisChange& change = lagrange_to_bernstein(segment);
  const std::size_t count = change.rows.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    std::vector<Integer> exact(count, 0);
    for (const auto& entry : change.rows[i + 1]) exact[entry.column] += entry.exact;
    for (const auto& entry : change.rows[i]) exact[entry.column] -= entry.exact;
    Differences::Row row{{}, 0};
    for (const Integer& c : exact) {
      if (abs(c) >= Integer(1) << 40) return {};
      row.c.push_back(c.convert_to<double>());
      row.size += std::abs(row.c.back());
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

const Differences& differences_of(std::size_t count) {
  static TableCache<Differences> cache;
  return cache.get(Shape::segment(static_cast<int>(count) - 1), build);
}

struct Direction {
  double x, y;
};

bool runs_along(const MeshEdges& edges, EdgeUse use, Direction d) {
  const EdgeNodes nodes = edges.nodes(use);
  const double* const x = edges.mesh().x.doubles().data();
  const double* const y = edges.mesh().y.doubles().data();
  const std::size_t count = nodes.size();
  std::array<double, most_nodes> along;
  double a = 0, largest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double dx = x[nodes[k]] - x[nodes[0]], dy = y[nodes[k]] - y[nodes[0]];
    along[k] = d.x * dx + d.y * dy;
    a = std::max(a, std::abs(d.x) * std::abs(dx) + std::abs(d.y) * std::abs(dy));
    largest = std::max({largest, std::abs(dx), std::abs(dy)});
  }
  if (!(a > 0x1p-800 && a < 0x1p850 && largest < 0x1p900)) return false;
  const double unit = 2 * static_cast<double>(count + 4) * 0x1p-52 * a;
  if (edges.basis(use) == Basis::bernstein) {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      if (!(along[i + 1] - along[i] > 2 * unit)) return false;
    }
    return true;
  }
  const Differences& differences = differences_of(count);
  for (const Differences::Row& row : differences.rows) {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += row.c[k] * along[k];
    if (!(sum > unit * row.size)) return false;
  }
  return !differences.rows.empty();
}

}  // namespace

bool run_one_way(const MeshEdges& edges, EdgeUse first, EdgeUse second) {
  const Mesh& mesh = edges.mesh();
  if (!mesh.x.binary64() || !mesh.y.binary64()) return false;
  if (!edges.equal_weights(first) || !edges.equal_weights(second)) return false;
  const EdgeNodes from = edges.nodes(first), to = edges.nodes(second);
  if (from.size() > most_nodes || to.size() > most_nodes) return false;
  const Direction d{mesh.x.doubles()[to.back()] - mesh.x.doubles()[from.front()],
                    mesh.y.doubles()[to.back()] - mesh.y.doubles()[from.front()]};
  if (!(std::abs(d.x) < 0x1p900 && std::abs(d.y) < 0x1p900)) return false;
  return runs_along(edges, first, d) && runs_along(edges, second, d);
}

}  // namespace bezcert
