#include "bezcert/batch/table.hpp"

#include "bezcert/batch/kernel.hpp"
#include "bezcert/bernstein/scale_table.hpp"
#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/element/jacobian.hpp"
#include "bezcert/element/lagrange.hpp"
#include "bezcert/number/static_bound.hpp"

#include <algorithm>
#include <memory>
#include <optional>

namespace bezcert::batch {
namespace {

// A BlockTable with what it points to. usable: whether its bounds are finite and moderate.
struct OwnedTable {
  BlockTable table;
  bool usable = false;
  std::vector<std::uint16_t> row_start, column;
  std::vector<double> value, along_u, along_v, columns, determinant;
};

// A double within one step of a rational number: an end of the smallest interval around it.
double next_to(const Rational& value) { return to_interval(value).sup(); }

std::vector<double> multinomial_doubles(Shape shape) {
  std::vector<double> result;
  for (const Integer& m : scale_table(shape).multinomial) result.push_back(next_to(Rational(m)));
  return result;
}

std::vector<double> inverse_multinomials(Shape shape, int factor) {
  std::vector<double> result;
  for (const Integer& m : scale_table(shape).multinomial) {
    result.push_back(next_to(Rational(Integer(factor), m)));
  }
  return result;
}

void add_basis_change(OwnedTable& owned, Shape shape) {
  const BasisChange& change = lagrange_to_bernstein(shape);
  owned.row_start.push_back(0);
  for (const auto& row : change.rows) {
    for (const auto& entry : row) {
      owned.column.push_back(static_cast<std::uint16_t>(entry.column));
      owned.value.push_back(next_to(Rational(entry.exact, change.denominator)));
    }
    owned.row_start.push_back(static_cast<std::uint16_t>(owned.column.size()));
  }
}

template <Kind kind>
std::optional<Errors> static_errors(const BlockTable& table) {
  using K = Kernel<StaticBound, kind, 0>;
  const auto kernel = std::make_unique<K>(table);
  const StaticBound coordinate = unit_difference();
  for (int i = 0; i < kernel->point_count(); ++i) {
    kernel->node_x[i] = kernel->node_y[i] = coordinate;
    if constexpr (K::is_rational) kernel->weight[i] = {1, 0};
  }
  Extent<StaticBound> extent;
  kernel->run(extent, !table.midpoint);
  StaticBound coefficient = larger(extent.lowest, extent.highest);
  for (int k = 0; k < K::corner_count; ++k) coefficient = larger(coefficient, extent.corner[k]);
  Errors errors;
  errors.coefficient = error_of(coefficient);
  StaticBound largest = coefficient;
  if (!table.midpoint) {
    const StaticBound cone = larger(larger(extent.p, extent.q), larger(extent.r, extent.s));
    errors.cone = error_of(cone);
    largest = larger(largest, cone);
    if constexpr (!K::is_square) {
      const StaticBound mixed = kernel->mixed();
      errors.mixed = error_of(mixed);
      largest = larger(largest, mixed);
    }
  }
  // Squares of such numbers in units up to 2^280 do not overflow.
  if (!(largest.magnitude < 0x1p200 && largest.error < 1)) return std::nullopt;
  return errors;
}

std::optional<Errors> static_errors_of(const BlockTable& table) {
  switch (table.kind) {
    case Kind::triangle: return static_errors<Kind::triangle>(table);
    case Kind::square: return static_errors<Kind::square>(table);
    case Kind::rational_triangle: return static_errors<Kind::rational_triangle>(table);
  }
  return std::nullopt;
}

OwnedTable build(Shape shape, Basis basis, bool rational) {
  OwnedTable owned;
  const bool square = shape.domain == Domain::square;
  const int degree = std::max(shape.degree(0), shape.degree(1));
  if (degree > max_block_degree || (rational && (square || basis == Basis::lagrange))) return owned;
  BlockTable& table = owned.table;
  table.kind = square ? Kind::square : rational ? Kind::rational_triangle : Kind::triangle;
  table.p = shape.degree(0);
  table.q = shape.degree(1);
  table.lagrange = basis == Basis::lagrange;
  table.midpoint = !rational && degree <= (square ? 1 : 2);
  if (table.lagrange) add_basis_change(owned, shape);
  owned.along_u = multinomial_doubles(shape.raised(0, -1));
  owned.along_v = multinomial_doubles(shape.raised(shape.factor_count() - 1, -1));
  owned.determinant = inverse_multinomials(numerator_shape(shape, rational), degree_factor(shape));
  if (rational) owned.columns = inverse_multinomials(Shape::triangle(2 * shape.degree(0) - 1), 1);
  table.row_start = owned.row_start.data();
  table.column = owned.column.data();
  table.value = owned.value.data();
  table.along_u = owned.along_u.data();
  table.along_v = owned.along_v.data();
  table.columns = owned.columns.data();
  table.determinant = owned.determinant.data();
  if (const auto errors = static_errors_of(table)) {
    table.errors = *errors;
    owned.usable = true;
  }
  return owned;
}

}  // namespace

const BlockTable* find_block_table(Shape shape, Basis basis, bool rational) {
  static TableCache<OwnedTable> caches[2][2];
  const OwnedTable& owned = caches[basis == Basis::lagrange][rational].get(
      shape, [&](Shape s) { return build(s, basis, rational); });
  return owned.usable ? &owned.table : nullptr;
}

}  // namespace bezcert::batch
