// Outward rounding (dyadic.hpp) of what is known to lie in an interval.
//
// An interval that certainly rounds to one grid point stands for the exact value; otherwise the caller
// computes the exact value.
#pragma once

#include "bezcert/number/dyadic.hpp"
#include "bezcert/number/interval.hpp"

#include <optional>

namespace bezcert {

/// The grid point that all numbers of `enclosure` round to, or nothing if they do not certainly agree. In any
/// rounding mode.
std::optional<Dyadic> round_down(const Interval& enclosure, int bits = report_bits);
std::optional<Dyadic> round_up(const Interval& enclosure, int bits = report_bits);

}  // namespace bezcert
