// Interval arithmetic in double: the filter.
//
// Every operation on `Interval` contains the exact result of the operation on every choice of numbers
// in its operands, as long as a `RoundingScope` is alive on the thread (CGAL::Interval_nt<false> under
// its Protector: the rounding mode is upwards, lower bounds are kept negated). An interval only ever
// says "certainly positive", "certainly negative" or "ask the exact numbers"; overflow and NaN are the
// last of these by construction of `certain_sign`.
#pragma once

#include "bezcert/number/rational.hpp"

#include <CGAL/Interval_nt.h>

#include <optional>

namespace bezcert {

using Interval = CGAL::Interval_nt<false>;

/// While one of these lives, the thread rounds upwards and interval operations are valid. Functions that
/// use intervals open one themselves; nesting costs a few nanoseconds. No other floating-point work that
/// expects rounding to nearest may run inside.
class RoundingScope {
 public:
  RoundingScope() = default;
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

 private:
  Interval::Protector protector_;
};

/// While one of these lives, the thread rounds to nearest: for libraries that count on it, even inside a
/// RoundingScope. (CGAL's own functions, because std::fegetround does not see the mode that a RoundingScope
/// sets.)
class NearestRounding {
 public:
  NearestRounding() : before_(CGAL::FPU_get_and_set_cw(CGAL_FE_TONEAREST)) {}
  ~NearestRounding() { CGAL::FPU_set_cw(before_); }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  CGAL::FPU_CW_t before_;
};

/// The sign of every number in the interval if they all have the same one, else nothing.
inline std::optional<int> certain_sign(const Interval& value) {
  if (value.inf() > 0) return 1;
  if (value.sup() < 0) return -1;
  if (value.inf() == 0 && value.sup() == 0) return 0;
  return std::nullopt;
}

/// The smallest interval with double bounds that contains an exact number. Does not depend on the
/// rounding mode, needs no RoundingScope.
Interval to_interval(const Integer& value);
Interval to_interval(const Rational& value);

}  // namespace bezcert
