#include "bezcert/number/rational.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace bezcert {
namespace {

Rational power_of_ten(long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(std::labs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

}  // namespace

Rational exact(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("exact: the value is not finite");
  return Rational(value);
}

bool is_binary64(const Rational& value, double& result) {
  const double candidate = mpq_get_d(value.backend().data());
  if (!std::isfinite(candidate) || Rational(candidate) != value) return false;
  result = candidate;
  return true;
}

Rational power_of_two(long exponent) {
  Integer power = 1;
  power <<= static_cast<unsigned long>(std::labs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

Integer floor(const Rational& value) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), mpq_numref(value.backend().data()), mpq_denref(value.backend().data()));
  return result;
}

std::string to_string(const Rational& value) { return value.str(); }

std::string to_decimal(const Rational& value, int digits) {
  if (value.sign() == 0) return "0";
  // All in integers: |value| = 0.d1 d2 ... 10^exponent, d1 != 0, rounded once to nearest, ties to even.
  const Rational magnitude = abs(value);
  const Integer above = numerator(magnitude);
  const Integer below = denominator(magnitude);
  long exponent = static_cast<long>(mpz_sizeinbase(above.backend().data(), 10)) -
                  static_cast<long>(mpz_sizeinbase(below.backend().data(), 10)) - 1;
  while (magnitude >= power_of_ten(exponent)) ++exponent;
  const Rational scaled = magnitude * power_of_ten(digits - exponent);
  Integer rounded = floor(scaled);
  const Rational rest = scaled - Rational(rounded);
  if (rest > Rational(1, 2) || (rest == Rational(1, 2) && rounded % 2 != 0)) ++rounded;
  std::string mantissa = rounded.str();
  if (mantissa.size() > static_cast<std::size_t>(digits)) ++exponent;  // 9.99 became 10.0

  std::string text;
  if (value.sign() < 0) text = "-";
  while (mantissa.size() > 1 && mantissa.back() == '0') mantissa.pop_back();
  const auto count = static_cast<long>(mantissa.size());
  if (exponent > -4 && exponent <= 0) {
    text += "0." + std::string(static_cast<size_t>(-exponent), '0') + mantissa;
  } else if (exponent > 0 && exponent <= 9) {
    if (count <= exponent) {
      text += mantissa + std::string(static_cast<size_t>(exponent - count), '0');
    } else {
      text += mantissa.substr(0, static_cast<size_t>(exponent)) + "." +
              mantissa.substr(static_cast<size_t>(exponent));
    }
  } else {
    text += mantissa.substr(0, 1);
    if (count > 1) text += "." + mantissa.substr(1);
    text += "e" + std::to_string(exponent - 1);
  }
  return text;
}

}  // namespace bezcert
