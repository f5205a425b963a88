// interval.hpp: intervals contain the exact results, conversions are tight, certain signs are right.
#include "double_oracle.hpp"

#include "bezcert/number/interval.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace bezcert;
using namespace bezcert::test;

namespace {

enum class Range { moderate, wide, everything };

double random_double(Random& random, Range range) {
  switch (range) {
    case Range::moderate: return random.any_double(-3, 3);
    case Range::wide: return random.any_double(-300, 300);
    case Range::everything: return random_bits_double(random);
  }
  return 0;
}

/// An interval with a number in it: the ends and inner points, points and wide intervals.
struct Enclosed {
  Interval interval;
  Rational number;
};

Enclosed random_enclosed(Random& random, Range range) {
  double low = random_double(random, range);
  double high = random_double(random, range);
  if (random.chance(25)) high = low;
  if (random.chance(25)) {  // a few units in the last place wide
    const auto steps = static_cast<std::uint64_t>(random.integer(1, 4));
    if (is_finite_bits(bits_of(low) + steps)) high = from_bits(bits_of(low) + steps);
  }
  if (high < low) std::swap(low, high);
  const Rational from = value_of(low);
  const Rational to = value_of(high);
  return {Interval(low, high), from + (to - from) * random.integer(0, 16) / 16};
}

bool contains(const Interval& interval, const Rational& x) {
  const double low = interval.inf();
  const double high = interval.sup();
  if (low != low || high != high) return false;
  return (low == -infinity || (low != infinity && value_of(low) <= x)) &&
         (high == infinity || (high != -infinity && x <= value_of(high)));
}

bool is_nan(const Interval& interval) {
  const double low = interval.inf();
  const double high = interval.sup();
  return low != low || high != high;
}

std::string show(const Interval& interval) {
  return "[" + hex(interval.inf()) + ", " + hex(interval.sup()) + "]";
}

/// An operation on both forms; no number if the divisor is 0.
std::optional<Enclosed> apply(long operation, const Enclosed& a, const Enclosed& b) {
  switch (operation) {
    case 0: return Enclosed{a.interval + b.interval, a.number + b.number};
    case 1: return Enclosed{a.interval - b.interval, a.number - b.number};
    case 2: return Enclosed{a.interval * b.interval, a.number * b.number};
    default:
      if (b.number == 0) return std::nullopt;
      return Enclosed{a.interval / b.interval, a.number / b.number};
  }
}

}  // namespace

TEST_CASE("one operation on intervals contains the exact result, in every range of doubles") {
  const std::uint64_t seed = seed_or(131);
  Random random(seed);
  long done[4] = {}, unbounded = 0, subnormal = 0, nan = 0;
  const RoundUp up;
  for (int i = 0; i < 24000; ++i) {
    const Range range = static_cast<Range>(i % 3);
    const Enclosed a = random_enclosed(random, range);
    const Enclosed b = random_enclosed(random, range);
    const long operation = random.integer(0, 3);
    const auto result = apply(operation, a, b);
    if (!result) continue;
    if (is_nan(result->interval)) {  // says nothing: allowed, as certain_sign then asks the exact numbers
      ++nan;
      if (certain_sign(result->interval)) FAIL("a sign from a NaN");
      continue;
    }
    if (!contains(result->interval, result->number)) {
      INFO("seed " << seed << ", case " << i << ", operation " << operation << " on " << show(a.interval)
                   << " and " << show(b.interval) << " gives " << show(result->interval));
      INFO("numbers " << a.number << " and " << b.number << " give " << result->number);
      FAIL("not contained");
    }
    ++done[operation];
    unbounded += std::isinf(result->interval.inf()) || std::isinf(result->interval.sup());
    subnormal += result->interval.sup() != 0 && std::fabs(result->interval.sup()) < 0x1p-1022;
  }
  for (const long count : done) CHECK(count > 4000);
  CHECK(unbounded > 500);
  CHECK(subnormal > 100);
  CHECK(nan < 100);
}

TEST_CASE("one operation on points is the tightest interval where nothing overflows") {
  const std::uint64_t seed = seed_or(132);
  Random random(seed);
  long points = 0, proper = 0;
  const RoundUp up;
  for (int i = 0; i < 8000; ++i) {
    const double x = random.any_double(-100, 100);
    const double y = random.any_double(-100, 100);
    const long operation = random.integer(0, 3);
    const auto result = apply(operation, {Interval(x), value_of(x)}, {Interval(y), value_of(y)});
    if (!result) continue;
    const auto [below, above] = around(result->number);
    if (result->interval.inf() != below || result->interval.sup() != above) {
      INFO("seed " << seed << ", operation " << operation << " on " << hex(x) << ", " << hex(y));
      FAIL(show(result->interval) << " instead of " << show(Interval(below, above)));
    }
    (below == above ? points : proper) += 1;
  }
  CHECK(proper > 6000);
  CHECK(points > 5);
}

TEST_CASE("chains of operations on intervals contain the exact result") {
  const std::uint64_t seed = seed_or(133);
  Random random(seed);
  long chains = 0, bounded = 0, nan = 0;
  const RoundUp up;
  for (int i = 0; i < 3000; ++i) {
    const Range range = static_cast<Range>(i % 3);
    Enclosed value = random_enclosed(random, range);
    const long length = random.integer(2, 12);
    for (long k = 0; k < length; ++k) {
      const Enclosed other = random_enclosed(random, range);
      const bool exchanged = random.chance(50);
      const auto next = apply(random.integer(0, 3), exchanged ? other : value, exchanged ? value : other);
      if (next) value = *next;
      if (is_nan(value.interval)) break;
      if (!contains(value.interval, value.number)) {
        INFO("seed " << seed << ", chain " << i << ", step " << k);
        FAIL(show(value.interval) << " without " << value.number);
      }
    }
    ++chains;
    nan += is_nan(value.interval);
    bounded += std::isfinite(value.interval.inf()) && std::isfinite(value.interval.sup());
  }
  CHECK(chains == 3000);
  CHECK(bounded > 700);
  CHECK(nan < 200);
}

TEST_CASE("determinants in intervals contain the exact determinant and sign it rightly") {
  const std::uint64_t seed = seed_or(134);
  Random random(seed);
  const RoundUp up;
  long positive = 0, negative = 0, zero = 0, unsure = 0, unsure_zero = 0;
  for (int i = 0; i < 4000; ++i) {
    Interval a[9];
    Rational x[9];
    // Small integers are often singular; other entries nearly so: a row is nearly a sum of the others.
    const bool small = random.chance(50);
    for (int k = 0; k < 9; ++k) {
      double entry = small ? static_cast<double>(random.integer(-3, 3)) : random.any_double(0, 10);
      if (!small && k >= 6) entry = (a[k - 6] + a[k - 3]).sup();
      a[k] = Interval(entry);
      x[k] = value_of(entry);
    }
    const auto det = [](const auto* m) {
      return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
             m[2] * (m[3] * m[7] - m[4] * m[6]);
    };
    const Interval enclosure = det(a);
    const Rational value = det(x);
    INFO("seed " << seed << ", case " << i << ", " << show(enclosure) << ", exactly " << value);
    if (!contains(enclosure, value)) FAIL("not contained");
    const auto known = certain_sign(enclosure);
    if (known && *known != value.sign()) FAIL("wrong sign");
    positive += known == 1;
    negative += known == -1;
    zero += known == 0;
    unsure += !known;
    unsure_zero += !known && value == 0;
  }
  CHECK(positive > 500);
  CHECK(negative > 500);
  CHECK(zero > 100);
  CHECK(unsure > 1000);
  CHECK(unsure_zero > 10);
}

TEST_CASE("certain_sign answers exactly when all numbers of the interval have one sign") {
  const std::uint64_t seed = seed_or(135);
  Random random(seed);
  long seen[4] = {};
  for (int i = 0; i < 4000; ++i) {
    double low = random_double(random, static_cast<Range>(i % 3));
    double high = random_double(random, static_cast<Range>(i % 3));
    if (random.chance(20)) high = low;
    if (random.chance(10)) low = random.chance(50) ? 0.0 : -0.0;
    if (random.chance(10)) high = random.chance(50) ? 0.0 : -0.0;
    if (high < low) std::swap(low, high);
    const Rational from = value_of(low);
    const Rational to = value_of(high);
    constexpr int none = 2;
    const int expected = from.sign() == to.sign() ? from.sign() : none;
    if (certain_sign(Interval(low, high)).value_or(none) != expected) {
      INFO("seed " << seed);
      FAIL(hex(low) << " to " << hex(high));
    }
    ++seen[expected + 1];
  }
  for (const long count : seen) CHECK(count > 30);
}

TEST_CASE("infinite bounds sign only what they prove, NaN nothing") {
  CHECK(certain_sign(Interval(1, infinity)) == 1);
  CHECK(certain_sign(Interval(smallest_double, infinity)) == 1);
  CHECK(certain_sign(Interval(-infinity, -smallest_double)) == -1);
  CHECK(certain_sign(Interval(0, infinity)) == std::nullopt);
  CHECK(certain_sign(Interval(-infinity, 0)) == std::nullopt);
  CHECK(certain_sign(Interval(-infinity, infinity)) == std::nullopt);
  CHECK(certain_sign(Interval(not_a_number, not_a_number)) == std::nullopt);
  const RoundUp up;
  const Interval huge(largest_double);
  const Interval line = huge * huge - huge * huge;
  CHECK(certain_sign(line) == std::nullopt);
  CHECK(certain_sign(line * Interval(0)) != 1);
  CHECK(certain_sign(line * Interval(0)) != -1);
  CHECK(certain_sign(line + huge) == std::nullopt);
  CHECK(certain_sign(huge * huge) == 1);
  CHECK(certain_sign(-huge * huge) == -1);
  CHECK(certain_sign(Interval(1) / Interval(-1, 1)) == std::nullopt);
}

TEST_CASE("to_interval is the smallest interval around a rational, in and out of a rounding scope") {
  const std::uint64_t seed = seed_or(136);
  Random random(seed);
  long points = 0, proper = 0, subnormal = 0, beyond = 0;
  const auto check = [&](const Rational& x) {
    const auto [below, above] = around(x);
    const Interval outside = to_interval(x);
    const bool right = outside.inf() == below && outside.sup() == above;
    const RoundUp up;
    const Interval inside = to_interval(x);
    if (!right || inside.inf() != below || inside.sup() != above) {
      INFO("seed " << seed << ", x = " << x << ", between " << hex(below) << " and " << hex(above));
      FAIL(show(outside) << " outside, " << show(inside) << " inside");
    }
    (below == above ? points : proper) += 1;
    subnormal += x != 0 && std::fabs(below) < 0x1p-1022 && std::fabs(above) <= 0x1p-1022;
    beyond += std::isinf(below) || std::isinf(above);
  };
  check(Rational(0));
  for (const int s : {1, -1}) {
    check(s * dyadic(1, 1024));
    check(s * (dyadic(1, 1024) - dyadic(1, 970)));
    check(s * dyadic(1, 3000));
    check(s * dyadic(1, -1074));
    check(s * dyadic(1, -1075));
    check(s * dyadic(1, -3000));
    check(s * (dyadic(1, -1022) - dyadic(1, -1080)));
    check(s * (dyadic(1, -1022) + dyadic(1, -1080)));
    check(s * Rational(1, 3));
    check(s * (dyadic(1, 53) + 1));
  }
  for (int i = 0; i < 3000; ++i) {
    const Rational x = value_of(random_bits_double(random));
    const long kind = random.integer(0, 3);
    if (kind == 0) check(x);
    if (kind == 1) check(x / 3);
    if (kind == 2) check(x + dyadic(random.integer(-3, 3), random.integer(-1080, 10)));
    if (kind == 3) check(x * random.integer(1, 1L << 50) / (1L << 25));
  }
  CHECK(points > 500);
  CHECK(proper > 1500);
  CHECK(subnormal > 50);
  CHECK(beyond >= 6);  // those listed
}

TEST_CASE("to_interval is the smallest interval around an integer") {
  const std::uint64_t seed = seed_or(137);
  Random random(seed);
  long points = 0, proper = 0, beyond = 0;
  for (int i = 0; i < 3000; ++i) {
    Integer x = random.integer(-(1L << 60), 1L << 60);
    if (random.chance(30)) x = random.integer(-100, 100);
    if (random.chance(50)) x <<= static_cast<unsigned>(random.integer(0, 1000));
    x += random.integer(-1, 1);
    const auto [below, above] = around(Rational(x));
    const Interval enclosure = to_interval(x);
    if (enclosure.inf() != below || enclosure.sup() != above) {
      INFO("seed " << seed << ", x = " << x);
      FAIL(show(enclosure));
    }
    (below == above ? points : proper) += 1;
    beyond += std::isinf(below) || std::isinf(above);
  }
  CHECK(points > 500);
  CHECK(proper > 1000);
  CHECK(beyond > 20);
}

TEST_CASE("a RoundUp rounds upwards while it lives, nested too, and restores the mode") {
  // By its effect: std::fegetround does not see the register that the protector of CGAL sets.
  const Around third = around(Rational(1, 3));
  const auto third_now = [] {
    volatile double one = 1;
    volatile double three = 3;
    return one / three;
  };
  REQUIRE(third_now() == third.below);  // the nearest is the lower one
  {
    const RoundUp outer;
    CHECK(third_now() == third.above);
    {
      const RoundUp inner;
      CHECK(third_now() == third.above);
    }
    CHECK(third_now() == third.above);
  }
  CHECK(third_now() == third.below);
}
