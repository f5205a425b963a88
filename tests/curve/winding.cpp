// Winding numbers of closed chains.
#include "bezcert/curve/winding.hpp"

#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <array>

namespace bezcert::test {
namespace {

CurveNet<Integer> net(std::vector<Integer> x, std::vector<Integer> y, std::vector<Integer> w) {
  return {std::move(x), std::move(y), std::move(w)};
}

CurveNet<Interval> intervals(const CurveNet<Integer>& net) {
  CurveNet<Interval> result;
  for (const Integer& c : net.x) result.x.push_back(to_interval(c));
  for (const Integer& c : net.y) result.y.push_back(to_interval(c));
  for (const Integer& c : net.w) result.w.push_back(to_interval(c));
  return result;
}

// The unit circle in quarters ((1 - t^2), 2 t, 1 + t^2), turned; each as homogeneous control points.
std::vector<CurveNet<Integer>> circle() {
  return {net({1, 1, 0}, {0, 1, 2}, {1, 1, 2}), net({0, -1, -2}, {1, 1, 0}, {1, 1, 2}),
          net({-1, -1, 0}, {0, -1, -2}, {1, 1, 2}), net({0, 1, 2}, {-1, -1, 0}, {1, 1, 2})};
}

int winding(const std::vector<CurveNet<Integer>>& chain, const Point& point) {
  int sum = 0;
  for (const CurveNet<Integer>& one : chain) {
    DyadicCurve curve(std::nullopt, one), with_intervals(intervals(one), one);
    const std::optional<int> share = winding_share(curve, point);
    REQUIRE(share);
    CHECK(winding_share(with_intervals, point) == share);
    sum += *share;
  }
  return sum;
}

}  // namespace

TEST_CASE("around a circle") {
  const std::uint64_t seed = seed_or(20260102);
  Random random(seed);
  std::array<int, 2> seen{};
  for (int n = 0; n < 2000; ++n) {
    // Rational points, many of them on the axes and close to the circle.
    Point point{random.rational(-2, 2, 8), random.rational(-2, 2, 8)};
    const Rational distance = point.x * point.x + point.y * point.y;
    if (distance == 1) continue;
    const int expected = distance < 1 ? 1 : 0;
    INFO("seed " << seed << " point " << point.x << " " << point.y);
    CHECK(winding(circle(), point) == expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  CHECK(seen[0] > 200);
  CHECK(seen[1] > 200);
  const Rational near = Rational(1) - Rational(Integer(1), Integer("1000000000000000000000000000000"));
  CHECK(winding(circle(), {near, 0}) == 1);
  CHECK(winding(circle(), {1 / near, 0}) == 0);
  CHECK(winding(circle(), {Rational(3, 5) * near, Rational(4, 5) * near}) == 1);
}

TEST_CASE("twice around, backwards, and on the curve") {
  std::vector<CurveNet<Integer>> twice = circle();
  for (const auto& one : circle()) twice.push_back(one);
  CHECK(winding(twice, {0, 0}) == 2);
  std::vector<CurveNet<Integer>> back;
  for (const auto& one : circle()) {
    back.push_back(
        net({one.x.rbegin(), one.x.rend()}, {one.y.rbegin(), one.y.rend()}, {one.w.rbegin(), one.w.rend()}));
  }
  CHECK(winding(back, {Rational(1, 3), Rational(-1, 7)}) == -1);
  DyadicCurve quarter(std::nullopt, circle()[0]);
  CHECK(!winding_share(quarter, {Rational(3, 5), Rational(4, 5)}, 40));
}

}  // namespace bezcert::test
