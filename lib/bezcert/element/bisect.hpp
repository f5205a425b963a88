// Halving polynomials on the pieces of newest vertex bisection.
//
// Segment lines are halved by de Casteljau at 1/2. Intervals are halved exactly; integers are not divided:
// their halves come out multiplied by 2^degree (`bisection_shift`), one factor for all coefficients.
#pragma once

#include "bezcert/bernstein/halve.hpp"
#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/number/interval.hpp"

#include <utility>

namespace bezcert {

/// The power of two that `bisect` multiplies integer coefficients by (0 for intervals).
template <class T>
int bisection_shift(Shape shape, int direction) {
  if constexpr (std::is_same_v<T, Interval>) return 0;
  if (shape.domain == Domain::square && direction == 1) return shape.q;
  return shape.p;
}

/// The two halves of a polynomial. Square: cut at u = 1/2 (direction 0) or v = 1/2 (1), lower half first.
/// Triangle (A, B, C): cut from C to the middle M of AB into (C, A, M) and (B, C, M), so that the next cut
/// again halves the first two corners' side and the newest vertex is last.
template <class T>
std::pair<Polynomial<T>, Polynomial<T>> bisect(const Polynomial<T>& f, int direction) {
  Polynomial<T> left = f;
  Polynomial<T> right = f;
  const int shift = bisection_shift<T>(f.shape, direction);
  if (f.shape.domain != Domain::triangle) {
    detail::for_each_line(f.shape, direction, [&](std::size_t first, std::size_t stride, std::size_t count) {
      detail::bisect_line(left.coefficients, right.coefficients, first, stride, count, shift);
    });
    return {std::move(left), std::move(right)};
  }
  const int degree = f.shape.p;
  for (int r = 0; r <= degree; ++r) {
    detail::bisect_line(left.coefficients, right.coefficients, coefficient_index(f.shape, r, 0), 1,
                        static_cast<std::size_t>(degree - r) + 1, shift);
  }
  // left is over (A, M, C), right over (M, B, C): turn them to (C, A, M) and (B, C, M).
  Polynomial<T> first(f.shape);
  Polynomial<T> second(f.shape);
  for (int r = 0; r <= degree; ++r) {
    for (int c = 0; c <= degree - r; ++c) {
      const int a = degree - r - c;  // exponents (a, c, r) of the old corners
      first.at(c, a) = std::move(left.at(r, c));
      second.at(a, r) = std::move(right.at(r, c));
    }
  }
  return {std::move(first), std::move(second)};
}

}  // namespace bezcert
