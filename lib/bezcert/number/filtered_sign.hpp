// The one filtered sign: doubles with an error bound, else intervals, else integers; the expression is
// written once.
//
// An expression is a function of operands in +, -, * over any number type T. Where its operands come from is
// said once a stage, cheapest first, and a stage is asked only if those before it leave the sign open:
//   doubles()     -> optional DoubleOperands: a tuple of operands in double and the error of the expression's
//                    value on them. The error is found by running the same expression over StaticBound
//                    (static_bound.hpp), times the unit of the actual operands; never derived by hand;
//   intervals(up) -> a tuple of operands that contain the exact ones;
//   integers()    -> the exact operands, up to factors that keep the sign.
// Each stage's answer is the sign of the exact value, so the answer does not depend on the filter. The exact
// stage runs in the rounding mode of the caller.
#pragma once

#include "bezcert/number/filter.hpp"
#include "bezcert/number/interval.hpp"
#include "bezcert/number/rational.hpp"

#include <optional>
#include <tuple>

namespace bezcert {

/// The sign of the number that `value` stands for, wrong by at most `error`, if it is certain.
inline std::optional<int> certain_sign(double value, double error) {
  if (value > error) return 1;
  if (value < -error) return -1;
  if (value == 0 && error == 0) return 0;
  return std::nullopt;
}

/// Operands in double (a tuple) with the error of the expression's value on them.
template <class Operands>
struct DoubleOperands {
  Operands operands;
  double error = 0;
};

/// The exact sign of an expression: stages intervals and integers.
template <class Expression, class Intervals, class Integers>
int filtered_sign(Filter filter, Expression expression, Intervals intervals, Integers integers) {
  if (filter == Filter::on) {
    const RoundUp up;
    if (const auto certain = certain_sign(std::apply(expression, intervals(up)))) return *certain;
  }
  return sign(std::apply(expression, integers()));
}

/// The same with all three stages.
template <class Expression, class Doubles, class Intervals, class Integers>
int filtered_sign(Filter filter, Expression expression, Doubles doubles, Intervals intervals,
                  Integers integers) {
  if (filter == Filter::on) {
    if (const auto found = doubles()) {
      const double value = std::apply(expression, found->operands);
      if (const auto certain = certain_sign(value, found->error)) return *certain;
    }
  }
  return filtered_sign(filter, expression, intervals, integers);
}

/// Thrown by `sign_of` inside `filtered`, and caught there, when an interval holds numbers of several signs.
struct UncertainSign {};

inline int sign_of(const Interval& value) {
  if (const auto certain = certain_sign(value)) return *certain;
  throw UncertainSign{};
}
inline int sign_of(const Integer& value) { return value.sign(); }

/// The exact answer of a predicate, a function of operands that asks for signs of several expressions by
/// `sign_of`: on intervals if they tell all the signs it asks for, else on integers.
template <class Predicate, class Intervals, class Integers>
auto filtered(Filter filter, Predicate predicate, Intervals intervals, Integers integers) {
  if (filter == Filter::on) {
    try {
      const RoundUp up;
      return std::apply(predicate, intervals(up));
    } catch (const UncertainSign&) {
    }
  }
  return std::apply(predicate, integers());
}

}  // namespace bezcert
