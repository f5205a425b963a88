// Halving lines of Bernstein coefficients: de Casteljau at 1/2.
//
// Intervals are halved exactly; integers are not divided, their halves come out multiplied by a power of two.
#pragma once

#include "bezcert/number/interval.hpp"
#include "bezcert/number/rational.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace bezcert {

namespace detail {

// `values` at first, first + stride, ...: the left half replaces them, the right half goes to `right`.
template <class T>
void bisect_line(std::vector<T>& left, std::vector<T>& right, std::size_t first, std::size_t stride,
                 std::size_t count, int shift) {
  const auto place = [&](std::size_t i) { return first + i * stride; };
  // Works in `right`, from the left end: after level k, right[0 .. count-1-k] are the points of that level.
  for (std::size_t i = 0; i < count; ++i) right[place(i)] = left[place(i)];
  for (std::size_t level = 0; level < count; ++level) {
    left[place(level)] = right[place(0)];
    for (std::size_t i = 0; i + 1 < count - level; ++i) {
      T& value = right[place(i)];
      value += right[place(i + 1)];
      if constexpr (std::is_same_v<T, Interval>) value = value * Interval(0.5);
    }
    // Points of level k carry 2^k: bring left[k] to 2^shift.
    if constexpr (!std::is_same_v<T, Interval>) {
      left[place(level)] <<= static_cast<unsigned>(shift) - static_cast<unsigned>(level);
    }
  }
  if constexpr (!std::is_same_v<T, Interval>) {
    // right[i] was changed count-1-i times.
    for (std::size_t i = 0; i < count; ++i) {
      right[place(i)] <<= static_cast<unsigned>(shift) - static_cast<unsigned>(count - 1 - i);
    }
  }
}

}  // namespace detail

/// The coefficients over the first and the second half, from those over the whole; integers multiplied by
/// 2^degree. Intervals: while a RoundUp lives.
template <class T>
std::pair<std::vector<T>, std::vector<T>> halve(const std::vector<T>& values) {
  std::vector<T> left = values;
  std::vector<T> right(values.size());
  detail::bisect_line(left, right, 0, 1, values.size(), static_cast<int>(values.size()) - 1);
  return {std::move(left), std::move(right)};
}

/// Divides by the largest common power of two, for where a positive factor does not matter: halving integers
/// again and again would let them grow.
inline void shorten(std::vector<Integer>& values) {
  mp_bitcnt_t common = ~mp_bitcnt_t{0};
  for (const Integer& value : values) {
    if (!value.is_zero()) common = std::min(common, mpz_scan1(value.backend().data(), 0));
  }
  if (common == 0 || common == ~mp_bitcnt_t{0}) return;
  for (Integer& value : values) {
    mpz_tdiv_q_2exp(value.backend().data(), value.backend().data(), common);
  }
}

}  // namespace bezcert
