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
int bisection_shift(Shape shape, int factor) {
  return std::is_same_v<T, Interval> ? 0 : shape.degree(factor);
}

/// The factor that pieces of some depth are cut in: each in turn.
inline int factor_to_cut(Domain domain, int depth) { return depth % domain.factor_count(); }

/// The two halves of a polynomial, cut in one factor. Square: cut at u = 1/2 (factor 0) or v = 1/2 (1), lower
/// half first. Triangle (A, B, C): cut from C to the middle M of AB into (C, A, M) and (B, C, M), so that the
/// next cut again halves the first two corners' side and the newest vertex is last. Precondition: the factor
/// is a segment or a triangle (tetrahedra need another rule).
template <class T>
std::pair<Polynomial<T>, Polynomial<T>> bisect(const Polynomial<T>& f, int factor) {
  Polynomial<T> left = f;
  Polynomial<T> right = f;
  const int shift = bisection_shift<T>(f.shape, factor);
  detail::for_each_line(f.shape, factor, [&](std::size_t first, std::size_t stride, std::size_t count) {
    detail::bisect_line(left.coefficients, right.coefficients, first, stride, count, shift);
  });
  if (f.shape.domain.simplex(factor) == 1) return {std::move(left), std::move(right)};
  // left is over (A, M, C), right over (M, B, C): turn them to (C, A, M) and (B, C, M).
  Polynomial<T> first(f.shape);
  Polynomial<T> second(f.shape);
  const Shape triangle = Shape::triangle(f.shape.degree(factor));
  detail::for_each_copy(f.shape, f.shape, factor, [&](std::size_t start, std::size_t, std::size_t stride) {
    const auto at = [&](int r, int c) { return start + coefficient_index(triangle, r, c) * stride; };
    for_each_simplex_point(2, triangle.degree(0), [&](const SimplexPoint& point) {
      const auto [a, c, r, unused] = point.exponents;  // of the old corners
      first.coefficients[at(c, a)] = std::move(left.coefficients[at(r, c)]);
      second.coefficients[at(a, r)] = std::move(right.coefficients[at(r, c)]);
    });
  });
  return {std::move(first), std::move(second)};
}

}  // namespace bezcert
