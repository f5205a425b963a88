// Polynomials in Bernstein form on products of simplices (segment, triangle, square, ...), over any number
// type.
//
// f = sum of c_m B_m with the Bernstein basis of the shape (order and exponents: shape.hpp). Facts used
// everywhere, each immediate from B_m >= 0 and sum B_m = 1 on the domain:
//   - f lies between the smallest and the largest coefficient (`range`);
//   - a corner coefficient is the value of f at that corner;
//   - splitting (de Casteljau) gives the coefficients of f over a part of the domain.
// Source: G. Farin, Curves and Surfaces for CAGD, chapters 4, 14, 17.
#pragma once

#include "bezcert/bernstein/shape.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bezcert {

template <class T>
struct Polynomial {
  Shape shape;
  std::vector<T> coefficients;

  Polynomial() = default;
  /// The zero polynomial of a shape.
  explicit Polynomial(Shape s) : shape(s), coefficients(coefficient_count(s), T(0)) {}
  /// Throws std::invalid_argument if the number of coefficients does not fit the shape.
  Polynomial(Shape s, std::vector<T> c) : shape(s), coefficients(std::move(c)) {
    if (coefficients.size() != coefficient_count(shape)) {
      throw std::invalid_argument("Polynomial: the number of coefficients does not fit the degree");
    }
  }

  T& at(int row, int column) { return coefficients[coefficient_index(shape, row, column)]; }
  const T& at(int row, int column) const { return coefficients[coefficient_index(shape, row, column)]; }
};

/// Value at a parameter: of each factor in turn, t if it is a segment and the barycentric parameters
/// otherwise; so (t) on the segment, (xi_0, xi_1, xi_2) on the triangle, (u, v) on the square. De Casteljau's
/// algorithm: exact if T is. Precondition: barycentric parameters sum to 1. Throws std::invalid_argument if
/// the number of parameters does not fit the domain.
template <class T>
T evaluate(const Polynomial<T>& f, const std::vector<T>& parameter);

/// De Casteljau's algorithm in one factor down to degree `to`, with barycentric parameters t[0], t[1], ... of
/// that factor; they need no sum of 1 (homogeneous values). Precondition: 0 <= to <= the degree.
template <class T>
Polynomial<T> collapse(Polynomial<T> f, int factor, const T* t, int to);

/// The same polynomial with `times` degrees more in every factor. T must have division.
template <class T>
Polynomial<T> elevate(const Polynomial<T>& f, int times = 1);

/// The product. T must have division (integers: convolve in multinomial.hpp).
template <class T>
Polynomial<T> multiply(const Polynomial<T>& f, const Polynomial<T>& g);

/// Derivative by an affine coordinate: on the segment d/dt (0), on the square d/du (0) or d/dv (1), on the
/// triangle along corner 1 - corner 0 (0) or corner 2 - corner 0 (1). One degree less in that factor. Throws
/// std::invalid_argument if that degree is 0.
template <class T>
Polynomial<T> differentiate(const Polynomial<T>& f, int coordinate);

/// The restriction to the two parts cut at parameter t of one factor, by the points (1-t) corner 0 + t corner
/// 1 of its first edge and its other corners: of the segment; of the square at u = t (factor 0) or v = t (1),
/// lower part first; of the triangle (corner 0, point, corner 2) and (point, corner 1, corner 2).
template <class T>
std::pair<Polynomial<T>, Polynomial<T>> split(const Polynomial<T>& f, const T& t, int factor = 0);

/// The smallest and the largest coefficient: f lies between them. Precondition: T is totally ordered.
template <class T>
std::pair<T, T> range(const Polynomial<T>& f);

}  // namespace bezcert

#include "bezcert/bernstein/polynomial_impl.hpp"
