#include "bezcert/number/scaled.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bezcert {
namespace {

struct Split {
  long long mantissa;
  int exponent;
};

// number = mantissa * 2^exponent. Exact in any rounding mode: the fraction has 53 bits.
Split split(double number) {
  constexpr int mantissa_bits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const double fraction = std::frexp(number, &exponent);
  return {static_cast<long long>(std::ldexp(fraction, mantissa_bits)), exponent - mantissa_bits};
}

unsigned long long magnitude(long long mantissa) {
  return static_cast<unsigned long long>(mantissa < 0 ? -mantissa : mantissa);
}

}  // namespace

ScaledIntegers scaled_integers(std::span<const double> numbers) {
  int lowest = std::numeric_limits<int>::max();
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw std::invalid_argument("scaled_integers: a number is not finite");
    const auto [mantissa, exponent] = split(number);
    if (mantissa != 0) lowest = std::min(lowest, exponent + std::countr_zero(magnitude(mantissa)));
  }
  if (lowest == std::numeric_limits<int>::max()) lowest = 0;

  ScaledIntegers result;
  result.scale = power_of_two(lowest);
  result.values.reserve(numbers.size());
  for (const double number : numbers) {
    const auto [mantissa, exponent] = split(number);
    Integer value = mantissa;
    if (exponent >= lowest) {
      value <<= static_cast<unsigned>(exponent - lowest);
    } else {
      value /= Integer(1) << static_cast<unsigned>(lowest - exponent);  // exact: trailing zeros
    }
    result.values.push_back(std::move(value));
  }
  return result;
}

ScaledIntegers scaled_integers(std::span<const Rational> numbers) {
  Integer common = 1;
  for (const Rational& number : numbers) common = lcm(common, Integer(denominator(number)));
  ScaledIntegers result;
  result.scale = Rational(Integer(1), common);
  result.values.reserve(numbers.size());
  for (const Rational& number : numbers) {
    result.values.push_back(Integer(numerator(number)) * (common / Integer(denominator(number))));
  }
  return result;
}

}  // namespace bezcert
