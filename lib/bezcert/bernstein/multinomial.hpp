// Multinomial factors of the Bernstein basis, and products without division.
//
// B_m = C(m) x^m with the multinomial C(m) = degree! / m! (the product of the factors' multinomials), so
// "scaled" coefficients c_m C(m) multiply by plain convolution. That is how products stay in integers.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/number/rational.hpp"

#include <vector>

namespace bezcert {

template <class T>
struct Polynomial;

/// C(n, k); 0 outside 0 <= k <= n.
Integer binomial(int n, int k);

/// The multinomial of every coefficient of a shape, in coefficient order.
std::vector<Integer> multinomials(Shape shape);

/// Product of two polynomials given by scaled coefficients; the result has scaled coefficients too.
template <class T>
Polynomial<T> convolve(const Polynomial<T>& f, const Polynomial<T>& g);

/// sum += f * g in scaled coefficients. Precondition: sum.shape == product_shape(f.shape, g.shape).
template <class T>
void add_convolution(Polynomial<T>& sum, const Polynomial<T>& f, const Polynomial<T>& g) {
  const ShapeRows of_f(f.shape), of_g(g.shape), of_sum(sum.shape);
  const T* factor = f.coefficients.data();
  for (int a = 0; a < of_f.layer_count(); ++a) {
    for (int r = 0; r < of_f.row_count(a); ++r) {
      const int columns = of_f.column_count(r, a);
      const T* from = g.coefficients.data();
      for (int b = 0; b < of_g.layer_count(); ++b) {
        for (int s = 0; s < of_g.row_count(b); ++s) {
          const int count = of_g.column_count(s, b);
          T* to = &sum.coefficients[of_sum.first(r + s, a + b)];
          for (int c = 0; c < columns; ++c, ++to) {
            for (int d = 0; d < count; ++d) to[d] += factor[c] * from[d];
          }
          from += count;
        }
      }
      factor += columns;
    }
  }
}

template <class T>
Polynomial<T> convolve(const Polynomial<T>& f, const Polynomial<T>& g) {
  Polynomial<T> result(product_shape(f.shape, g.shape));
  add_convolution(result, f, g);
  return result;
}

}  // namespace bezcert
