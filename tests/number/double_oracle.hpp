// What a double is, from its bits and rationals alone: the judge of everything that reads or rounds doubles.
// Uses no floating-point arithmetic and none of the library's own conversions.
#pragma once

#include "random_input.hpp"

#include <bit>
#include <cfenv>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace bezcert::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double largest_double = std::numeric_limits<double>::max();
inline constexpr double smallest_double = std::numeric_limits<double>::denorm_min();
inline constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

inline std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }
inline double from_bits(std::uint64_t bits) { return std::bit_cast<double>(bits); }
inline bool same_bits(double a, double b) { return bits_of(a) == bits_of(b); }
inline bool is_finite_bits(std::uint64_t bits) { return ((bits >> 52) & 0x7ff) != 0x7ff; }

inline Integer integer_power(const Integer& base, long exponent) {
  Integer result = 1;
  for (long k = 0; k < exponent; ++k) result *= base;
  return result;
}

/// mantissa * 2^exponent.
inline Rational dyadic(const Integer& mantissa, long exponent) {
  Integer shifted = exponent >= 0 ? mantissa : Integer(1);
  shifted <<= static_cast<unsigned long>(exponent >= 0 ? exponent : -exponent);
  return exponent >= 0 ? Rational(shifted) : Rational(mantissa) / Rational(shifted);
}

/// A finite double as mantissa * 2^exponent, read from its bits (IEEE 754 binary64).
struct DoubleParts {
  long mantissa = 0;  // with sign
  long exponent = 0;
};
inline DoubleParts parts_of(double x) {
  const std::uint64_t bits = bits_of(x);
  const long biased = static_cast<long>((bits >> 52) & 0x7ff);
  const long fraction = static_cast<long>(bits & ((std::uint64_t{1} << 52) - 1));
  const long magnitude = biased == 0 ? fraction : fraction + (1L << 52);
  return {(bits & sign_bit) != 0 ? -magnitude : magnitude, (biased == 0 ? 1 : biased) - 1075};
}
inline Rational value_of(double x) {
  const DoubleParts parts = parts_of(x);
  return dyadic(parts.mantissa, parts.exponent);
}

/// The largest double not above x and the smallest not below it; infinite beyond the doubles.
struct Around {
  double below = 0;
  double above = 0;
};
inline Around around(const Rational& x) {
  if (x < 0) {
    const Around mirrored = around(Rational(-x));
    return {-mirrored.above, -mirrored.below};
  }
  // Positive doubles are ordered as their bits.
  std::uint64_t low = 0;
  std::uint64_t high = bits_of(infinity);
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (value_of(from_bits(middle)) <= x ? low : high) = middle;
  }
  const double below = from_bits(low);
  return {below, value_of(below) == x ? below : from_bits(high)};
}

/// The double nearest to x, ties to the even mantissa; nothing if that is infinite. The sign of a zero is
/// not specified.
inline std::optional<double> nearest_double(const Rational& x) {
  const auto [below, above] = around(x);
  // Round to nearest behaves as if 2^1024 were the double after the largest.
  const auto value = [](double d) {
    return d == infinity ? dyadic(1, 1024) : d == -infinity ? dyadic(-1, 1024) : value_of(d);
  };
  const Rational to_below = x - value(below);
  const Rational to_above = value(above) - x;
  const bool below_even = (bits_of(below) & 1) == 0;
  const double result = to_below < to_above || (to_below == to_above && below_even) ? below : above;
  if (result == infinity || result == -infinity) return std::nullopt;
  return result;
}

/// A finite double of random bits: every exponent equally likely, subnormals made more frequent.
inline double random_bits_double(Random& random) {
  while (true) {
    auto bits = static_cast<std::uint64_t>(random.integer(0, (1L << 32) - 1)) << 32;
    bits |= static_cast<std::uint64_t>(random.integer(0, (1L << 32) - 1));
    if (random.chance(10)) bits &= sign_bit | ((std::uint64_t{1} << random.integer(1, 53)) - 1);
    if (is_finite_bits(bits)) return from_bits(bits);
  }
}

/// Bits of a double in hexadecimal, for messages.
inline std::string hex(double x) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::hexfloat << x;
  return out.str();
}

/// Sets the rounding mode for its life.
class RoundingMode {
 public:
  explicit RoundingMode(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(before_); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;

 private:
  int before_;
};

inline constexpr int rounding_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

}  // namespace bezcert::test
