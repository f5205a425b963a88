// On which side of each other two curves leave a common point in one direction.
//
// Where a fan of corners makes exactly one turn its two boundary edges are tangent, and only their higher
// terms tell whether a sliver is left out between them or covered twice. In coordinates along the tangent (x)
// and across (y) each curve is y = c_2 x^2 + c_3 x^3 + ... near the point; the first different coefficient
// decides. If none up to the product of the degrees differs the curves are one (Bezout): docs/mesh.md,
// "Cusps".
#pragma once

#include "bezcert/curve/curve_net.hpp"

namespace bezcert {

/// 1 if b leaves to the left of a, -1 to the right, 0 if they run along each other.
/// Precondition: a and b begin at one point in one direction, their derivatives there are not zero.
int compare_branches(const CurveNet<Integer>& a, const CurveNet<Integer>& b);

}  // namespace bezcert
