// Derivatives against the quotient rule in powers of the parameter, and regularity where it is known by
// construction: the derivative is a given factor times a curve that does not vanish.
#include "bezcert/curve/hodograph.hpp"

#include "power_form.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

// The integral from 0, in powers.
RationalPolynomial integral(const RationalPolynomial& f) {
  std::vector<Rational> c = {Rational(0)};
  for (std::size_t k = 0; k < f.c.size(); ++k) c.push_back(f.c[k] / Rational(static_cast<long>(k + 1)));
  return {std::move(c)};
}

// Control points of (x w0 / w0, y w0 / w0): for t = u / (u + v) the coefficient of u^i v^(n - i) over C(n,
// i).
CurveNet<Integer> net_of(const RationalPolynomial& x, const RationalPolynomial& y,
                         const RationalPolynomial& w0) {
  const RationalPolynomial parts[] = {x * w0, y * w0, w0};
  std::size_t count = 2;
  for (const RationalPolynomial& part : parts) count = std::max(count, part.c.size());
  const auto choose = [](std::size_t n, std::size_t k) {
    Rational result = 1;
    for (std::size_t i = 0; i < k; ++i)
      result *= Rational(static_cast<long>(n - i), static_cast<long>(i + 1));
    return result;
  };
  std::vector<Rational> values;
  Integer common = 1;
  for (const RationalPolynomial& part : parts) {
    for (std::size_t i = 0; i < count; ++i) {
      Rational sum = 0;
      for (std::size_t k = 0; k <= i && k < part.c.size(); ++k) {
        sum += part.c[k] * choose(count - 1 - k, i - k);
      }
      values.push_back(sum / choose(count - 1, i));
      common = lcm(common, Integer(denominator(values.back())));
    }
  }
  CurveNet<Integer> net;
  for (std::size_t i = 0; i < count; ++i) {
    net.x.push_back(numerator(Rational(values[i] * common)));
    net.y.push_back(numerator(Rational(values[count + i] * common)));
    net.w.push_back(numerator(Rational(values[2 * count + i] * common)));
  }
  return net;
}

const RationalPolynomial one({Rational(1)});

// A curve whose derivative is `factor` times (1 + t^2, t).
CurveNet<Integer> with_slope(const RationalPolynomial& factor, const RationalPolynomial& w0 = one) {
  return net_of(integral(factor * RationalPolynomial({Rational(1), Rational(0), Rational(1)})),
                integral(factor * RationalPolynomial({Rational(0), Rational(1)})), w0);
}

}  // namespace

TEST_CASE("derivatives by the quotient rule: 400 curves") {
  const std::uint64_t seed = seed_or(602);
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    INFO("seed " << seed << " case " << i);
    const CurveNet<Integer> net = random_curve(random, 1 + i % 8);
    const auto [x, y, w] = power_form(net);
    const Rational t = random.rational(0, 1, random.integer(1, 30)), square = w(t) * w(t);
    const Vector2<Rational> slope_there = derivative_at(net, t);
    REQUIRE(slope_there.x == (slope(x)(t) * w(t) - x(t) * slope(w)(t)) / square);
    REQUIRE(slope_there.y == (slope(y)(t) * w(t) - y(t) * slope(w)(t)) / square);
  }
}

TEST_CASE("segments are regular, points are not") {
  CHECK(is_regular({{0, 1}, {0, 1}, {1, 1}}));
  CHECK(is_regular({{0, 1000}, {0, 1000}, {1, 1000}}));
  CHECK(is_regular({{0, 1000}, {0, 1}, {1000, 1}}));
  CHECK_FALSE(is_regular({{2, 2}, {3, 3}, {1, 1}}));
  CHECK_FALSE(is_regular({{2, 2000, 4}, {3, 3000, 6}, {1, 1000, 2}}));
  // There and back along a line: it turns at t = 1/2.
  CHECK_FALSE(is_regular({{0, 1, 0}, {0, 1, 0}, {1, 1, 1}}));
}

TEST_CASE("cusps at rational and irrational parameters, inside, at the ends and beyond") {
  const RationalPolynomial uneven({Rational(1), Rational(999)});  // weights from 1 to 1000
  for (const RationalPolynomial& w0 : {one, uneven, uneven * uneven}) {
    const auto regular = [&](const RationalPolynomial& factor) { return is_regular(with_slope(factor, w0)); };
    CHECK(regular(one));
    CHECK_FALSE(regular({{Rational(-1), Rational(3)}}));               // 1/3
    CHECK_FALSE(regular({{Rational(0), Rational(1)}}));                // 0
    CHECK_FALSE(regular({{Rational(1), Rational(-1)}}));               // 1
    CHECK(regular({{Rational(-2), Rational(1)}}));                     // 2
    CHECK_FALSE(regular({{Rational(-1), Rational(0), Rational(2)}}));  // the root of 1/2
    CHECK(regular({{Rational(-2), Rational(0), Rational(1)}}));        // the root of 2
    CHECK(regular({{Rational(1), Rational(0), Rational(1)}}));         // no real one
    // Twice: the derivative does not change its direction there, and is 0 all the same.
    const RationalPolynomial root({Rational(-1), Rational(0), Rational(2)});
    CHECK_FALSE(regular(root * root));
  }
}

TEST_CASE("where one coordinate alone stands still a curve is regular") {
  CHECK(is_regular(net_of({{Rational(0), Rational(-1), Rational(1)}}, {{Rational(0), Rational(1)}}, one)));
}

}  // namespace bezcert::test
