// rational.hpp: exact values of doubles, powers, floors, and their texts.
#include "double_oracle.hpp"

#include "bezcert/number/parse.hpp"
#include "bezcert/number/rational.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Rational random_rational(Random& random, int bits = 60) {
  const long limit = 1L << random.integer(1, bits);
  const long p = random.integer(-limit, limit);
  const long q = random.integer(1, limit);
  return Rational(p) / Rational(q);
}

/// The number of characters that are digits, leading zeros not counted, exponent not counted.
int significant_digits(const std::string& decimal) {
  const std::string mantissa = decimal.substr(0, decimal.find('e'));
  int count = 0;
  for (const char c : mantissa) {
    if (c >= '0' && c <= '9' && (c != '0' || count > 0)) ++count;
  }
  return count;
}

/// 10^k with 10^k <= |x| < 10^(k+1), x not 0.
Rational leading_unit(const Rational& x) {
  const Rational size = x < 0 ? Rational(-x) : x;
  Rational unit = 1;
  while (unit > size) unit /= 10;
  while (unit * 10 <= size) unit *= 10;
  return unit;
}

}  // namespace

TEST_CASE("exact gives the value that the bits of a double stand for") {
  const std::uint64_t seed = seed_or(121);
  Random random(seed);
  long subnormal = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = random_bits_double(random);
    subnormal += std::fabs(x) < 0x1p-1022;
    if (exact(x) != value_of(x)) {
      INFO("seed " << seed << ", " << hex(x));
      FAIL("wrong value");
    }
  }
  CHECK(subnormal > 300);
  CHECK(exact(-0.0) == 0);
  CHECK_THROWS_AS(exact(not_a_number), std::invalid_argument);
  CHECK_THROWS_AS(exact(infinity), std::invalid_argument);
  CHECK_THROWS_AS(exact(-infinity), std::invalid_argument);
}

TEST_CASE("is_binary64 recognises exactly the doubles") {
  const std::uint64_t seed = seed_or(122);
  Random random(seed);
  long doubles = 0, others = 0;
  for (int i = 0; i < 4000; ++i) {
    const double x = random_bits_double(random);
    const Rational value = value_of(x);
    INFO("seed " << seed << ", case " << i << ", " << hex(x));
    double read = 0;
    if (!is_binary64(value, read) || read != x) FAIL("a double not recognised");
    ++doubles;
    // Halfway to the next double, and a number that is no dyadic.
    const Rational step = dyadic(1, parts_of(x).exponent - 1);
    if (is_binary64(value + step, read)) FAIL("halfway taken for a double");
    if (is_binary64(value + step / 3, read)) FAIL("a third of a step taken for a double");
    others += 2;
  }
  CHECK(doubles == 4000);
  CHECK(others == 8000);
  double read = 0;
  CHECK_FALSE(is_binary64(dyadic(1, 1024), read));
  CHECK_FALSE(is_binary64(dyadic(-1, 2000), read));
  CHECK_FALSE(is_binary64(dyadic(1, -1075), read));
  CHECK_FALSE(is_binary64(dyadic(1, 53) + 1, read));
  CHECK_FALSE(is_binary64(Rational(1, 3), read));
  CHECK(is_binary64(Rational(0), read));
  CHECK(read == 0);
}

TEST_CASE("power_of_two and power follow the laws of exponents") {
  CHECK(power_of_two(0) == 1);
  CHECK(power_of_two(10) == 1024);
  CHECK(power_of_two(-3) == Rational(1, 8));
  for (const long k : {1L, 2L, 53L, 64L, 1023L, 1074L, 5000L, 20000L}) {
    INFO("k = " << k);
    CHECK(power_of_two(k) == dyadic(1, k));
    CHECK(power_of_two(k) * power_of_two(-k) == 1);
    CHECK(power_of_two(-k - 1) * 2 == power_of_two(-k));
  }
  const std::uint64_t seed = seed_or(123);
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    const Rational base = random_rational(random, 20);
    const int n = static_cast<int>(random.integer(0, 30));
    Rational product = 1;
    for (int k = 0; k < n; ++k) product *= base;
    INFO("seed " << seed << ", base " << base << ", exponent " << n);
    if (power(base, n) != product) FAIL("wrong power");
  }
  CHECK(power(Rational(0), 0) == 1);
  CHECK(power(Rational(0), 5) == 0);
}

TEST_CASE("floor is the largest integer not above, sign the sign") {
  const std::uint64_t seed = seed_or(124);
  Random random(seed);
  long negative = 0, whole = 0;
  for (int i = 0; i < 3000; ++i) {
    Rational x = random_rational(random, 40) * random.integer(1, 50);
    if (random.chance(30)) x = Rational(random.integer(-50, 50));
    const Integer below = floor(x);
    INFO("seed " << seed << ", x = " << x);
    if (Rational(below) > x || Rational(Integer(below + 1)) <= x) FAIL("floor " << below);
    if (sign(x) != (x > 0) - (x < 0)) FAIL("sign");
    if (sign(below) != (below > 0) - (below < 0)) FAIL("sign of an integer");
    negative += x < 0;
    whole += denominator(x) == 1;
  }
  CHECK(negative > 1000);
  CHECK(whole > 500);
  CHECK(floor(Rational(-1, 2)) == -1);
  CHECK(floor(Rational(-3)) == -3);
  CHECK(sign(Rational(0)) == 0);
  CHECK(sign(Integer(0)) == 0);
}

TEST_CASE("to_string is p/q in lowest terms, or p") {
  CHECK(to_string(Rational(0)) == "0");
  CHECK(to_string(Rational(7)) == "7");
  CHECK(to_string(Rational(-7)) == "-7");
  CHECK(to_string(Rational(6, 4)) == "3/2");
  CHECK(to_string(Rational(-6, 4)) == "-3/2");
  CHECK(to_string(Rational(3) / Rational(-7)) == "-3/7");
  CHECK(to_string(Rational(12, 4)) == "3");
  CHECK(to_string(dyadic(1, 70)) == "1180591620717411303424");
  const std::uint64_t seed = seed_or(125);
  Random random(seed);
  for (int i = 0; i < 1000; ++i) {
    const Rational x = random_rational(random);
    INFO("seed " << seed << ", x = " << x);
    if (parse_rational(to_string(x)) != x) FAIL("not read back");
  }
}

TEST_CASE("to_decimal on known values") {
  CHECK(to_decimal(Rational(-598, 100000)) == "-0.00598");
  CHECK(to_decimal(Rational(3, 2) / power(Rational(10), 12)) == "1.5e-12");
  CHECK(to_decimal(Rational(0)) == "0");
  CHECK(to_decimal(Rational(1)) == "1");
  CHECK(to_decimal(Rational(-1, 2)) == "-0.5");
  CHECK(to_decimal(Rational(1, 3)) == "0.333333");
  CHECK(to_decimal(Rational(2, 3)) == "0.666667");
  CHECK(to_decimal(Rational(-2, 3), 3) == "-0.667");
  CHECK(to_decimal(Rational(1, 3), 1) == "0.3");
  CHECK(to_decimal(Rational(100)) == "100");
  CHECK(to_decimal(Rational(999), 2) == "1000");
  CHECK(to_decimal(Rational(22, 7), 20) == "3.1428571428571428571");
}

TEST_CASE("to_decimal rounds numbers next to halfway to their side") {
  for (const long exponent : {20L, 60L, 100L, 300L}) {
    INFO("2^-" << exponent << " beside halfway");
    CHECK(to_decimal(1234565 + dyadic(1, -exponent)) == "1234570");
    CHECK(to_decimal(1234575 - dyadic(1, -exponent)) == "1234570");
    CHECK(to_decimal(-1234565 - dyadic(1, -exponent)) == "-1234570");
  }
}

TEST_CASE("to_decimal is the nearest number of so many digits") {
  const std::uint64_t seed = seed_or(126);
  Random random(seed);
  long small = 0, large = 0, carried = 0;
  for (int i = 0; i < 3000; ++i) {
    Rational x = random_rational(random);
    if (random.chance(10))
      x = 1 - 1 / Rational(integer_power(10, random.integer(5, 20)));  // 0.99999: carries
    const long scale = random.integer(-40, 40);
    x *= scale < 0 ? 1 / Rational(integer_power(10, -scale)) : Rational(integer_power(10, scale));
    if (x == 0) continue;
    const int digits = static_cast<int>(random.integer(1, 17));
    const std::string text = to_decimal(x, digits);
    INFO("seed " << seed << ", x = " << x << ", digits " << digits << ", text " << text);
    const auto shown = parse_decimal(text);
    if (!shown) FAIL("not a decimal");
    const Rational unit = leading_unit(x) / Rational(integer_power(10, digits - 1));
    const Rational error = *shown < x ? Rational(x - *shown) : Rational(*shown - x);
    if (2 * error > unit) FAIL("not the nearest");
    if (denominator(*shown / unit) != 1) FAIL("too many digits");
    if (text.find('.') != std::string::npos && significant_digits(text) > digits) FAIL("more digits shown");
    small += leading_unit(x) < Rational(1, 1000000);
    large += leading_unit(x) > 1000000;
    carried += leading_unit(*shown) > leading_unit(x);
  }
  CHECK(small > 500);
  CHECK(large > 500);
  CHECK(carried > 50);
}
