// Multinomial factors of the Bernstein basis, and products without division.
//
// B_m = C(m) x^m with the multinomial C(m) = degree! / m! (the product of the factors' multinomials), so
// "scaled" coefficients c_m C(m) multiply by plain convolution. That is how products stay in integers.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/number/interval.hpp"
#include "bezcert/number/rational.hpp"

#include <type_traits>
#include <vector>

namespace bezcert {

template <class T>
struct Polynomial;

/// C(n, k); 0 outside 0 <= k <= n.
Integer binomial(int n, int k);

/// The multinomial of every coefficient of a shape, in coefficient order.
std::vector<Integer> multinomials(Shape shape);

/// An exact integer as a number of type T (for Interval: the smallest interval that contains it).
template <class T>
T number_from_integer(const Integer& value) {
  if constexpr (std::is_same_v<T, Interval>) {
    return to_interval(value);
  } else {
    return T(value);
  }
}

/// Product of two polynomials given by scaled coefficients; the result has scaled coefficients too.
template <class T>
Polynomial<T> convolve(const Polynomial<T>& f, const Polynomial<T>& g);

/// sum += f * g in scaled coefficients. Precondition: sum.shape == product_shape(f.shape, g.shape).
template <class T>
void add_convolution(Polynomial<T>& sum, const Polynomial<T>& f, const Polynomial<T>& g) {
  for_each_row(f.shape, [&](const CoefficientRow& of_f) {
    for_each_row(g.shape, [&](const CoefficientRow& of_g) {
      T* to = &sum.coefficients[coefficient_index(
          sum.shape, {0, of_f.row + of_g.row, of_f.layer + of_g.layer})];
      const T* from = &g.coefficients[of_g.first];
      for (std::size_t c = 0; c < of_f.count; ++c, ++to) {
        const T& factor = f.coefficients[of_f.first + c];
        for (std::size_t d = 0; d < of_g.count; ++d) to[d] += factor * from[d];
      }
    });
  });
}

template <class T>
Polynomial<T> convolve(const Polynomial<T>& f, const Polynomial<T>& g) {
  Polynomial<T> result(product_shape(f.shape, g.shape));
  add_convolution(result, f, g);
  return result;
}

}  // namespace bezcert
