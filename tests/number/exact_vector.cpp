// exact_vector.hpp and scaled.hpp: numbers kept as doubles, rationals or scaled integers stay what they are.
#include "double_oracle.hpp"

#include "bezcert/number/exact_vector.hpp"
#include "bezcert/number/interval.hpp"
#include "bezcert/number/scaled.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>
#include <vector>

using namespace bezcert;
using namespace bezcert::test;

namespace {

std::vector<double> random_doubles(Random& random, long kind) {
  std::vector<double> numbers(static_cast<std::size_t>(random.integer(1, 12)));
  for (double& x : numbers) {
    x = kind == 0   ? random.any_double(-5, 5)
        : kind == 1 ? random_bits_double(random)
                    : static_cast<double>(random.integer(-8, 8)) * 4;
    if (random.chance(10)) x = 0;
  }
  return numbers;
}

Rational random_fraction(Random& random) {
  const long p = random.integer(-1000, 1000);
  return Rational(p) / random.integer(1, 360);
}

}  // namespace

TEST_CASE("scaled doubles are reproduced exactly by integers over the largest common power of two") {
  const std::uint64_t seed = seed_or(141);
  Random random(seed);
  long with_zero = 0, all_zero = 0, scaled_up = 0, scaled_down = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> numbers = random_doubles(random, i % 3);
    if (random.chance(2)) numbers.assign(numbers.size(), 0.0);
    const ScaledIntegers scaled = scaled_integers(std::span<const double>(numbers));
    INFO("seed " << seed << ", case " << i << ", scale " << scaled.scale);
    if (scaled.values.size() != numbers.size()) FAIL("count");
    if (scaled.scale <= 0) FAIL("scale not positive");
    bool odd = false, zero = false, nonzero = false;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (Rational(scaled.values[k]) * scaled.scale != value_of(numbers[k]))
        FAIL("number " << k << " changed");
      odd = odd || scaled.values[k] % 2 != 0;
      (scaled.values[k] == 0 ? zero : nonzero) = true;
    }
    if (nonzero && !odd) FAIL("a larger power of two is common");
    const Integer p = numerator(scaled.scale);
    const Integer q = denominator(scaled.scale);
    if ((p & (p - 1)) != 0 || (q & (q - 1)) != 0) FAIL("scale is no power of two");
    with_zero += zero && nonzero;
    all_zero += !nonzero;
    scaled_up += scaled.scale > 1;
    scaled_down += scaled.scale < 1;
  }
  CHECK(with_zero > 300);
  CHECK(all_zero > 20);
  CHECK(scaled_up > 300);
  CHECK(scaled_down > 1000);
  CHECK_THROWS_AS(scaled_integers(std::vector<double>{1, not_a_number}), std::invalid_argument);
  CHECK_THROWS_AS(scaled_integers(std::vector<double>{infinity}), std::invalid_argument);
  CHECK_THROWS_AS(scaled_integers(std::vector<double>{1, 2, -infinity}), std::invalid_argument);
  CHECK(scaled_integers(std::span<const double>()).values.empty());
}

TEST_CASE("scaled rationals are reproduced exactly by integers over their least common denominator") {
  const std::uint64_t seed = seed_or(142);
  Random random(seed);
  long whole = 0, fractions = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Rational> numbers(static_cast<std::size_t>(random.integer(1, 10)));
    const bool integers = random.chance(20);
    for (Rational& x : numbers) x = integers ? Rational(random.integer(-50, 50)) : random_fraction(random);
    Integer common = 1;
    for (const Rational& x : numbers) common = lcm(common, denominator(x));
    const ScaledIntegers scaled = scaled_integers(std::span<const Rational>(numbers));
    INFO("seed " << seed << ", case " << i << ", scale " << scaled.scale);
    if (scaled.values.size() != numbers.size()) FAIL("count");
    if (scaled.scale * Rational(common) != 1) FAIL("not the least common denominator " << common);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (Rational(scaled.values[k]) * scaled.scale != numbers[k]) FAIL("number " << k << " changed");
    }
    (common == 1 ? whole : fractions) += 1;
  }
  CHECK(whole > 300);
  CHECK(fractions > 1000);
}

TEST_CASE("an exact vector holds doubles until a number is none, and keeps every number") {
  const std::uint64_t seed = seed_or(143);
  Random random(seed);
  long switched = 0, stayed = 0, doubles_after_switch = 0;
  for (int i = 0; i < 1500; ++i) {
    ExactVector vector;
    std::vector<Rational> expected;
    bool binary = true;
    const long count = random.integer(0, 12);
    for (long k = 0; k < count; ++k) {
      const long kind = random.integer(0, 9);
      if (kind < 5) {
        const double x = random_bits_double(random);
        vector.push_back(x);
        expected.push_back(value_of(x));
        doubles_after_switch += !binary;
      } else if (kind < 9) {
        const Rational x = value_of(random.any_double(-3, 3));
        vector.push_back(x);
        expected.push_back(x);
      } else {
        const Rational x = dyadic(random.integer(-9, 9), -5) + Rational(1, 3);
        vector.push_back(x);
        expected.push_back(x);
        binary = false;
      }
      INFO("seed " << seed << ", case " << i << ", step " << k);
      if (vector.binary64() != binary) FAIL("form");
      if (vector.size() != expected.size()) FAIL("size");
      if ((binary ? vector.doubles().size() : vector.rationals().size()) != expected.size()) FAIL("span");
    }
    INFO("seed " << seed << ", case " << i);
    if (vector.empty() != expected.empty()) FAIL("empty");
    const ScaledIntegers scaled = vector.scaled();
    if (scaled.values.size() != expected.size()) FAIL("scaled size");
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const Rational& x = expected[k];
      const auto [below, above] = around(x);
      const Interval enclosure = interval_at(vector, k);
      if (vector[k] != x) FAIL("number " << k);
      if (binary ? value_of(vector.doubles()[k]) != x : vector.rationals()[k] != x) FAIL("span at " << k);
      if (Rational(scaled.values[k]) * scaled.scale != x) FAIL("scaled " << k);
      if (enclosure.inf() != below || enclosure.sup() != above) FAIL("interval " << k);
    }
    (binary ? stayed : switched) += 1;
  }
  CHECK(switched > 400);
  CHECK(stayed > 400);
  CHECK(doubles_after_switch > 500);
}

TEST_CASE("an exact vector made at once is the one made step by step") {
  const ExactVector doubles(std::vector<double>{0.5, -3, 0x1p-1074});
  CHECK(doubles.binary64());
  CHECK(doubles.size() == 3);
  CHECK(doubles[2] == dyadic(1, -1074));

  const ExactVector doubles_as_rationals(std::vector<Rational>{Rational(1, 2), Rational(-3)});
  CHECK(doubles_as_rationals.binary64());
  CHECK(doubles_as_rationals[0] == Rational(1, 2));
  CHECK(doubles_as_rationals[1] == -3);

  const ExactVector thirds(std::vector<Rational>{Rational(1, 2), Rational(1, 3)});
  CHECK_FALSE(thirds.binary64());
  CHECK(thirds.size() == 2);
  CHECK(thirds[0] == Rational(1, 2));
  CHECK(thirds[1] == Rational(1, 3));
  CHECK(thirds.scaled().scale == Rational(1, 6));

  // Doubles in form, but too long or too large for a double.
  CHECK_FALSE(ExactVector(std::vector<Rational>{dyadic(1, 53) + 1}).binary64());
  CHECK_FALSE(ExactVector(std::vector<Rational>{dyadic(1, 1024)}).binary64());
  CHECK_FALSE(ExactVector(std::vector<Rational>{dyadic(1, -1075)}).binary64());

  CHECK(ExactVector().empty());
  CHECK(ExactVector(std::vector<double>{}).empty());
  CHECK(ExactVector(std::vector<Rational>{}).empty());
  for (const double bad : {not_a_number, infinity, -infinity}) {
    CHECK_THROWS_AS(ExactVector(std::vector<double>{1.0, bad}), std::invalid_argument);
  }
}
