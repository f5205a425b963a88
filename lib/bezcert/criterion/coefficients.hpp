// The Bernstein coefficient condition (Dey, O'Bara, Shephard 1999; Engvall, Evans 2020 for rational
// elements): if every Bernstein coefficient of the Jacobian numerator N is >= 0 and the corner ones are > 0,
// then det J > 0. Proof: docs/criteria.md, "coefficients". A corner coefficient <= 0 refutes: it is N there.
#pragma once

#include "bezcert/criterion/criterion.hpp"
#include "bezcert/element/jacobian_tree.hpp"

namespace bezcert {

/// What the signs of all coefficients of N on a piece tell of det J there.
Status coefficient_status(const PieceSigns& signs, std::size_t corner_count);

/// Checks the coefficients of N on the whole element. Applies to every element.
Verdict coefficients(const Forms& forms);
std::optional<Status> quick_coefficients(const QuickNet& net);

inline constexpr Criterion coefficients_info{
    "coefficients", "DOS99, EE20",     "Bernstein coefficients of N >= 0 and corner ones > 0 => det J > 0",
    Claim::regular, Standing::sound,   false,
    coefficients,   quick_coefficients};

}  // namespace bezcert
