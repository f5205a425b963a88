// Multinomial factors of the Bernstein basis, and products without division.
//
// B_m = C(m) x^m with the multinomial C(m) = degree! / m! (a product of two binomials on the square), so
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
  for (int r = 0; r < row_count(f.shape); ++r) {
    for (int c = 0; c < column_count(f.shape, r); ++c) {
      const T& factor = f.at(r, c);
      for (int s = 0; s < row_count(g.shape); ++s) {
        const T* from = &g.at(s, 0);
        T* to = &sum.at(r + s, c);
        for (int d = 0; d < column_count(g.shape, s); ++d) to[d] += factor * from[d];
      }
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
