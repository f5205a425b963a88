// Interval arithmetic in double: the filter.
//
// Every operation on `Interval` contains the exact result of the operation on every choice of numbers
// in its operands, as long as the thread rounds upwards (CGAL::Interval_nt<false>: lower bounds are kept
// negated). A `RoundUp` is the witness that it does. An interval only ever says "certainly positive",
// "certainly negative" or "ask the exact numbers"; overflow and NaN are the last of these by construction of
// `certain_sign`.
//
// Nothing but interval work runs while a thread rounds upwards, in particular no algebra and no text:
//  - whatever makes or computes intervals asks for `const RoundUp&`, and the only way to have one is to open
//  it;
//  - it is opened in the blocks that evaluate intervals and read their signs or bounds: in `filtered_sign`
//  and
//    `filtered` (filtered_sign.hpp), whose exact stage runs after the block has ended, and in a few loops
//    over intervals alone. It cannot be copied or made on the heap, and no class keeps one.
// So the mode lasts as long as the interval work, and what runs outside rounds as its caller does. Where that
// matters it is asked: algebra/ refuses to call FLINT in any other mode than to nearest. (GMP and MPFR, which
// make intervals of exact numbers, compute in integers.)
#pragma once

#include "bezcert/number/exact_vector.hpp"
#include "bezcert/number/rational.hpp"

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <optional>

namespace bezcert {

using Interval = CGAL::Interval_nt<false>;

/// While one of these lives, the thread rounds upwards and interval operations are valid. Nesting costs a few
/// nanoseconds.
class RoundUp {
 public:
  RoundUp() = default;
  RoundUp(const RoundUp&) = delete;
  RoundUp& operator=(const RoundUp&) = delete;
  static void* operator new(std::size_t) = delete;

 private:
  Interval::Protector protector_;
};

/// Whether the thread rounds to nearest. (Not std::fegetround, which does not see what a RoundUp sets.)
inline bool rounds_to_nearest() { return CGAL::FPU_get_cw() == CGAL_FE_TONEAREST; }

/// The sign of every number in the interval if they all have the same one, else nothing.
inline std::optional<int> certain_sign(const Interval& value) {
  if (value.inf() > 0) return 1;
  if (value.sup() < 0) return -1;
  if (value.inf() == 0 && value.sup() == 0) return 0;
  return std::nullopt;
}

/// The smallest interval with double bounds that contains an exact number. Does not depend on the
/// rounding mode, needs no RoundUp.
Interval to_interval(const Integer& value);
Interval to_interval(const Rational& value);
inline Interval interval_at(const ExactVector& numbers, std::size_t i) {
  return numbers.binary64() ? Interval(numbers.doubles()[i]) : to_interval(numbers.rationals()[i]);
}

template <>
inline Interval number_from_integer<Interval>(const Integer& value) {
  return to_interval(value);
}

}  // namespace bezcert
