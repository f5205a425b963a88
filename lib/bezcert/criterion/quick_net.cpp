#include "bezcert/criterion/quick_net.hpp"

#include "bezcert/bernstein/multinomial.hpp"
#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/element/lagrange.hpp"
#include "bezcert/number/filtered_sign.hpp"
#include "bezcert/number/static_bound.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <type_traits>

namespace bezcert {

// Tables of one degree and basis: the basis change row by row, the products that make up N, and error bounds
// in units of the square of the largest coordinate.
struct QuickNetTables {
  struct Entry {
    std::uint32_t column;
    std::int64_t exact;
    double number;
  };
  struct Product {  // factor * (corner 0 to 1 at i) x (corner 0 to 2 at j)
    std::uint16_t i0, i1, j0, j2;
    double factor;
  };
  struct Coefficient {
    std::uint32_t end;  // of its products
    double error;
  };
  bool fits = true;
  std::vector<std::uint32_t> row_end;
  std::vector<Entry> entries;
  std::int64_t largest_row = 1;
  double error = 0;  // of a cross or dot product of two differences of control points
  std::vector<Product> products;
  std::vector<Coefficient> coefficients;
  std::array<std::size_t, 3> corners{};  // positions among the coefficients
};

namespace {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;
using Tables = QuickNetTables;

constexpr std::size_t most_coefficients = std::size_t{2 * QuickNet::max_degree - 1} * QuickNet::max_degree;

template <class T>
struct Points {
  std::array<T, QuickNet::max_count>&x, &y;
};

// Control points from nodes, over double, StaticBound or Int128.
template <class T>
void control_points(const Tables& tables, const Points<T>& nodes, const Points<T>& result) {
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < tables.row_end.size(); ++i) {
    T x{}, y{};
    for (; at < tables.row_end[i]; ++at) {
      const Tables::Entry& entry = tables.entries[at];
      const auto& factor =
          std::get < std::is_same_v<T, Int128> ? 0 : 1 > (std::tie(entry.exact, entry.number));
      x = x + nodes.x[entry.column] * factor;
      y = y + nodes.y[entry.column] * factor;
    }
    result.x[i] = x;
    result.y[i] = y;
  }
}

// A coefficient of N from its products, which begin at `at`.
template <class T, class Between>
T coefficient_of(const Tables& tables, std::uint32_t at, std::uint32_t end, Between between) {
  T sum{};
  for (; at < end; ++at) {
    const Tables::Product& p = tables.products[at];
    sum = sum + cross(between(p.i0, p.i1), between(p.j0, p.j2)) * p.factor;
  }
  return sum;
}

// N = (F_1 - F_0) x (F_2 - F_0): coefficient k is a mean of products of coefficients i + j = k, with
// factors C_i C_j (docs/jacobian.md).
void add_numerator(Shape shape, Tables& result) {
  const Shape sub = Shape::triangle(shape.degree(0) - 1), whole = Shape::triangle(2 * sub.degree(0));
  const std::vector<Integer> factors = multinomials(sub);
  const auto at = [&](int r, int c) { return static_cast<std::uint16_t>(coefficient_index(shape, r, c)); };
  for (int r = 0; r < row_count(whole); ++r) {
    for (int c = 0; c < column_count(whole, r); ++c) {
      for (int ri = 0; ri <= std::min(r, sub.degree(0)); ++ri) {
        for (int ci = 0; ci < column_count(sub, ri) && ci <= c; ++ci) {
          const int rj = r - ri, cj = c - ci;
          if (rj > sub.degree(0) || cj >= column_count(sub, rj)) continue;
          const Integer factor =
              factors[coefficient_index(sub, ri, ci)] * factors[coefficient_index(sub, rj, cj)];
          result.products.push_back(
              {at(ri, ci), at(ri, ci + 1), at(rj, cj), at(rj + 1, cj), factor.convert_to<double>()});
        }
      }
      result.coefficients.push_back({static_cast<std::uint32_t>(result.products.size()), 0});
    }
  }
  std::ranges::copy(corner_indices(whole), result.corners.begin());
}

// The bounds, for nodes of coordinates up to 1 relative to the first.
void add_errors(Tables& result) {
  std::array<StaticBound, QuickNet::max_count> nodes, points;
  nodes.fill(unit_difference());
  control_points<StaticBound>(result, {nodes, nodes}, {points, points});
  StaticBound largest;
  for (std::size_t i = 0; i < result.row_end.size(); ++i) largest = larger(largest, points[i]);
  const StaticBound difference = largest - largest;
  const Vector2<StaticBound> vector{difference, difference};
  result.error = error_of(larger(cross(vector, vector), dot(vector, vector)));
  std::uint32_t at = 0;
  for (Tables::Coefficient& coefficient : result.coefficients) {
    coefficient.error = error_of(coefficient_of<StaticBound>(
        result, at, coefficient.end, [&](std::size_t i, std::size_t j) -> Vector2<StaticBound> {
          return {points[j] - points[i], points[j] - points[i]};
        }));
    at = coefficient.end;
  }
}

Tables build(Shape shape, Basis basis) {
  Tables result;
  constexpr std::int64_t limit = std::int64_t{1} << 40;
  const auto add_entry = [&](std::size_t column, std::int64_t value) {
    result.entries.push_back({static_cast<std::uint32_t>(column), value, static_cast<double>(value)});
  };
  const BasisChange& change = lagrange_to_bernstein(shape);
  for (std::size_t i = 0; i < change.rows.size(); ++i) {
    std::int64_t sum = 0;
    if (basis == Basis::bernstein) add_entry(i, 1);
    for (const auto& entry : change.rows[i]) {
      if (basis == Basis::bernstein) break;
      if (abs(entry.exact) > limit) {
        result.fits = false;
        return result;
      }
      const auto value = entry.exact.convert_to<std::int64_t>();
      add_entry(entry.column, value);
      sum += std::abs(value);
    }
    result.row_end.push_back(static_cast<std::uint32_t>(result.entries.size()));
    result.largest_row = std::max(result.largest_row, sum);
  }
  add_numerator(shape, result);
  add_errors(result);
  return result;
}

const Tables& tables_of(Shape shape, Basis basis) {
  static TableCache<Tables> caches[2];
  return caches[basis == Basis::lagrange].get(shape, [&](Shape s) { return build(s, basis); });
}

// x = mantissa * 2^exponent for a finite x.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  auto mantissa = static_cast<std::int64_t>(bits & ((std::uint64_t{1} << 52) - 1));
  if (field > 0) mantissa |= std::int64_t{1} << 52;
  return {(bits >> 63) != 0 ? -mantissa : mantissa, std::max(field, 1) - 1075};
}

Int128 scaled(double x, int exponent) {
  if (x == 0) return 0;
  const Parts parts = parts_of(x);
  const int shift = parts.exponent - exponent;
  // Shifted out bits are 0: the exponent is at most that of the lowest bit of any number.
  return shift >= 0 ? Int128{parts.mantissa} * (Int128{1} << shift) : Int128{parts.mantissa >> -shift};
}

struct Int256 {
  Int128 high;
  UInt128 low;
  auto operator<=>(const Int256&) const = default;
};

// Of numbers below 2^126 in size; high halves are signed.
Int256 product(Int128 a, Int128 b) {
  constexpr UInt128 mask = ~std::uint64_t{0};
  const UInt128 a0 = a & mask, b0 = b & mask, p00 = a0 * b0;
  const Int128 a1 = a >> 64, b1 = b >> 64;
  const Int128 p01 = static_cast<Int128>(a0) * b1, p10 = static_cast<Int128>(b0) * a1;
  const UInt128 middle = (p00 >> 64) + (p01 & mask) + (p10 & mask);
  return {a1 * b1 + (p01 >> 64) + (p10 >> 64) + static_cast<Int128>(middle >> 64),
          (middle << 64) | (p00 & mask)};
}

// The sign of a b - c d.
int compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  const auto order = product(a, b) <=> product(c, d);
  return (order > 0) - (order < 0);
}

}  // namespace

bool QuickNet::load(Shape shape, Basis basis, std::span<const double> x, std::span<const double> y,
                    std::span<const std::uint32_t> nodes) {
  if (shape.domain != Domain::triangle || shape.degree(0) < 1 || shape.degree(0) > max_degree) return false;
  tables_ = &tables_of(shape, basis);
  if (!tables_->fits) return false;
  degree_ = shape.degree(0);

  // The exponents: integers over 2^exponent_ are to have less than 125 bits as control points.
  int lowest = 4096, highest = -4096;
  double size = 0;
  std::array<double, max_count> dx, dy;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    for (const double number : {x[nodes[k]], y[nodes[k]]}) {
      if (number == 0) continue;
      const Parts parts = parts_of(number);
      const int bits = std::bit_width(static_cast<std::uint64_t>(std::abs(parts.mantissa)));
      lowest = std::min(
          lowest, parts.exponent + std::countr_zero(static_cast<std::uint64_t>(std::abs(parts.mantissa))));
      highest = std::max(highest, parts.exponent + bits);
    }
    dx[k] = x[nodes[k]] - x[nodes[0]];
    dy[k] = y[nodes[k]] - y[nodes[0]];
    size = std::max({size, std::abs(dx[k]), std::abs(dy[k])});
  }
  if (highest - lowest + 1 + std::bit_width(static_cast<std::uint64_t>(tables_->largest_row)) > 124)
    return false;
  // Magnitudes in units are below 2^128 (entries up to 2^40, degrees up to 10): nothing overflows.
  unit_ = size * size;
  if (!(unit_ > least_unit && unit_ < 0x1p800)) return false;
  control_points<double>(*tables_, {dx, dy}, {x_, y_});
  bound_ = tables_->error * unit_;
  exponent_ = lowest;
  all_x_ = x;
  all_y_ = y;
  nodes_ = nodes;
  has_exact_ = false;
  return true;
}

void QuickNet::make_exact() const {
  if (has_exact_) return;
  has_exact_ = true;
  const auto relative = [&](std::span<const double> numbers, auto& result) {
    const Int128 origin = scaled(numbers[nodes_[0]], exponent_);
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      result[k] = scaled(numbers[nodes_[k]], exponent_) - origin;
    }
  };
  std::array<Int128, max_count> x, y;
  relative(all_x_, x);
  relative(all_y_, y);
  control_points<Int128>(*tables_, {x, y}, {exact_x_, exact_y_});
}

int QuickNet::exact_turn(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
  make_exact();
  return compare_products(exact_x_[j] - exact_x_[i], exact_y_[l] - exact_y_[k], exact_y_[j] - exact_y_[i],
                          exact_x_[l] - exact_x_[k]);
}

int QuickNet::exact_forward(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
  make_exact();
  return compare_products(exact_x_[j] - exact_x_[i], exact_x_[l] - exact_x_[k], exact_y_[i] - exact_y_[j],
                          exact_y_[l] - exact_y_[k]);
}

std::optional<PieceSigns> QuickNet::numerator_signs() const {
  std::array<signed char, most_coefficients> signs;
  PieceSigns result{true, true, {}};
  std::uint32_t at = 0;
  for (std::size_t k = 0; k < tables_->coefficients.size(); ++k) {
    const Tables::Coefficient& coefficient = tables_->coefficients[k];
    const auto value = coefficient_of<double>(*tables_, at, coefficient.end,
                                              [&](std::size_t i, std::size_t j) { return between(i, j); });
    const auto sign = certain_sign(value, coefficient.error * unit_);
    if (!sign) return std::nullopt;
    signs[k] = static_cast<signed char>(*sign);
    (*sign > 0 ? result.none_positive : result.none_negative) = false;
    at = coefficient.end;
  }
  for (std::size_t k = 0; k < 3; ++k) result.corner[k] = signs[tables_->corners[k]];
  return result;
}

}  // namespace bezcert
