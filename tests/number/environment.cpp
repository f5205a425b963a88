// Reading and writing of numbers does not depend on the locale or on the floating-point rounding mode.
#include "double_oracle.hpp"

#include "bezcert/number/dyadic.hpp"
#include "bezcert/number/interval.hpp"
#include "bezcert/number/parse.hpp"
#include "bezcert/number/scaled.hpp"

#include <catch2/catch.hpp>

#include <clocale>
#include <cstdio>
#include <locale>
#include <string>
#include <vector>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// Texts with the number each means, worked out by the oracle.
struct Reading {
  std::string text;
  Rational value;
  double nearest = 0;
};

std::vector<Reading> readings(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Reading> result;
  while (static_cast<int>(result.size()) < count) {
    // Half of them short, as people write them: other ways through a reader than long ones.
    const bool is_short = random.chance(50);
    const long size = is_short ? 100000 : 1L << 60;
    const long range = is_short ? 20 : 320;
    const long digits = random.integer(-size, size);
    const long exponent = random.integer(-range, range);
    const Rational power(integer_power(10, exponent < 0 ? -exponent : exponent));
    Reading reading;
    reading.text = std::to_string(digits) + (random.chance(50) ? "e" : ".0e") + std::to_string(exponent);
    reading.value = exponent < 0 ? Rational(digits) / power : Rational(digits) * power;
    const auto nearest = nearest_double(reading.value);
    if (!nearest) continue;
    reading.nearest = *nearest;
    result.push_back(reading);
  }
  result.push_back({"9007199254740993", dyadic(1, 53) + 1, 0x1p53});
  result.push_back({"0.1", Rational(1, 10), 0x1.999999999999ap-4});
  result.push_back({"-0.1", Rational(-1, 10), -0x1.999999999999ap-4});
  result.push_back({"1.5", Rational(3, 2), 1.5});
  return result;
}

/// Everything number/ says of some values, as text made without the library.
std::string everything_said(const std::vector<Reading>& all) {
  std::string said;
  for (const Reading& reading : all) {
    const Interval enclosure = to_interval(reading.value);
    double as_double = 0;
    const bool binary = is_binary64(reading.value, as_double);
    const Dyadic down = round_down(reading.value);
    said += to_decimal(reading.value) + " " + to_decimal(reading.value, 3) + " " + to_string(reading.value) +
            " " + std::to_string(bits_of(enclosure.inf())) + " " + std::to_string(bits_of(enclosure.sup())) +
            " " + (binary ? std::to_string(bits_of(as_double)) : "-") + " " + floor(reading.value).str() +
            " " + std::to_string(down.mantissa) + " " + std::to_string(down.exponent) + " " +
            to_string(exact(reading.nearest)) + "\n";
  }
  return said;
}

void check_readings(const std::vector<Reading>& all, std::uint64_t seed) {
  long wrong = 0;
  for (const Reading& reading : all) {
    const auto read = parse_binary64(reading.text);
    const auto exact = parse_decimal(reading.text);
    if (read && *read == reading.nearest && exact == reading.value && parse_rational(reading.text) == exact)
      continue;
    if (++wrong > 3) continue;  // the first few tell
    INFO("seed " << seed << ", rounding mode " << std::fegetround() << ", text " << reading.text << " means "
                 << hex(reading.nearest));
    FAIL_CHECK("read " << (read ? hex(*read) : "nothing"));
  }
  CHECK(wrong == 0);
}

struct CommaDecimal : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Restores the C++ and the C locale.
class KeepLocale {
 public:
  KeepLocale() : c_(std::setlocale(LC_ALL, nullptr)) {}
  ~KeepLocale() {
    std::locale::global(cpp_);
    std::setlocale(LC_ALL, c_.c_str());
  }
  KeepLocale(const KeepLocale&) = delete;
  KeepLocale& operator=(const KeepLocale&) = delete;

 private:
  std::locale cpp_;
  std::string c_;
};

}  // namespace

TEST_CASE("reading and writing are the same in every rounding mode") {
  const std::uint64_t seed = seed_or(111);
  const auto all = readings(seed, 1000);
  const std::string expected = everything_said(all);
  CHECK(expected.size() > 100 * all.size());
  for (const int mode : rounding_modes) {
    const RoundingMode scope(mode);
    REQUIRE(std::fegetround() == mode);
    check_readings(all, seed);
    const bool same = everything_said(all) == expected;
    INFO("rounding mode " << mode);
    CHECK(same);
    CHECK(std::fegetround() == mode);
  }
}

TEST_CASE("the rounding mode really changes floating-point division in this program") {
  volatile double one = 1;
  volatile double three = 3;
  volatile double up = 0, down = 0;
  {
    const RoundingMode scope(FE_UPWARD);
    up = one / three;
  }
  {
    const RoundingMode scope(FE_DOWNWARD);
    down = one / three;
  }
  CHECK(up > down);
}

TEST_CASE("reading and writing are the same with a C++ locale of decimal commas") {
  const std::uint64_t seed = seed_or(112);
  const auto all = readings(seed, 1000);
  const std::string expected = everything_said(all);
  const KeepLocale keep;
  std::locale::global(std::locale(std::locale::classic(), new CommaDecimal));
  std::ostringstream probe;
  probe << 12345.5;
  REQUIRE(probe.str() == "12.345,5");  // the locale bites
  check_readings(all, seed);
  const bool same = everything_said(all) == expected;
  CHECK(same);
  CHECK(parse_decimal("1,5") == std::nullopt);
  CHECK(parse_binary64("1,5") == std::nullopt);
}

TEST_CASE("reading and writing are the same with a C locale of decimal commas") {
  const std::uint64_t seed = seed_or(113);
  const auto all = readings(seed, 1000);
  const std::string expected = everything_said(all);
  const KeepLocale keep;
  const char* found = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8", "fr_FR",
                           "ru_RU.UTF-8", "es_ES.UTF-8", "it_IT.UTF-8", "pt_BR.UTF-8", "nl_NL.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) {
      found = name;
      break;
    }
  }
  if (found == nullptr) {
    WARN("no locale with decimal commas is installed; the C++ locale test above stands alone");
    return;
  }
  char probe[16];
  std::snprintf(probe, sizeof probe, "%.1f", 1.5);
  REQUIRE(std::string(probe) == "1,5");  // the locale bites
  check_readings(all, seed);
  const bool same = everything_said(all) == expected;
  CHECK(same);
  CHECK(parse_decimal("1,5") == std::nullopt);
  CHECK(parse_binary64("1,5") == std::nullopt);
}
