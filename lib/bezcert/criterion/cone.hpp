// KMC22 Theorem 1 with Definition 5 (Khanteimouri, Mandad, Campen 2022) as a condition on a given rational
// Bezier triangle: one edge is a guardable curve and the rest of the net satisfies the theorem's five
// conditions => the map is injective. The theorem is false as stated, for degrees 2 and 3 (corpus/).
// `claimed`. Definitions, where the paper leaves them open, as in docs/criteria.md, "cone":
//   rows      p_ij: i rows away from the curve edge, j along it; p_0j = p_j with weights w_j;
//   d         the direction of the second row, p_1(n-1) - p_10 (degree 1: of the edge);
//   o         the middle of the edge's end points;
//   p'_i      (1 - w_i) o + w_i p_i, weights divided by the weight of the tip;
//   blue cone of p_i: { r : v_k x (r - p_i) > 0 for all k and d x (r - p_i) > 0 }, v_k = p_(k+1) - p_k;
//   red cone  the same with p'_i and v'_k.
#pragma once

#include "bezcert/criterion/criterion.hpp"

namespace bezcert {

/// Tries each edge as the curve edge; if all fail, `reason` names the failing condition for each edge.
/// `not_applicable` to quadrilaterals.
Verdict cone(const Forms& forms);
std::optional<Status> quick_cone(const QuickNet& net);

inline constexpr Criterion cone_info{"cone",
                                     "KMC22 Theorem 1 with Definition 5",
                                     "the five conditions on a guardable curve edge => injective",
                                     Claim::injective,
                                     Standing::claimed,
                                     true,
                                     cone,
                                     quick_cone};

}  // namespace bezcert
