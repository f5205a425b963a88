// outward_double.hpp: what two doubles say of a rounding is what rational arithmetic says, also next to the
// breakpoints of the grid and in every rounding mode.
#include "double_oracle.hpp"

#include "bezcert/number/outward_double.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cfenv>
#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

struct Range {
  double lower, upper;
};

double moved(double value, long steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, HUGE_VAL);
  for (; steps < 0; ++steps) value = std::nextafter(value, 0);
  return value;
}

// A point, a few doubles, or some part of 2^-10 wide; half of them begin within three doubles of a breakpoint
// of the grid, on either side.
Range random_range(Random& random) {
  double lower = std::ldexp(1 + static_cast<double>(random.integer(0, (1L << 52) - 1)) * 0x1p-52, 0);
  if (random.chance(50)) {
    const bool change_of_step = random.chance(10);
    const auto k = static_cast<double>(random.integer(650, 1400));
    const double shift = (random.chance(50) ? 5.0 : -5.0) / 17;
    lower = moved(change_of_step ? 22.0 / 17 : k + shift, random.integer(-3, 3));
  }
  lower = std::ldexp(
      lower, static_cast<int>(random.chance(20) ? random.integer(-920, 920) : random.integer(-40, 40)));
  double upper = lower;
  if (random.chance(30)) upper = moved(lower, random.integer(1, 5));
  if (random.chance(30)) upper = lower * (1 + std::ldexp(1.0, static_cast<int>(random.integer(-52, -10))));
  return {lower, upper};
}

void attack(std::uint64_t seed, long cases) {
  Random random(seed);
  constexpr std::array modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  long known = 0, wide = 0, open = 0, differ = 0;
  for (long i = 0; i < cases; ++i) {
    const auto [lower, upper] = random_range(random);
    std::fesetround(modes[static_cast<std::size_t>(random.integer(0, 3))]);
    const std::optional<Dyadic> down = round_down_positive(lower, upper),
                                up = round_up_positive(lower, upper);
    std::fesetround(FE_TONEAREST);
    const Rational low(lower), high(upper);
    INFO("seed " << seed << " case " << i << ": " << std::hexfloat << lower << ", " << upper);
    for (const bool is_up : {false, true}) {
      const std::optional<Dyadic>& found = is_up ? up : down;
      const Rational at_low = to_rational(is_up ? round_up(low) : round_down(low));
      const Rational at_high = to_rational(is_up ? round_up(high) : round_down(high));
      if (found) {
        REQUIRE(to_rational(*found) == at_low);
        REQUIRE(to_rational(*found) == at_high);
      }
      ++(found ? known : open);
      if (found && lower < upper) ++wide;
      if (at_low != at_high) ++differ;
    }
  }
  INFO("seed " << seed << ": known " << known << ", wide " << wide << ", open " << open << ", differ "
               << differ);
  CHECK(known > cases / 2);
  CHECK(wide > cases / 5);
  CHECK(open > cases / 5);
  CHECK(differ > cases / 50);
}

}  // namespace

TEST_CASE("roundings from two doubles are those of rationals: 200,000 cases") {
  attack(seed_or(508), 200000);
}

TEST_CASE("roundings from two doubles are those of rationals: 10 million cases", "[.nightly]") {
  attack(seed_or(509), 10000000);
}

TEST_CASE("roundings from two doubles: nothing is known of what is no positive normal number") {
  for (const double value : {0.0, -1.0, 0x1p-901, 0x1.1p900, HUGE_VAL, std::nan("")}) {
    CHECK(!round_down_positive(value, value));
    CHECK(!round_up_positive(value, value));
  }
  CHECK(!round_down_positive(1, std::nan("")));
}
