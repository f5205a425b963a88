#include "bezcert/number/rational.hpp"

#include <mpfr.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace bezcert {

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
  // MPFR gives the digits and the exponent apart, so neither the locale nor the rounding mode enters.
  mpfr_t number;
  mpfr_init2(number, 64 + 4 * digits);
  mpfr_set_q(number, value.backend().data(), MPFR_RNDN);
  mpfr_exp_t exponent = 0;
  char* raw = mpfr_get_str(nullptr, &exponent, 10, static_cast<size_t>(digits), number, MPFR_RNDN);
  std::string mantissa(raw);
  mpfr_free_str(raw);
  mpfr_clear(number);

  std::string text;
  if (mantissa.front() == '-') {
    text = "-";
    mantissa.erase(0, 1);
  }
  while (mantissa.size() > 1 && mantissa.back() == '0') mantissa.pop_back();
  const auto count = static_cast<mpfr_exp_t>(mantissa.size());
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
