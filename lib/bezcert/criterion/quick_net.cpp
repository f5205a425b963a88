#include "bezcert/criterion/quick_net.hpp"

#include "bezcert/bernstein/multinomial.hpp"
#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bezcert {
namespace {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

// Tables of one degree: the basis change row by row, and the products that make up N.
struct Tables {
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
    double sum;         // of the factors of its products
    bool corner;
  };
  bool fits = true;
  std::vector<std::uint32_t> row_end;
  std::vector<Entry> entries;
  std::int64_t largest_row = 1;
  std::vector<Product> products;
  std::vector<Coefficient> coefficients;
};

Tables build(Shape shape) {
  Tables result;
  constexpr std::int64_t limit = std::int64_t{1} << 40;
  for (const auto& row : lagrange_to_bernstein(shape).rows) {
    std::int64_t sum = 0;
    for (const auto& entry : row) {
      if (abs(entry.exact) > limit) {
        result.fits = false;
        return result;
      }
      const auto value = entry.exact.convert_to<std::int64_t>();
      result.entries.push_back({static_cast<std::uint32_t>(entry.column), value, static_cast<double>(value)});
      sum += std::abs(value);
    }
    result.row_end.push_back(static_cast<std::uint32_t>(result.entries.size()));
    result.largest_row = std::max(result.largest_row, sum);
  }
  // N = (F_1 - F_0) x (F_2 - F_0): coefficient k is a mean of products of coefficients i + j = k, with
  // factors C_i C_j (docs/jacobian.md).
  const Shape sub = Shape::triangle(shape.degree(0) - 1), whole = Shape::triangle(2 * sub.degree(0));
  const std::vector<Integer> factors = multinomials(sub);
  const std::vector<std::size_t> corners = corner_indices(whole);
  const auto at = [&](int r, int c) { return static_cast<std::uint16_t>(coefficient_index(shape, r, c)); };
  for (int r = 0; r < row_count(whole); ++r) {
    for (int c = 0; c < column_count(whole, r); ++c) {
      double sum = 0;
      for (int ri = 0; ri <= std::min(r, sub.degree(0)); ++ri) {
        for (int ci = 0; ci < column_count(sub, ri) && ci <= c; ++ci) {
          const int rj = r - ri, cj = c - ci;
          if (rj > sub.degree(0) || cj >= column_count(sub, rj)) continue;
          const double factor =
              Integer(factors[coefficient_index(sub, ri, ci)] * factors[coefficient_index(sub, rj, cj)])
                  .convert_to<double>();
          sum += factor;
          result.products.push_back({at(ri, ci), at(ri, ci + 1), at(rj, cj), at(rj + 1, cj), factor});
        }
      }
      const std::size_t index = coefficient_index(whole, r, c);
      result.coefficients.push_back({static_cast<std::uint32_t>(result.products.size()), sum,
                                     std::find(corners.begin(), corners.end(), index) != corners.end()});
    }
  }
  return result;
}

const Tables& tables_of(Shape shape) {
  static TableCache<Tables> cache;
  return cache.get(shape, build);
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

int sign_of(Int128 x) { return (x > 0) - (x < 0); }

struct UInt256 {
  UInt128 high, low;
  auto operator<=>(const UInt256&) const = default;
};

UInt256 product(UInt128 a, UInt128 b) {
  constexpr UInt128 mask = ~std::uint64_t{0};
  const UInt128 a0 = a & mask, a1 = a >> 64, b0 = b & mask, b1 = b >> 64;
  const UInt128 p00 = a0 * b0, p01 = a0 * b1, p10 = a1 * b0, p11 = a1 * b1;
  const UInt128 middle = (p00 >> 64) + (p01 & mask) + (p10 & mask);
  return {p11 + (p01 >> 64) + (p10 >> 64) + (middle >> 64), (middle << 64) | (p00 & mask)};
}

UInt128 size_of(Int128 x) { return x < 0 ? -static_cast<UInt128>(x) : static_cast<UInt128>(x); }

// The sign of a b - c d.
int compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  const int first = sign_of(a) * sign_of(b), second = sign_of(c) * sign_of(d);
  if (first != second) return first > second ? 1 : -1;
  if (first == 0) return 0;
  const UInt256 p = product(size_of(a), size_of(b)), q = product(size_of(c), size_of(d));
  if (p == q) return 0;
  return (p > q) == (first > 0) ? 1 : -1;
}

}  // namespace

bool QuickNet::load(Shape shape, Basis basis, std::span<const double> x, std::span<const double> y,
                    std::span<const std::uint32_t> nodes) {
  if (shape.domain != Domain::triangle || shape.degree(0) < 1 || shape.degree(0) > max_degree) return false;
  shape_ = shape;
  basis_ = basis;
  count_ = nodes.size();
  const Tables& tables = tables_of(shape);
  if (!tables.fits) return false;

  // The exponents: integers over 2^exponent_ are to have less than 125 bits as control points.
  int lowest = 4096, highest = -4096;
  double size = 0;
  std::array<double, max_count> dx, dy;
  for (std::size_t k = 0; k < count_; ++k) {
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
  const std::int64_t largest_row = basis == Basis::lagrange ? tables.largest_row : 1;
  if (highest - lowest + 1 + std::bit_width(static_cast<std::uint64_t>(largest_row)) > 124) return false;
  exponent_ = lowest;

  if (basis == Basis::bernstein) {
    std::copy_n(dx.begin(), count_, x_.begin());
    std::copy_n(dy.begin(), count_, y_.begin());
  } else {
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      double sum_x = 0, sum_y = 0;
      for (; at < tables.row_end[i]; ++at) {
        const Tables::Entry& entry = tables.entries[at];
        sum_x += entry.number * dx[entry.column];
        sum_y += entry.number * dy[entry.column];
      }
      x_[i] = sum_x;
      y_[i] = sum_y;
    }
  }
  const double s = size * static_cast<double>(largest_row);
  if (!(s >= 0x1p-400 && s <= 0x1p400)) return false;
  bound_ = 64 * static_cast<double>(count_ + 4) * 0x1p-52 * s * s;
  all_x_ = x;
  all_y_ = y;
  nodes_ = nodes;
  has_exact_ = false;
  return true;
}

void QuickNet::make_exact() const {
  if (has_exact_) return;
  has_exact_ = true;
  const Tables& tables = tables_of(shape_);
  for (const bool first : {true, false}) {
    const std::span<const double> numbers = first ? all_x_ : all_y_;
    auto& result = first ? exact_x_ : exact_y_;
    std::array<Int128, max_count> nodes;
    const Int128 origin = scaled(numbers[nodes_[0]], exponent_);
    for (std::size_t k = 0; k < count_; ++k) nodes[k] = scaled(numbers[nodes_[k]], exponent_) - origin;
    if (basis_ == Basis::bernstein) {
      std::copy_n(nodes.begin(), count_, result.begin());
      continue;
    }
    std::uint32_t at = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      Int128 sum = 0;
      for (; at < tables.row_end[i]; ++at) sum += tables.entries[at].exact * nodes[tables.entries[at].column];
      result[i] = sum;
    }
  }
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

// A coefficient times the sum C of its factors is a sum of at most m = count products, each wrong by at most
// B (header); their sizes are below 9 S^2, so that summing adds at most 9 (m + 2) v S^2 C < B C: 2 B C in
// all.
QuickNet::NumeratorSigns QuickNet::numerator_signs() const {
  const Tables& tables = tables_of(shape_);
  NumeratorSigns result;
  result.certain = true;
  std::uint32_t at = 0;
  for (const Tables::Coefficient& coefficient : tables.coefficients) {
    double sum = 0;
    for (; at < coefficient.end; ++at) {
      const Tables::Product& p = tables.products[at];
      sum += p.factor *
             ((x_[p.i1] - x_[p.i0]) * (y_[p.j2] - y_[p.j0]) - (y_[p.i1] - y_[p.i0]) * (x_[p.j2] - x_[p.j0]));
    }
    const double bound = 2 * bound_ * coefficient.sum;
    const bool positive = sum > bound;
    if (!positive && !(sum < -bound)) result.certain = false;
    if (!positive) {
      result.all_positive = false;
      if (coefficient.corner) result.corners_positive = false;
    }
  }
  return result;
}

}  // namespace bezcert
