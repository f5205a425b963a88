// YLC22 Theorem 1 (Yang, Liu, Chai, Liu, Fu 2022): if det(l1,l2,l3) * orientation(P_l1,P_l2,P_l3) >= 0 for
// all triples of control points of a Bezier triangle, and > 0 for the three corner triples (a corner and its
// two neighbours), then det J > 0. The condition does not mention weights, so it holds for every choice of
// positive weights, and it even makes the map injective. Proof of both: docs/criteria.md, "orientation".
#pragma once

#include "bezcert/criterion/criterion.hpp"

namespace bezcert {

/// Checks all non-collinear triples: O(degree^6). `not_applicable` to quadrilaterals.
Verdict orientation_condition(const Forms& forms);
std::optional<Status> quick_orientation(const QuickNet& net);

inline constexpr Criterion orientation_info{
    "orientation",
    "YLC22 Theorem 1",
    "every triple of control points is oriented like its indices => injective, for all positive weights",
    Claim::injective,
    Standing::sound,
    false,
    orientation_condition,
    quick_orientation};

}  // namespace bezcert
