// The evidence `columns` of a certificate: the sign of a polynomial f(u, v) whose zeros, or near-zeros, no
// subdivision ends at (docs/certificate-format.md, "SIGN").
//
// C(u) is the product of f's leading coefficient in v, its values on the edges below and above and its
// discriminant. Between neighbouring real roots of C the zeros of f(u, .) are simple and constant in number:
// one rational column on which f > 0 stands for all of them. Over a root of C itself f >= 0 by continuity; if
// f > 0 is wanted, the root goes into a slab that is narrow enough for a subdivision.
#pragma once

#include "bezcert/certificate/sign_tree.hpp"

namespace bezcert {

/// "columns ..." that shows the sign of f. Nothing if f does not have it or the limits are met. Precondition:
/// f is irreducible of positive degree.
std::optional<std::string> column_evidence(const Bivariate& f, Domain domain, Strictness wanted);

}  // namespace bezcert
