// The evidence ZERO of a certificate: a parameter where det J vanishes, rational or algebraic
// (docs/certificate-format.md).
#pragma once

#include "bezcert/decide/decide.hpp"

#include <optional>
#include <string>

namespace bezcert {

/// ZERO from the decision: its witness, if det J = 0 there, or the zero that algebra has found. Nothing if
/// there is none, or its coordinates take too long a resultant.
std::optional<std::string> zero_evidence(const Forms& forms, const Decision& decision);

}  // namespace bezcert
