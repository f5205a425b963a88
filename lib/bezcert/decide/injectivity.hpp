// Sufficient proofs that a regular element is globally injective.
//
// 1. "midpoint": polynomial triangles of degree at most 2 and bilinear quadrilaterals. Along a segment
//    from a to b the derivative is affine, so x(a) - x(b) = J((a+b)/2) (a - b), which is not 0.
// 2. "jacobian_hull": with M_i the Bernstein coefficients of the matrix W^2 J (of J itself if polynomial),
//    x(a) - x(b) = (mean of J over the segment) (a - b), and the mean is a nonnegative combination, not all
//    zero, of the M_i. Its determinant is the sum of l_i l_j times the mixed determinants
//    (M_i^1 x M_j^2 + M_j^1 x M_i^2) / 2. If these are >= 0 for i != j and > 0 for i = j, it is positive.
// 3. "orientation": YLC22 Theorem 1 (criterion/orientation.hpp).
// Proofs in docs/decision.md. Each is sound alone; together they are not complete.
#pragma once

#include "bezcert/element/forms.hpp"
#include "bezcert/verdict/element_verdict.hpp"

namespace bezcert {

/// What proves that the element is injective, or `none`. Precondition: the element is regular.
InjectivityProof prove_injective(const Forms& forms);

}  // namespace bezcert
