// The Jacobian numerator N: the polynomial whose sign is the sign of det J.
//
// Triangle of degree n (YLC22 eq. 5-8). With the homogeneous net P* and the three sub-nets
// F_r = sum over |m| = n-1 of P*_(m+e_r) B_m, the map is P* = xi_0 F_0 + xi_1 F_1 + xi_2 F_2 and
//   det J = n^2 N / W^3,  N = det(F_0, F_1, F_2), of degree 3(n-1);
// with equal weights N = (F_1 - F_0) x (F_2 - F_0), of degree 2(n-1).
//
// Quadrilateral of degrees (p, q). With the four sub-nets F_ab of degrees (p-1, q-1),
// P* = sum (1-u)^(1-a) u^a (1-v)^(1-b) v^b F_ab, and det J = p q N / W^3 with
//   N = (1-u)(1-v) [F00 F10 F01] + u(1-v) [F00 F10 F11] + (1-u)v [F00 F11 F01] + uv [F10 F11 F01],
// of degrees (3p-2, 3q-2); with equal weights [A B C] = (B-A) x (C-A) and the degrees are (2p-1, 2q-1).
// (Expand det(P*, P*_u, P*_v): it is multilinear in the F_ab. docs/jacobian.md has both derivations.)
//
// N is computed by products of polynomials in scaled Bernstein coefficients, without division; the
// coefficients come out multiplied by a known positive integer, the same for every number form.
#pragma once

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/element/net.hpp"

namespace bezcert {

/// The shape of N for an element shape, rational or not.
Shape numerator_shape(Shape element, bool rational);

/// The positive integer that the coefficients of `jacobian_numerator` are multiplied by: the least common
/// multiple of the multinomials of its shape.
const Integer& numerator_multiple(Shape numerator);

/// N times `numerator_multiple`, for T = Interval (while a RoundUp lives) or Integer.
template <class T>
Polynomial<T> jacobian_numerator(const Net<T>& net);

extern template Polynomial<Interval> jacobian_numerator(const Net<Interval>&);
extern template Polynomial<Integer> jacobian_numerator(const Net<Integer>&);

/// W, or the constant 1 where the element is polynomial.
template <class T>
Polynomial<T> weight_polynomial(const Net<T>& net) {
  if (!net.rational()) {
    Polynomial<T> one(Shape(net.shape.domain, 0));
    one.coefficients[0] = T(1);
    return one;
  }
  return {net.shape, net.weights};
}

/// The degree factor of det J = factor * N / W^3: n^2 for a triangle, p q for a quadrilateral.
int degree_factor(Shape element);

}  // namespace bezcert
