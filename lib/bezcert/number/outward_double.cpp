#include "bezcert/number/outward_double.hpp"

#include <bit>
#include <cstdint>

namespace bezcert {
namespace {

enum class Direction { down, up };

// 2^exponent for an exponent of normal numbers.
double power_of_two_double(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// With y = x / h between 22/17 2^(bits-1) and 22/17 2^bits: y is exact, because h is a power of two, and so
// is the choice of e, because x >= 22/17 2^k exactly if x is at least the next double above 22/17, times 2^k.
// y -+ 5/17 errs by less than 2^(bits+1-52) for the sum, and by less than that for the constant, in any
// rounding mode. The margin of 2^(bits-40) covers both, and that of its own sum.
std::optional<Dyadic> round_positive_fast(double lower, double upper, Direction direction) {
  constexpr int bits = report_bits;
  constexpr double threshold = 0x1.4b4b4b4b4b4b5p0;  // the double above 22/17
  constexpr double shift = 5.0 / 17;
  constexpr double margin = 0x1p-30;
  static_assert(bits == 10);
  // Far from overflow, subnormal numbers and NaN.
  if (!(lower >= 0x1p-900 && upper <= 0x1p900)) return std::nullopt;
  const auto pattern = std::bit_cast<std::uint64_t>(lower);
  int e = static_cast<int>(pattern >> 52) - 1023;
  const auto fraction =
      std::bit_cast<double>((pattern & ((std::uint64_t{1} << 52) - 1)) | std::uint64_t{1023} << 52);
  if (fraction < threshold) --e;
  const int h = e + 1 - bits;
  const double inverse = power_of_two_double(-h);
  const double y_lower = lower * inverse;
  const double y_upper = upper * inverse;
  if (!(y_upper < threshold * (1 << bits))) return std::nullopt;
  const double moved = direction == Direction::down ? -shift : shift;
  const long k = static_cast<long>(y_lower + moved - margin);
  if (k != static_cast<long>(y_upper + moved + margin)) return std::nullopt;
  return Dyadic{direction == Direction::down ? k : k + 1, h};
}

}  // namespace

std::optional<Dyadic> round_down_positive(double lower, double upper) {
  return round_positive_fast(lower, upper, Direction::down);
}
std::optional<Dyadic> round_up_positive(double lower, double upper) {
  return round_positive_fast(lower, upper, Direction::up);
}

}  // namespace bezcert
