// Exact numbers: integers and rationals of any size.
//
// GMP through Boost.Multiprecision with expression templates off, so that `auto x = a + b` is a number.
// Everything a verdict rests on is one of these two types; `Interval` only decides when to use them.
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include <string>

namespace bezcert {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Sign of an exact number: -1, 0 or 1.
inline int sign(const Integer& value) { return value.sign(); }
inline int sign(const Rational& value) { return value.sign(); }

/// An exact integer as a number of type T (an Interval: the smallest that contains it, interval.hpp).
template <class T>
T number_from_integer(const Integer& value) {
  return T(value);
}

/// The exact value of a double. Precondition: `value` is finite; throws std::invalid_argument otherwise.
Rational exact(double value);

/// Whether the double nearest to `value` is `value` itself; then that double is stored in `result`.
bool is_binary64(const Rational& value, double& result);

/// 2^exponent, exactly, for any sign of the exponent.
Rational power_of_two(long exponent);

/// base^exponent. Precondition: exponent >= 0.
Rational power(const Rational& base, int exponent);

/// The largest integer that is not above `value`.
Integer floor(const Rational& value);

/// "p/q" in lowest terms, or "p" for an integer: what reports and certificates hold.
std::string to_string(const Rational& value);

/// A decimal of `digits` significant digits for people, such as "-0.00598" or "1.5e-12"; rounded to
/// nearest, so never evidence. The same on every machine and in every locale and rounding mode.
std::string to_decimal(const Rational& value, int digits = 6);

}  // namespace bezcert
