// The area beside a curve: its share in the area inside a closed chain.
//
// Area = integral of (x dy - y dx) / 2 along the chain (Green). Polynomial curves: products of Bernstein
// polynomials are integrated exactly. Rational curves: on every piece the chord's share is exact and the
// rest, between chord and piece, is enclosed by the signs of the control points of its integrand; halving
// shrinks that fast. docs/mesh.md.
#pragma once

#include "bezcert/number/rational.hpp"

#include <utility>
#include <vector>

namespace bezcert {

class DyadicCurve;

/// lower <= area <= upper; equal where all curves are polynomial.
struct AreaBounds {
  Rational lower = 0, upper = 0;

  bool is_exact() const { return lower == upper; }
  AreaBounds& operator+=(const AreaBounds& more) {
    lower += more.lower;
    upper += more.upper;
    return *this;
  }
};

/// The integral of X Y' - Y X' over [0, 1] for Bernstein coefficients of X and Y, as the sums of the shares
/// of its positive and of its negative scaled Bernstein coefficients.
std::pair<Rational, Rational> bracket_integral(const std::vector<Integer>& x, const std::vector<Integer>& y);

/// The area beside a curve; of a rational one from 2^halvings pieces.
AreaBounds area_beside(DyadicCurve& curve, int halvings);

}  // namespace bezcert
