// filtered_sign.hpp: whichever stage answers, in whatever rounding mode, the sign is that of rational
// arithmetic; and the exact stage runs in the mode of the caller.
#include "double_oracle.hpp"

#include "bezcert/number/filtered_sign.hpp"
#include "bezcert/number/scaled.hpp"
#include "bezcert/number/static_bound.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

template <class T>
using Points = std::array<T, 6>;  // x and y of three points

// Twice the signed area of the triangle, for any number type.
constexpr auto area = [](const auto& p) {
  return (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
};

template <class T, class Make>
Points<T> points_of(const Points<double>& p, Make make) {
  Points<T> result;
  for (std::size_t i = 0; i < p.size(); ++i) result[i] = make(p[i]);
  return result;
}

// The area's error for coordinates up to 1 in size.
double unit_error() {
  Points<StaticBound> ones;
  ones.fill({1, 0});
  return error_of(area(ones));
}

Points<double> random_points(Random& random) {
  Points<double> p{};
  const int kind = static_cast<int>(random.integer(0, 4));
  const double origin = kind == 3 ? std::ldexp(1.0, static_cast<int>(random.integer(0, 40))) : 0;
  for (double& c : p) c = origin + random.any_double(-20, 0);
  if (kind == 1) {  // on a line, as far as doubles go
    const double t = random.any_double(0, 1);
    p[4] = p[0] + t * (p[2] - p[0]);
    p[5] = p[1] + t * (p[3] - p[1]);
  }
  if (kind == 2) {  // on a line exactly, or next to it
    for (const std::size_t i : {0, 1, 2, 3}) p[i] = static_cast<double>(random.integer(-1000, 1000));
    const auto t = static_cast<double>(random.integer(-8, 8));
    p[4] = p[0] + t * (p[2] - p[0]);
    p[5] = p[1] + t * (p[3] - p[1]);
    if (random.chance(50)) p[5] += std::ldexp(1.0, -static_cast<int>(random.integer(30, 42)));
  }
  if (kind == 4) p[3] = p[5] = p[1];  // on a line along an axis
  return p;
}

int expected_sign(const Points<double>& p) {
  const auto q = points_of<Rational>(p, [](double x) { return exact(x); });
  return area(q).sign();
}

bool rounds_so(int mode) {
  volatile double one = 1, three = 3;
  const double up = 0x1.5555555555556p-2, down = 0x1.5555555555555p-2;
  return one / three == (mode == FE_UPWARD ? up : down);
}

}  // namespace

TEST_CASE("a filtered sign is the exact sign, whichever stage answers, in every rounding mode") {
  const std::uint64_t seed = seed_or(141);
  Random random(seed);
  const double error = unit_error();
  std::map<int, long> signs;
  long by_doubles = 0, by_intervals = 0, by_integers = 0;
  constexpr int cases = 40000;
  for (int i = 0; i < cases; ++i) {
    const Points<double> p = random_points(random);
    const int expected = expected_sign(p);
    const int mode = rounding_modes[static_cast<std::size_t>(i) % std::size(rounding_modes)];
    int last = 0;
    bool right_mode = true;
    const auto doubles = [&] {
      last = 1;
      double unit = 0;
      for (const double c : p) unit = std::max(unit, std::abs(c));
      using Operands = std::tuple<Points<double>>;
      return std::optional(DoubleOperands<Operands>{Operands(p), error * (unit * unit)});
    };
    const auto intervals = [&](const RoundUp&) {
      last = 2;
      return std::tuple(points_of<Interval>(p, [](double x) { return Interval(x); }));
    };
    const auto integers = [&] {
      last = 3;
      right_mode = right_mode && rounds_so(mode);
      const std::vector<Integer> values = scaled_integers(p).values;
      Points<Integer> result;
      std::copy(values.begin(), values.end(), result.begin());
      return std::tuple(result);
    };
    int with_all = 0, without_doubles = 0, exactly = 0, stage = 0;
    bool is_left = false, is_left_exactly = false;
    {
      const RoundingMode scope(mode);
      with_all = filtered_sign(Filter::on, area, doubles, intervals, integers);
      stage = last;
      without_doubles = filtered_sign(Filter::on, area, intervals, integers);
      exactly = filtered_sign(Filter::off, area, doubles, intervals, integers);
      right_mode = right_mode && last == 3;
      const auto left = [](const auto& q) { return sign_of(area(q)) > 0; };
      is_left = filtered(Filter::on, left, intervals, integers);
      is_left_exactly = filtered(Filter::off, left, intervals, integers);
      right_mode = right_mode && rounds_so(mode);
    }
    INFO("seed " << seed << " case " << i << " rounding " << mode << " stage " << stage);
    REQUIRE(with_all == expected);
    REQUIRE(without_doubles == expected);
    REQUIRE(exactly == expected);
    REQUIRE(is_left == (expected > 0));
    REQUIRE(is_left_exactly == (expected > 0));
    REQUIRE(right_mode);
    ++signs[expected];
    ++(stage == 1 ? by_doubles : stage == 2 ? by_intervals : by_integers);
  }
  INFO("seed " << seed << ": doubles " << by_doubles << ", intervals " << by_intervals << ", integers "
               << by_integers);
  CHECK(by_doubles > cases / 4);
  CHECK(by_intervals > cases / 10);
  CHECK(by_integers > cases / 10);
  CHECK(signs[0] > cases / 10);
  CHECK(signs[1] > cases / 4);
  CHECK(signs[-1] > cases / 4);
}

TEST_CASE("a double's sign is certain beyond its error only") {
  CHECK(certain_sign(1.0, 0.5) == 1);
  CHECK(certain_sign(-1.0, 0.5) == -1);
  CHECK(certain_sign(0.5, 0.5) == std::nullopt);
  CHECK(certain_sign(-0.5, 0.5) == std::nullopt);
  CHECK(certain_sign(0.0, 0.5) == std::nullopt);
  CHECK(certain_sign(0.0, 0.0) == 0);
  CHECK(certain_sign(smallest_double, 0.0) == 1);
  CHECK(certain_sign(not_a_number, 0.5) == std::nullopt);
  CHECK(certain_sign(not_a_number, 0.0) == std::nullopt);
  CHECK(certain_sign(1.0, not_a_number) == std::nullopt);
  CHECK(certain_sign(infinity, infinity) == std::nullopt);
}

TEST_CASE("the bound that an expression finds over StaticBound holds, and a thousandth of it does not") {
  // The determinant of three rows of three, and one over sums: cancellation of rounded terms.
  const auto determinant = [](const auto& m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
  };
  const auto of_differences = [&](const auto& m) {
    auto d = m;
    for (std::size_t i = 3; i < 9; ++i) d[i] = m[i] - m[i % 3];
    return determinant(d);
  };
  const std::uint64_t seed = seed_or(142);
  Random random(seed);
  constexpr int cases = 20000;
  long beyond_a_thousandth[2] = {};
  const auto attack = [&](const auto& expression, long& beyond) {
    std::array<StaticBound, 9> ones;
    ones.fill({1, 0});
    const double error = error_of(expression(ones));
    for (int i = 0; i < cases; ++i) {
      std::array<double, 9> m{};
      for (double& c : m) c = random.any_double(0, 0);
      double unit = 0;
      for (const double c : m) unit = std::max(unit, std::abs(c));
      const int mode = rounding_modes[static_cast<std::size_t>(i) % std::size(rounding_modes)];
      double value = 0;
      {
        const RoundingMode scope(mode);
        value = expression(m);
      }
      std::array<Rational, 9> q;
      std::transform(m.begin(), m.end(), q.begin(), [](double x) { return exact(x); });
      const Rational wrong = abs(exact(value) - expression(q));
      const Rational bound = exact(error) * exact(unit) * exact(unit) * exact(unit);
      INFO("seed " << seed << " case " << i << " rounding " << mode);
      REQUIRE(wrong <= bound);
      beyond += wrong * 1000 > bound;
    }
  };
  attack(determinant, beyond_a_thousandth[0]);
  attack(of_differences, beyond_a_thousandth[1]);
  CHECK(beyond_a_thousandth[0] > cases / 2);
  CHECK(beyond_a_thousandth[1] > cases / 2);
}
