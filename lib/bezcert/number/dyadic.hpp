// Outward rounding to few significant bits.
//
// Reports give proven bounds of det J. They must not depend on whether the filter or the exact integers
// produced them, so a bound is a function of the exact value: the value rounded outwards to a grid. The
// breakpoints of the grid are 5/17 of a step away from the dyadic numbers, because the exact value often is a
// short dyadic number, and then an interval around it (outward.hpp) would straddle a breakpoint that lies on
// the grid.
//
// Definition, for x > 0: e is the integer with 22/17 2^e <= x < 22/17 2^(e+1), h = 2^(e+1-bits), and
//   round_down(x) = h floor(x/h - 5/17) <= x,   round_up(x) = h (floor(x/h + 5/17) + 1) > x.
// Not monotone where e changes: take extremes first, then round.
// round_down(0) = round_up(0) = 0; round_down(-x) = -round_up(x), and the other way round.
#pragma once

#include "bezcert/number/rational.hpp"

namespace bezcert {

/// mantissa * 2^exponent.
struct Dyadic {
  long mantissa = 0;
  long exponent = 0;

  bool operator==(const Dyadic&) const = default;
};

Rational to_rational(const Dyadic& value);
/// Writes to_string(to_rational(value)) without making a Rational and returns its end; null, and nothing is
/// written, where that needs 2^63. Precondition: room for 40 characters.
char* write_short(const Dyadic& value, char* to);
inline int sign(const Dyadic& value) { return (value.mantissa > 0) - (value.mantissa < 0); }

/// Significant bits of the bounds in reports: about three decimal digits.
inline constexpr int report_bits = 10;

/// The grid point below (above) `value`; preconditions: 2 <= bits <= 40, a double is finite.
Dyadic round_down(const Rational& value, int bits = report_bits);
Dyadic round_up(const Rational& value, int bits = report_bits);
Dyadic round_down(double value, int bits = report_bits);
Dyadic round_up(double value, int bits = report_bits);

}  // namespace bezcert
