// parse.hpp: text becomes exactly the number it says, or nothing.
#include "double_oracle.hpp"

#include "bezcert/number/parse.hpp"

#include <catch2/catch.hpp>

#include <charconv>
#include <cmath>
#include <string>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// sign digits 10^exponent, with its text in one of several spellings.
struct Decimal {
  std::string text;
  Rational value;
};

Rational times_power_of_ten(const Integer& digits, long exponent) {
  const Integer power = integer_power(10, exponent >= 0 ? exponent : -exponent);
  return exponent >= 0 ? Rational(Integer(digits * power)) : Rational(digits) / Rational(power);
}

Decimal random_decimal(Random& random, int longest, long exponent_range) {
  const long count = random.integer(1, longest);
  std::string digits;
  Integer number = 0;
  for (long k = 0; k < count; ++k) {
    const long digit = random.integer(0, 9);
    digits += static_cast<char>('0' + digit);
    number = number * 10 + digit;
  }
  const long point = random.integer(0, count);  // digits after the point
  const long exponent = random.integer(-exponent_range, exponent_range);
  Decimal result;
  const bool negative = random.chance(40);
  result.text = negative ? "-" : random.chance(20) ? "+" : "";
  result.text += digits.substr(0, static_cast<std::size_t>(count - point));
  if (point > 0 || random.chance(20))
    result.text += "." + digits.substr(static_cast<std::size_t>(count - point));
  if (exponent != 0 || random.chance(20)) {
    result.text += random.chance(50) ? "e" : "E";
    if (exponent >= 0 && random.chance(50)) result.text += "+";
    result.text += std::to_string(exponent);
  }
  result.value = times_power_of_ten(negative ? Integer(-number) : number, exponent - point);
  return result;
}

/// The exact decimal of mantissa * 2^exponent.
std::string exact_decimal(const Integer& mantissa, long exponent) {
  if (exponent >= 0) return Integer(mantissa * integer_power(2, exponent)).str();
  return Integer(mantissa * integer_power(5, -exponent)).str() + "e" + std::to_string(exponent);
}

std::string text_of(double x, std::chars_format format) {
  char buffer[2000];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x, format);
  REQUIRE(error == std::errc());
  return {buffer, end};
}

}  // namespace

TEST_CASE("parse_binary64 reads back every double bit by bit, in every spelling that determines it") {
  const std::uint64_t seed = seed_or(101);
  Random random(seed);
  long subnormal = 0, huge = 0, tiny = 0, negative = 0;
  const auto check = [&](double x) {
    const DoubleParts parts = parts_of(x);
    const std::string texts[] = {
        text_of(x, std::chars_format::scientific), text_of(x, std::chars_format::fixed),
        text_of(x, std::chars_format::general),
        std::string(std::signbit(x) && x == 0 ? "-" : "") + exact_decimal(parts.mantissa, parts.exponent)};
    for (const std::string& text : texts) {
      const auto read = parse_binary64(text);
      if (!read || !same_bits(*read, x)) {
        INFO("seed " << seed << ", text " << text << " of " << hex(x) << ", read "
                     << (read ? hex(*read) : "-"));
        FAIL("not the same double");
      }
    }
  };
  for (const double x : {0.0, -0.0, 1.0, -1.0, 0.1, smallest_double, -smallest_double, largest_double,
                         -largest_double, 0x1p-1022, 0x0.fffffffffffffp-1022, 0x1p53, 0x1.fffffffffffffp-1,
                         1e23, 5e-324, 123456789012345680.0}) {
    check(x);
  }
  for (int i = 0; i < 6000; ++i) {
    const double x = random_bits_double(random);
    const double size = std::fabs(x);
    subnormal += size < 0x1p-1022;
    tiny += size >= 0x1p-1022 && size < 0x1p-500;
    huge += size > 0x1p500;
    negative += std::signbit(x);
    check(x);
  }
  CHECK(subnormal > 300);
  CHECK(huge > 500);
  CHECK(tiny > 500);
  CHECK(negative > 2000);
}

TEST_CASE("parse_decimal gives the exact value of a decimal, parse_binary64 the nearest double") {
  const std::uint64_t seed = seed_or(102);
  Random random(seed);
  long finite = 0, zero_below_all = 0, too_large = 0, subnormal = 0;
  for (int i = 0; i < 8000; ++i) {
    const bool wide = random.chance(50);
    const Decimal decimal = random_decimal(random, wide ? 60 : 20, wide ? 400 : 25);
    INFO("seed " << seed << ", case " << i << ", text " << decimal.text);
    const auto exact = parse_decimal(decimal.text);
    if (exact != decimal.value) FAIL("wrong decimal");
    if (parse_rational(decimal.text) != decimal.value) FAIL("wrong rational");
    const auto read = parse_binary64(decimal.text);
    const auto expected = nearest_double(decimal.value);
    if (read.has_value() != expected.has_value()) FAIL("range");
    if (!read) {
      ++too_large;
      continue;
    }
    if (*read != *expected) FAIL("read " << hex(*read) << ", nearest " << hex(*expected));
    ++finite;
    zero_below_all += *read == 0 && decimal.value != 0;
    subnormal += *read != 0 && std::fabs(*read) < 0x1p-1022;
  }
  CHECK(finite > 5000);
  CHECK(too_large > 100);
  CHECK(zero_below_all > 100);
  CHECK(subnormal > 40);
}

TEST_CASE("parse_binary64 rounds halfway cases to even and their neighbours to their side") {
  const std::uint64_t seed = seed_or(103);
  Random random(seed);
  long down = 0, up = 0, subnormal = 0;
  for (int i = 0; i < 1500; ++i) {
    const double x = std::fabs(random_bits_double(random));
    const double next = from_bits(bits_of(x) + 1);
    if (next == infinity) continue;
    const DoubleParts parts = parts_of(x);
    // Halfway to the next double: (2m + 1) 2^(e-1); 40 more digits 0...01 after it, and before it.
    const Integer half = 2 * Integer(parts.mantissa) + 1;
    const long exponent = parts.exponent - 1;
    Integer digits = exponent >= 0 ? Integer(half * integer_power(2, exponent))
                                   : Integer(half * integer_power(5, -exponent));
    const long shift = exponent >= 0 ? 0 : exponent;
    digits *= integer_power(10, 40);
    const auto text = [&](const Integer& number) { return number.str() + "e" + std::to_string(shift - 40); };
    const double even = (bits_of(x) & 1) == 0 ? x : next;
    INFO("seed " << seed << ", case " << i << ", between " << hex(x) << " and " << hex(next));
    const auto is = [](const std::optional<double>& read, double expected) {
      return read && same_bits(*read, expected);
    };
    if (!is(parse_binary64(exact_decimal(half, exponent)), even)) FAIL("halfway, short text");
    if (!is(parse_binary64(text(digits)), even)) FAIL("halfway");
    if (!is(parse_binary64(text(digits + 1)), next)) FAIL("just above halfway");
    if (!is(parse_binary64(text(digits - 1)), x)) FAIL("just below halfway");
    (same_bits(even, x) ? down : up) += 1;
    subnormal += x < 0x1p-1022;
  }
  CHECK(down > 500);
  CHECK(up > 500);
  CHECK(subnormal > 80);
}

TEST_CASE("parse_binary64 on known hard numbers") {
  CHECK(parse_binary64("9007199254740993") == 9007199254740992.0);  // 2^53 + 1: to even
  CHECK(parse_binary64("9007199254740995") == 9007199254740996.0);
  CHECK(parse_binary64("9007199254740993.0000000000000000000000001") == 9007199254740994.0);
  // 10^23 lies halfway between two doubles, 8388608 from each.
  const auto ten_to_23 = parse_binary64("1e23");
  REQUIRE(ten_to_23);
  CHECK(same_bits(*ten_to_23, 0x1.52d02c7e14af6p+76));
  CHECK(value_of(*ten_to_23) == times_power_of_ten(1, 23) - 8388608);
  // The largest double, and halfway to 2^1024.
  const Integer halfway = integer_power(2, 1024) - integer_power(2, 970);
  CHECK(parse_binary64(halfway.str()) == std::nullopt);
  CHECK(parse_binary64("-" + halfway.str()) == std::nullopt);
  CHECK(parse_binary64(Integer(halfway - 1).str()) == largest_double);
  CHECK(parse_binary64("1e309") == std::nullopt);
  // Half of the smallest double, and a little more.
  const std::string half_smallest = exact_decimal(1, -1075);
  CHECK(parse_binary64(half_smallest) == 0.0);
  CHECK(parse_binary64(Integer(integer_power(5, 1075) * 10 + 1).str() + "e-1076") == smallest_double);
  CHECK(parse_binary64("1e-400") == 0.0);
  CHECK(parse_binary64("1e-5000") == 0.0);
}

TEST_CASE("texts that are no numbers give nothing") {
  const char* const refused[] = {"",
                                 " ",
                                 "nan",
                                 "NaN",
                                 "inf",
                                 "-inf",
                                 "infinity",
                                 "0x1p3",
                                 "0x10",
                                 "+-1",
                                 "-+1",
                                 "--1",
                                 "++1",
                                 "1e",
                                 "1e+",
                                 "1e-",
                                 "1e5.0",
                                 "1e++5",
                                 "e5",
                                 "-e5",
                                 "-",
                                 "+",
                                 ".",
                                 "-.",
                                 ".e1",
                                 " 1",
                                 "1 ",
                                 "\t1",
                                 "1\n",
                                 "1,5",
                                 "1_000",
                                 "1'000",
                                 "1.2.3",
                                 "1f",
                                 "1d3",
                                 "1e5f",
                                 "1/0",
                                 "0/0",
                                 "-1/0",
                                 "1/00",
                                 "1/",
                                 "/2",
                                 "1/2/3",
                                 "1 /2",
                                 "1/ 2",
                                 "1//2",
                                 "a",
                                 "1a",
                                 "1e6000",
                                 "1e5001",
                                 "1e99999999999999999999",
                                 "-1e99999999999999999999",
                                 "\xc2\xa0"
                                 "1",
                                 "\xe2\x88\x92"
                                 "1"};
  for (const char* text : refused) {
    INFO("text '" << text << "'");
    CHECK(parse_binary64(text) == std::nullopt);
    CHECK(parse_decimal(text) == std::nullopt);
    CHECK(parse_rational(text) == std::nullopt);
  }
  const std::string with_zero("1\0", 2);
  CHECK(parse_binary64(with_zero) == std::nullopt);
  CHECK(parse_decimal(with_zero) == std::nullopt);
  CHECK(parse_rational(with_zero) == std::nullopt);
  CHECK(parse_decimal("1/2") == std::nullopt);
  CHECK(parse_binary64("1/2") == std::nullopt);
}

TEST_CASE("exponent and length have the stated limits, and those are reached") {
  const std::string last = std::to_string(max_decimal_exponent);
  const std::string beyond = std::to_string(max_decimal_exponent + 1);
  const Integer power = integer_power(10, max_decimal_exponent);
  CHECK(parse_decimal("1e" + last) == Rational(power));
  CHECK(parse_decimal("1e-" + last) == 1 / Rational(power));
  CHECK(parse_rational("-1e" + last) == Rational(-power));
  CHECK(parse_decimal("1e" + beyond) == std::nullopt);
  CHECK(parse_decimal("1e-" + beyond) == std::nullopt);
  CHECK(parse_rational("1e-" + beyond) == std::nullopt);

  const std::string longest(max_number_length, '9');
  CHECK(parse_decimal(longest) == Rational(Integer(integer_power(10, max_number_length) - 1)));
  CHECK(parse_rational(longest) == parse_decimal(longest));
  CHECK(parse_decimal(longest + "9") == std::nullopt);
  CHECK(parse_rational(longest + "9") == std::nullopt);
  CHECK(parse_decimal("0" + longest) == std::nullopt);
}

TEST_CASE("parse_rational reads quotients exactly and reduces them") {
  const std::uint64_t seed = seed_or(104);
  Random random(seed);
  long reducible = 0, negative = 0;
  for (int i = 0; i < 3000; ++i) {
    Integer p = random.integer(-(1L << 40), 1L << 40);
    Integer q = random.integer(1, 1L << 40);
    p *= random.integer(1, 1000);
    q *= random.integer(1, 1000);
    const std::string text = p.str() + "/" + q.str();
    const auto read = parse_rational(text);
    INFO("seed " << seed << ", text " << text);
    if (!read || *read * Rational(q) != Rational(p)) FAIL("wrong value");
    const Integer divisor = gcd(p, q);
    if (numerator(*read) * divisor != p || denominator(*read) * divisor != q) FAIL("not in lowest terms");
    reducible += divisor > 1;
    negative += p < 0;
  }
  CHECK(reducible > 1000);
  CHECK(negative > 1000);
  CHECK(parse_rational("-6/4") == Rational(-3, 2));
  CHECK(parse_rational("0/7") == Rational(0));
  CHECK(parse_rational("007/014") == Rational(1, 2));
  CHECK(parse_rational("-0.125") == Rational(-1, 8));
}
