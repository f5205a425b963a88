// The rounding of dyadic.hpp for positive numbers between two doubles, in a few operations.
#pragma once

#include "bezcert/number/dyadic.hpp"

#include <optional>

namespace bezcert {

/// The grid point, at report_bits, that all numbers from lower to upper round to, or nothing if they do not
/// certainly agree. Precondition: lower <= upper; nothing is known unless 2^-900 <= lower, upper <= 2^900.
/// Right in every rounding mode.
std::optional<Dyadic> round_down_positive(double lower, double upper);
std::optional<Dyadic> round_up_positive(double lower, double upper);

}  // namespace bezcert
