// The Bernstein coefficient condition (Dey, O'Bara, Shephard 1999; Engvall, Evans 2020 for rational
// elements): if every Bernstein coefficient of the Jacobian numerator N is >= 0 and the corner ones are > 0,
// then det J > 0. Proof: docs/criteria.md, "coefficients". A corner coefficient <= 0 refutes: it is N there.
#pragma once

#include "bezcert/element/forms.hpp"
#include "bezcert/proof/verdict.hpp"

namespace bezcert {

/// Checks the coefficients of N on the whole element. Applies to every element.
Verdict coefficients(const Forms& forms);

}  // namespace bezcert
