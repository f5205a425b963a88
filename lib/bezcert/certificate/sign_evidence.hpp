// The evidence SIGN of a certificate for N, the numerator of det J (docs/certificate-format.md).
//
// What the decision found is written down where that is possible: the coefficients, or the subdivision, depth
// first. Where it took algebra, N is factored, and every factor that matters gets coefficients, a subdivision
// or columns.
#pragma once

#include "bezcert/decide/decide.hpp"

#include <optional>
#include <string>

namespace bezcert {

enum class WantedSign { positive, negative, nonnegative };

/// SIGN that shows N > 0 (regular elements), -N > 0 (reversed) or N >= 0 (degenerate). Nothing if the limits
/// of certificates do not allow it. Precondition: `decision` is that of the element, and says so.
std::optional<std::string> sign_evidence(const Forms& forms, const Decision& decision, WantedSign wanted);

}  // namespace bezcert
