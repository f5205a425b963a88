#include "bezcert/number/dyadic.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <cmath>
#include <limits>

namespace bezcert {
namespace {

constexpr int mantissa_bits = std::numeric_limits<double>::digits;

enum class Direction { down, up };

Direction opposite(Direction direction) {
  return direction == Direction::down ? Direction::up : Direction::down;
}

// The definition in the header for x = m 2^q with 2^52 <= m < 2^53. All in 64-bit integers: 17 m < 2^58.
Dyadic round_positive_double(double x, Direction direction, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto m = static_cast<long>(std::ldexp(fraction, mantissa_bits));
  const long q = exponent - mantissa_bits;
  const long e = 17 * m >= (22L << (mantissa_bits - 1)) ? q + mantissa_bits - 1 : q + mantissa_bits - 2;
  const long h = e + 1 - bits;
  const long unit = 17L << (h - q);  // 17 h in units of 2^q
  const long shift = 5L << (h - q);
  // floor(x/h -+ 5/17); the numerator is positive because x/h > 1.
  const long k = direction == Direction::down ? (17 * m - shift) / unit : (17 * m + shift) / unit + 1;
  return {k, h};
}

Dyadic round_positive(const Rational& x, Direction direction, int bits) {
  const Rational threshold(22, 17);
  long e = static_cast<long>(mpz_sizeinbase(mpq_numref(x.backend().data()), 2)) -
           static_cast<long>(mpz_sizeinbase(mpq_denref(x.backend().data()), 2)) - 2;
  while (x >= threshold * power_of_two(e + 1)) ++e;
  const long h = e + 1 - bits;
  const Rational steps = x / power_of_two(h);
  const Rational offset(5, 17);
  const Integer k = direction == Direction::down ? floor(steps - offset) : Integer(floor(steps + offset) + 1);
  return {k.convert_to<long>(), h};
}

Dyadic negated(Dyadic value) { return {-value.mantissa, value.exponent}; }

Dyadic round(double x, Direction direction, int bits) {
  if (x == 0) return {};
  if (x < 0) return negated(round_positive_double(-x, opposite(direction), bits));
  return round_positive_double(x, direction, bits);
}

Dyadic round(const Rational& x, Direction direction, int bits) {
  if (x.sign() == 0) return {};
  if (x.sign() < 0) return negated(round_positive(-x, opposite(direction), bits));
  return round_positive(x, direction, bits);
}

}  // namespace

Rational to_rational(const Dyadic& value) { return Rational(value.mantissa) * power_of_two(value.exponent); }

char* write_short(const Dyadic& value, char* to) {
  if (value.mantissa == 0) {
    *to = '0';
    return to + 1;
  }
  // In lowest terms: an odd numerator, or no denominator.
  const int twos = std::countr_zero(static_cast<unsigned long>(value.mantissa));
  const long exponent = value.exponent + twos;
  const long odd = value.mantissa >> twos;
  if (exponent >= 0) {
    const bool fits = exponent < 63 && std::abs(odd) <= std::numeric_limits<long>::max() >> exponent;
    return fits ? std::to_chars(to, to + 20, odd * (1L << exponent)).ptr : nullptr;
  }
  if (exponent <= -63) return nullptr;
  to = std::to_chars(to, to + 20, odd).ptr;
  *to++ = '/';
  return std::to_chars(to, to + 19, 1L << -exponent).ptr;
}

Dyadic round_down(const Rational& value, int bits) { return round(value, Direction::down, bits); }
Dyadic round_up(const Rational& value, int bits) { return round(value, Direction::up, bits); }

Dyadic round_down(double value, int bits) { return round(value, Direction::down, bits); }
Dyadic round_up(double value, int bits) { return round(value, Direction::up, bits); }

}  // namespace bezcert
