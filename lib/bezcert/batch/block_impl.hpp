// The block function, included by one file an instruction set (block_*.cpp).
//
// Error bounds of the table are in units of X Y (rational: of X Y W^4 for cone and mixed terms, X Y W^3 for
// the determinant), with X, Y, W the largest |coordinate relative to the first node|, and weight, of the
// element: those numbers are computed, and are inputs of magnitude at most 1 in these units. Elements with X
// or Y outside [2^-100, 2^100], or W outside [2^-20, 2^20], are not settled: units stay within 2^-280 and
// 2^280, as static_bound.hpp needs, and nothing overflows. Infinities and NaN fail this test or the next:
// every comparison is written so that NaN settles nothing.
#pragma once

#include "bezcert/batch/kernel.hpp"

namespace bezcert::batch {
namespace {

using Mask = decltype(Lanes::Vector{} < Lanes::Vector{});

BEZCERT_INLINE Mask within(const Lanes& value, double low, double high) {
  return (value.v >= low) & (value.v <= high);
}

BEZCERT_INLINE bool any(const Mask& mask) {
  bool result = false;
  for (int k = 0; k < lane_count; ++k) result |= mask[k] != 0;
  return result;
}

BEZCERT_INLINE Lanes same(double value) { return Lanes{} + Lanes{Lanes::Vector{} + value}; }

/// Element by element: each has a lane.
BEZCERT_INLINE void gather(const double* from, const std::uint32_t* connectivity, const std::size_t* first,
                           int count, Lanes* to) {
  for (int k = 0; k < lane_count; ++k) {
    const std::uint32_t* nodes = connectivity + first[k];
    for (int i = 0; i < count; ++i) to[i].v[k] = from[nodes[i]];
  }
}

/// Coordinates relative to the first; returns the largest magnitude.
BEZCERT_INLINE Lanes make_relative(Lanes* values, int count) {
  const Lanes first = values[0];
  Lanes largest{};
  values[0] = Lanes{};
  for (int i = 1; i < count; ++i) {
    values[i] = values[i] - first;
    largest = larger(largest, absolute(values[i]));
  }
  return largest;
}

BEZCERT_INLINE void store(const Lanes& value, double* to) { __builtin_memcpy(to, &value, sizeof value); }

// The four enclosures from the coefficients. Slack for the roundings of the divisions: a quotient of positive
// numbers by a product of three has 3 roundings, less than 2^-48 together.
template <Kind kind, int corners>
BEZCERT_INLINE void write_bounds(const Extent<Lanes>& extent, const Lanes& error, const Lanes* weights,
                                 int degree, BlockResult& result) {
  const auto write = [&](BlockResult::Bound bound, const Lanes& lower, const Lanes& upper) {
    store(lower, result.lower[bound]);
    store(upper, result.upper[bound]);
  };
  if constexpr (kind != Kind::rational_triangle) {
    Lanes low = extent.corner[0], high = extent.corner[0];
    for (int k = 1; k < corners; ++k) {
      low = smaller(low, extent.corner[k]);
      high = larger(high, extent.corner[k]);
    }
    write(BlockResult::min_lower, extent.lowest - error, extent.lowest + error);
    write(BlockResult::min_upper, low - error, low + error);
    write(BlockResult::max_lower, high - error, high + error);
    write(BlockResult::max_upper, extent.highest - error, extent.highest + error);
  } else {
    constexpr double down = 1 - 0x1p-48, up = 1 + 0x1p-48;
    const int at[3] = {0, degree, (degree + 1) * (degree + 2) / 2 - 1};
    Lanes thin = weights[0], thick = weights[0];
    for (int i = 1; i <= at[2]; ++i) {
      thin = smaller(thin, weights[i]);
      thick = larger(thick, weights[i]);
    }
    const auto cube = [](const Lanes& w) { return w * w * w; };
    const Lanes thick3 = cube(thick), thin3 = cube(thin);
    write(BlockResult::min_lower, (extent.lowest - error) / thick3 * down,
          (extent.lowest + error) / thick3 * up);
    write(BlockResult::max_upper, (extent.highest - error) / thin3 * down,
          (extent.highest + error) / thin3 * up);
    Lanes low[2], high[2];
    for (int k = 0; k < 3; ++k) {
      const Lanes w3 = cube(weights[at[k]]);
      const Lanes lower = (extent.corner[k] - error) / w3 * down;
      const Lanes upper = (extent.corner[k] + error) / w3 * up;
      low[0] = k == 0 ? lower : smaller(low[0], lower);
      low[1] = k == 0 ? upper : smaller(low[1], upper);
      high[0] = k == 0 ? lower : larger(high[0], lower);
      high[1] = k == 0 ? upper : larger(high[1], upper);
    }
    write(BlockResult::min_upper, low[0], low[1]);
    write(BlockResult::max_lower, high[0], high[1]);
  }
}

template <Kind kind, int P>
void run(const BlockTable& table, const Nodes& nodes, const std::size_t* first, BlockResult& result) {
  using K = Kernel<Lanes, kind, P>;
  K kernel(table);
  const int count = kernel.point_count();
  if (count < 3) __builtin_unreachable();  // known to all loops below
  gather(nodes.x, nodes.connectivity, first, count, kernel.node_x);
  gather(nodes.y, nodes.connectivity, first, count, kernel.node_y);
  const Lanes largest_x = make_relative(kernel.node_x, count);
  const Lanes largest_y = make_relative(kernel.node_y, count);
  Mask settled = within(largest_x, 0x1p-100, 0x1p100) & within(largest_y, 0x1p-100, 0x1p100);
  Lanes unit = largest_x * largest_y;
  Lanes hull_unit = unit;
  if constexpr (K::is_rational) {
    gather(nodes.weight, nodes.connectivity, first, count, kernel.weight);
    Lanes largest = kernel.weight[0], smallest = kernel.weight[0];
    for (int i = 1; i < count; ++i) {
      largest = larger(largest, kernel.weight[i]);
      smallest = smaller(smallest, kernel.weight[i]);
    }
    settled &= within(largest, 0x1p-20, 0x1p20) & within(smallest, 0x1p-40, 0x1p20);
    unit = unit * (largest * largest * largest);
    hull_unit = unit * largest;
  }
  Extent<Lanes> extent;
  kernel.run(extent, !table.midpoint);
  const Lanes error = unit * table.errors.coefficient;
  settled &= (extent.lowest - error).v > 0.0;
  if (!table.midpoint) {
    const Lanes e = hull_unit * table.errors.cone;
    const Lanes p = extent.p - e, q = extent.q + e, r = extent.r + e, s = extent.s - e;
    // The factor covers the roundings of both products, which do not underflow: q r >= e^2.
    Mask hull = (p.v > 0.0) & (s.v > 0.0) & ((p * s).v > (q * r * (1 + 0x1p-48)).v);
    if constexpr (!K::is_square) {
      if (any(settled & ~hull)) hull |= (kernel.mixed() - hull_unit * table.errors.mixed).v > 0.0;
    }
    settled &= hull;
  }
  for (int k = 0; k < lane_count; ++k) result.settled[k] = settled[k] != 0;
  write_bounds<kind, K::corner_count>(extent, error, K::is_rational ? kernel.weight : nullptr, table.p,
                                      result);
}

template <Kind kind>
BEZCERT_INLINE void run_degree(const BlockTable& table, const Nodes& nodes, const std::size_t* first,
                               BlockResult& result) {
  if (table.p == table.q || kind != Kind::square) {
    switch (table.p) {
      case 1: return run<kind, 1>(table, nodes, first, result);
      case 2: return run<kind, 2>(table, nodes, first, result);
      case 3: return run<kind, 3>(table, nodes, first, result);
      case 4: return run<kind, 4>(table, nodes, first, result);
      default: break;
    }
    // Above, the rational kernel is mostly loops, and code that is made for one degree only gets long.
    if constexpr (kind != Kind::rational_triangle) {
      if (table.p == 5) return run<kind, 5>(table, nodes, first, result);
      if (table.p == 6) return run<kind, 6>(table, nodes, first, result);
    }
  }
  run<kind, 0>(table, nodes, first, result);
}

BEZCERT_INLINE void run_block(const BlockTable& table, const Nodes& nodes, const std::size_t* first,
                              BlockResult& result) {
  switch (table.kind) {
    case Kind::triangle: return run_degree<Kind::triangle>(table, nodes, first, result);
    case Kind::square: return run_degree<Kind::square>(table, nodes, first, result);
    case Kind::rational_triangle: return run_degree<Kind::rational_triangle>(table, nodes, first, result);
  }
}

}  // namespace
}  // namespace bezcert::batch
