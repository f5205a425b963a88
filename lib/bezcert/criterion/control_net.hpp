// XC15 Theorem 2.1 (Xu, Chernikov 2015), generalised to any degree: if every upright control triangle
// (P_(m+e0), P_(m+e1), P_(m+e2)), |m| = n-1, of a polynomial Bezier triangle is counter-clockwise, then
// det J > 0. The theorem is false, already for degree 2 with a simple control net and a simple boundary:
// intermediate triangles of de Casteljau's algorithm may turn over although the first ones do not. See
// docs/criteria.md and corpus/. Kept because meshers use it: `claimed`.
#pragma once

#include "bezcert/criterion/criterion.hpp"

namespace bezcert {

/// Checks every upright control triangle. `not_applicable` to quadrilaterals and to unequal weights.
Verdict control_net(const Forms& forms);
std::optional<Status> quick_control_net(const QuickNet& net);

inline constexpr Criterion control_net_info{
    "control-net",
    "XC15 Theorem 2.1, for any degree",
    "every upright control triangle is counter-clockwise => det J > 0 (polynomial triangles)",
    Claim::regular,
    Standing::claimed,
    true,
    control_net,
    quick_control_net};

}  // namespace bezcert
