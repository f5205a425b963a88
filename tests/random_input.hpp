// Seeded random input for tests: every failure can be run again.
#pragma once

#include "bezcert/number/rational.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace bezcert::test {

/// The seed of a test: its own, or that of the environment variable BEZCERT_SEED. Tests print it on failure
/// (INFO("seed " << seed)).
inline std::uint64_t seed_or(std::uint64_t own) {
  const char* text = std::getenv("BEZCERT_SEED");
  return text == nullptr ? own : std::strtoull(text, nullptr, 10);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// An integer from low to high, both included; the same on every standard library.
  long integer(long low, long high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<long>(engine_() % span);
  }
  bool chance(int percent) { return integer(1, 100) <= percent; }
  /// A multiple of 1/denominator between low and high.
  Rational rational(long low, long high, long denominator) {
    return Rational(integer(low * denominator, high * denominator), denominator);
  }
  /// A finite double of any size and sign, spread over exponents.
  double any_double(int lowest_exponent = -40, int highest_exponent = 40) {
    const double mantissa = static_cast<double>(integer(-(1L << 53), 1L << 53));
    return std::ldexp(mantissa, static_cast<int>(integer(lowest_exponent, highest_exponent)) - 53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace bezcert::test
