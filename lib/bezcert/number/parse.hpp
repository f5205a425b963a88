// Exact reading of numbers from text.
//
// Independent of the locale and of the floating-point rounding mode. A number means either the double
// nearest to it (binary64) or its exact decimal value; the caller says which.
#pragma once

#include "bezcert/number/rational.hpp"

#include <optional>
#include <string_view>

namespace bezcert {

/// The largest exponent, and the largest number of characters, that a number in a file may have. Without
/// a limit a 12-byte file could ask for a gigabyte of digits.
inline constexpr int max_decimal_exponent = 5000;
inline constexpr std::size_t max_number_length = 20000;

/// The double nearest to a decimal such as "-1.5e-3" (round to nearest, ties to even); too small for a
/// double means 0. Nothing if `text` is no decimal from end to end, or not finite, or too large for a double;
/// too small ones must keep the limits above.
std::optional<double> parse_binary64(std::string_view text);

/// The exact value of a decimal such as "-1.5e-3". Nothing if `text` is no decimal from end to end or
/// beyond the limits above.
std::optional<Rational> parse_decimal(std::string_view text);

/// The exact value of "p/q" with q != 0, or of a decimal.
std::optional<Rational> parse_rational(std::string_view text);

}  // namespace bezcert
