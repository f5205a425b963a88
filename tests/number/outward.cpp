// outward.hpp: the rounding is the one of its definition, for rationals and for intervals.
#include "double_oracle.hpp"

#include "bezcert/number/interval.hpp"
#include "bezcert/number/outward.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Integer floor_of(const Rational& x) {
  Integer quotient = numerator(x) / denominator(x);  // towards zero
  if (Rational(quotient) > x) quotient -= 1;
  return quotient;
}

/// The definition in the header, step by step, for x > 0.
struct Grid {
  Rational down, up, step;
};
Grid positive_grid(const Rational& x, int bits) {
  const Rational first(22, 17);
  long e = static_cast<long>(msb(numerator(x))) - static_cast<long>(msb(denominator(x)));
  while (x < first * dyadic(1, e)) --e;
  while (x >= first * dyadic(1, e + 1)) ++e;
  const Rational h = dyadic(1, e + 1 - bits);
  return {h * Rational(floor_of(x / h - Rational(5, 17))),
          h * Rational(floor_of(x / h + Rational(5, 17)) + 1), h};
}

Rational expected_down(const Rational& x, int bits) {
  if (x == 0) return 0;
  return x > 0 ? positive_grid(x, bits).down : -positive_grid(-x, bits).up;
}
Rational expected_up(const Rational& x, int bits) { return -expected_down(-x, bits); }

Rational value_of(const Dyadic& d) { return dyadic(d.mantissa, d.exponent); }

int random_bits(Random& random) {
  return random.chance(50) ? report_bits : static_cast<int>(random.integer(2, 40));
}

/// Random numbers of all sizes, short dyadic ones, and numbers at and next to the breakpoints of the grid.
Rational random_value(Random& random, int bits) {
  const long kind = random.integer(0, 3);
  long exponent = random.integer(-60, 60);
  if (random.chance(10)) exponent *= 20;
  const int sign = random.chance(50) ? 1 : -1;
  const Rational unit = sign * dyadic(1, exponent);
  const long p = random.integer(1, 1L << 50);
  if (kind == 0) return unit * Rational(p) / random.integer(1, 1L << 50);
  if (kind == 1) return unit * random.integer(1, 1L << random.integer(1, 12));
  Rational at =
      kind == 2 ? Rational(22, 17) : dyadic(random.integer(1L << bits, 2L << bits), 0) + Rational(5, 17);
  if (kind == 3 && random.chance(50)) at -= Rational(10, 17);
  const long side = random.integer(-1, 1);
  return unit * (at + side * dyadic(1, -random.integer(60, 90)));
}

std::string show(const Dyadic& d) {
  return std::to_string(d.mantissa) + " * 2^" + std::to_string(d.exponent);
}

}  // namespace

TEST_CASE("rounding rationals follows the definition in the header") {
  const std::uint64_t seed = seed_or(151);
  Random random(seed);
  long positive = 0, negative = 0, on_grid = 0;
  for (int i = 0; i < 12000; ++i) {
    const int bits = random_bits(random);
    const Rational x = random_value(random, bits);
    const Dyadic down = round_down(x, bits);
    const Dyadic up = round_up(x, bits);
    INFO("seed " << seed << ", case " << i << ", bits " << bits << ", x = " << x << ", down " << show(down)
                 << ", up " << show(up));
    if (value_of(down) != expected_down(x, bits)) FAIL("round_down");
    if (value_of(up) != expected_up(x, bits)) FAIL("round_up");
    if (to_rational(down) != value_of(down) || to_rational(up) != value_of(up)) FAIL("to_rational");
    if (value_of(down) > x || value_of(up) < x) FAIL("not outward");
    if (x > 0 && value_of(up) == x) FAIL("round_up(x) > x");
    if (sign(down) != value_of(down).sign() || sign(up) != value_of(up).sign()) FAIL("sign");
    const Rational step = positive_grid(x > 0 ? x : Rational(-x), bits).step;
    if (value_of(up) - value_of(down) > 2 * step) FAIL("wider than two steps");
    if (!(round_down(-x, bits) == Dyadic{-up.mantissa, up.exponent})) FAIL("mirror of round_up");
    if (!(round_up(-x, bits) == Dyadic{-down.mantissa, down.exponent})) FAIL("mirror of round_down");
    (x > 0 ? positive : negative) += 1;
    on_grid += floor_of(x / step) * step == x;
  }
  CHECK(positive > 5000);
  CHECK(negative > 5000);
  CHECK(on_grid > 1000);
}

TEST_CASE("zero rounds to zero, intervals without a sign round to nothing") {
  for (const int bits : {2, report_bits, 40}) {
    CHECK(to_rational(round_down(Rational(0), bits)) == 0);
    CHECK(to_rational(round_up(Rational(0), bits)) == 0);
    CHECK(round_down(Interval(0), bits) == round_down(Rational(0), bits));
    CHECK(round_up(Interval(0), bits) == round_up(Rational(0), bits));
    for (const Interval& unsure :
         {Interval(-1, 1), Interval(0, 1), Interval(-1, 0), Interval(0, smallest_double),
          Interval(-smallest_double, 0), Interval(-infinity, infinity), Interval(not_a_number, not_a_number),
          Interval(1, infinity), Interval(-infinity, -1), Interval(largest_double, infinity),
          Interval(0, infinity)}) {
      CHECK(round_down(unsure, bits) == std::nullopt);
      CHECK(round_up(unsure, bits) == std::nullopt);
    }
  }
  CHECK(sign(Dyadic{}) == 0);
  CHECK(sign(Dyadic{3, -5}) == 1);
  CHECK(sign(Dyadic{-3, 5}) == -1);
  CHECK(to_rational(Dyadic{-3, -2}) == Rational(-3, 4));
  CHECK(to_rational(Dyadic{5, 70}) == dyadic(5, 70));
}

TEST_CASE("known values of the rounding") {
  // 1 < 22/17, so e = -1 and h = 2^-10: floor(1024 - 5/17) = 1023, floor(1024 + 5/17) + 1 = 1025.
  CHECK(to_rational(round_down(Rational(1))) == Rational(1023, 1024));
  CHECK(to_rational(round_up(Rational(1))) == Rational(1025, 1024));
  // 3/2 >= 22/17, so e = 0 and h = 2^-9: 768 - 5/17 and 768 + 5/17.
  CHECK(to_rational(round_down(Rational(3, 2))) == Rational(767, 512));
  CHECK(to_rational(round_up(Rational(3, 2))) == Rational(769, 512));
  // 2 bits, 22/17 itself: e = 0, h = 1/2: x/h = 44/17, floor(39/17) = 2, floor(49/17) + 1 = 3.
  CHECK(to_rational(round_down(Rational(22, 17), 2)) == 1);
  CHECK(to_rational(round_up(Rational(22, 17), 2)) == Rational(3, 2));
  CHECK(to_rational(round_down(Rational(-3, 2))) == Rational(-769, 512));
  CHECK(to_rational(round_up(Rational(-3, 2))) == Rational(-767, 512));
}

TEST_CASE("an interval rounds as every number in it, or not at all") {
  const std::uint64_t seed = seed_or(153);
  Random random(seed);
  long decided = 0, undecided_because_different = 0, undecided = 0, extreme = 0;
  for (int i = 0; i < 12000; ++i) {
    const int bits = random_bits(random);
    double low = 0, high = 0;
    if (random.chance(30)) {  // any double, point or a few units wide
      low = random_bits_double(random);
      const std::uint64_t other = bits_of(low) + static_cast<std::uint64_t>(random.integer(0, 3));
      high = is_finite_bits(other) ? from_bits(other) : low;
    } else {
      const Rational x = random_value(random, bits);
      const Rational radius = (x < 0 ? Rational(-x) : x) * dyadic(1, -random.integer(bits / 2, 60));
      low = around(x - radius).below;
      high = around(x + radius).above;
    }
    if (high < low) std::swap(low, high);
    if (std::isinf(low) || std::isinf(high)) continue;
    const Interval enclosure(low, high);
    std::optional<Dyadic> down, up;
    if (random.chance(50)) {
      const RoundUp rounding;
      down = round_down(enclosure, bits);
      up = round_up(enclosure, bits);
    } else {
      down = round_down(enclosure, bits);
      up = round_up(enclosure, bits);
    }
    const Rational from = test::value_of(low);
    const Rational to = test::value_of(high);
    INFO("seed " << seed << ", case " << i << ", bits " << bits << ", " << hex(low) << " to " << hex(high));
    for (const int k : {0, 1, 2, 3, 4}) {
      const Rational x = from + (to - from) * k / 4;
      if (down && !(*down == round_down(x, bits))) FAIL("round_down " << show(*down));
      if (up && !(*up == round_up(x, bits))) FAIL("round_up " << show(*up));
    }
    const bool all = down && up;
    decided += all;
    undecided += !all;
    undecided_because_different += !all && (!(round_down(from, bits) == round_down(to, bits)) ||
                                            !(round_up(from, bits) == round_up(to, bits)));
    extreme += std::fabs(high) < 0x1p-1000 || std::fabs(high) > 0x1p1000;
  }
  CHECK(decided > 3000);
  CHECK(undecided > 1000);
  CHECK(undecided_because_different > 500);
  CHECK(extreme > 200);
}

TEST_CASE("tiny intervals around short dyadic numbers round to one grid point") {
  const std::uint64_t seed = seed_or(154);
  Random random(seed);
  long negative = 0, coarse = 0;
  for (int i = 0; i < 4000; ++i) {
    // At most bits + 4 significant bits: x/h is a multiple of 1/16, at least 1/272 away from a breakpoint, so
    // a relative half-width of 2^-(bits + 10) cannot reach one.
    const int bits = random.chance(50) ? report_bits : static_cast<int>(random.integer(2, 34));
    const long mantissa = random.integer(1, (1L << (bits + 4)) - 1);
    const int sign = random.chance(50) ? 1 : -1;
    const Rational x = sign * dyadic(mantissa, random.integer(-200, 200));
    const long fineness = random.integer(bits + 10, 50);
    const Rational radius = (x < 0 ? Rational(-x) : x) * dyadic(1, -fineness);
    const Interval enclosure(around(x - radius).below, around(x + radius).above);
    const auto down = round_down(enclosure, bits);
    const auto up = round_up(enclosure, bits);
    INFO("seed " << seed << ", case " << i << ", bits " << bits << ", x = " << x << ", radius 2^-"
                 << fineness);
    if (!down || !up) FAIL("not decided");
    if (!(*down == round_down(x, bits)) || !(*up == round_up(x, bits))) FAIL("different");
    negative += x < 0;
    coarse += fineness < 30;
  }
  CHECK(negative > 1500);
  CHECK(coarse > 500);
}

TEST_CASE("the double interval of a number decides nearly always at the precision of reports") {
  const std::uint64_t seed = seed_or(155);
  Random random(seed);
  long decided = 0;
  for (int i = 0; i < 5000; ++i) {
    const long p = random.integer(-(1L << 50), 1L << 50);
    const Rational x = Rational(p) / random.integer(1, 1L << 30);
    const auto down = round_down(to_interval(x));
    const auto up = round_up(to_interval(x));
    INFO("seed " << seed << ", x = " << x);
    if (down && !(*down == round_down(x))) FAIL("round_down");
    if (up && !(*up == round_up(x))) FAIL("round_up");
    decided += down && up;
  }
  CHECK(decided > 4990);
}

TEST_CASE("a dyadic number is written as the rational it is, or not at all") {
  const std::uint64_t seed = seed_or(77);
  Random random(seed);
  int whole = 0, fractions = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    Dyadic d{random.integer(-2048, 2048), random.integer(-80, 10)};
    if (random.chance(5)) d.exponent = random.integer(-2000, 2000);
    if (random.chance(5)) d.mantissa = random.integer(-(1L << 40), 1L << 40) << random.integer(0, 20);
    std::array<char, 40> text{};
    const char* const end = write_short(d, text.data());
    INFO("seed " << seed << " case " << i << ": " << d.mantissa << " * 2^" << d.exponent);
    const std::string expected = to_string(to_rational(d));
    if (end == nullptr) {
      REQUIRE((denominator(to_rational(d)) >= Integer(1) << 63 ||
               abs(numerator(to_rational(d))) >= Integer(1) << 63));
      ++refused;
      continue;
    }
    REQUIRE(std::string(text.data(), static_cast<std::size_t>(end - text.data())) == expected);
    ++(expected.find('/') == std::string::npos ? whole : fractions);
  }
  CHECK(whole > 300);
  CHECK(fractions > 10000);
  CHECK(refused > 1000);
}
