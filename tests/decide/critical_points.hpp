// How low a polynomial goes on the closed triangle or square, by its critical points: the oracle of the
// decision's test.
//
// Another algorithm than the library's, on CGAL's Algebraic_kernel_d_2. Theorem: the minimum of f over the
// closed domain is taken on an edge, or at an interior critical point f_u = f_v = 0. Edges: the real roots of
// a univariate polynomial and a sample between them. Interior: with g = gcd(f_u, f_v), f is constant on every
// connected piece of g = 0; a piece that reaches the boundary shows its value there, any other is compact and
// has a point with g = g_v = 0. So the common zeros of f_u / g and f_v / g, and of the primitive square-free
// part of g and its derivative, show every value needed.
#pragma once

#include "jacobian_table.hpp"

#include <array>
#include <vector>

namespace bezcert::test {

/// A zero of f in a box of (u, v): lower == upper in a coordinate that is known exactly.
struct ZeroBox {
  std::array<Rational, 2> lower, upper;
};

struct LowestSign {
  /// The sign of the minimum of f: -1, 0 or 1.
  int sign = 0;
  /// Where f vanishes, if sign is 0: all isolated zeros, and some of every curve of zeros.
  std::vector<ZeroBox> zeros;
};

LowestSign lowest_sign(const Table& f, Domain domain);

}  // namespace bezcert::test
