// Same curves: degree, common factors, scale and projective reparametrisation do not matter, all else does.
#include "bezcert/curve/same_curve.hpp"

#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <array>

namespace bezcert::test {
namespace {

using Net = CurveNet<Integer>;

Net random_net(Random& random, int degree) {
  Net net;
  for (int i = 0; i <= degree; ++i) {
    const long w = random.integer(1, 5);
    net.x.push_back(w * random.integer(-9, 9));
    net.y.push_back(w * random.integer(-9, 9));
    net.w.push_back(w);
  }
  return net;
}

// Times (a (1 - t) + b t): coefficients i / (n + 1) b P_(i-1) + (1 - i / (n + 1)) a P_i.
Net times_linear(const Net& net, long a, long b) {
  const auto n = static_cast<long>(net.size());
  const auto one = [&](const std::vector<Integer>& values) {
    std::vector<Integer> result;
    for (long i = 0; i <= n; ++i) {
      Integer sum = 0;
      if (i > 0) sum += i * b * values[static_cast<std::size_t>(i - 1)];
      if (i < n) sum += (n - i) * a * values[static_cast<std::size_t>(i)];
      result.push_back(sum);
    }
    return result;
  };
  return {one(net.x), one(net.y), one(net.w)};
}

// P_i times factor^i scale.
Net projective(Net net, long above, long below) {
  const std::size_t n = net.size() - 1;
  for (auto* values : {&net.x, &net.y, &net.w}) {
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t k = 0; k < i; ++k) (*values)[i] *= above;
      for (std::size_t k = i; k < n; ++k) (*values)[i] *= below;
    }
  }
  return net;
}

}  // namespace

TEST_CASE("what does not change a curve") {
  const std::uint64_t seed = seed_or(20260101);
  Random random(seed);
  for (int n = 0; n < 300; ++n) {
    const Net net = random_net(random, static_cast<int>(random.integer(1, 5)));
    INFO("seed " << seed << " case " << n);
    Net other = net;
    for (int k = 0; k < 3; ++k) {
      const long a = random.integer(1, 4), b = random.integer(1, 4);
      other = random.chance(50) ? times_linear(other, a, b) : projective(other, a, b);
    }
    for (auto* values : {&other.x, &other.y, &other.w}) {
      for (Integer& v : *values) v *= 7;
    }
    CHECK(same_curve(net, other));
    CHECK(same_curve(other, net));
    CHECK(same_curve(reversed(net), reversed(other)));
    // One coordinate of one control point moved: another curve.
    Net moved = other;
    auto& values = random.chance(50) ? moved.x : moved.y;
    values[static_cast<std::size_t>(random.integer(0, static_cast<long>(values.size()) - 1))] += 1;
    CHECK(!same_curve(net, moved));
  }
}

TEST_CASE("a projective change by an irrational factor is one") {
  // P_1 vanishes in no coordinate but all of P_1 is 0 in the reduced form: (1, t^2) with t -> r t, r^2 = 2.
  const Net a{{0, 0, 1}, {1, 0, 0}, {1, 0, 1}}, b{{0, 0, 2}, {1, 0, 0}, {1, 0, 2}};
  CHECK(same_curve(a, b));
  const Net c{{0, 0, 0, 1}, {1, 0, 0, 0}, {1, 0, 0, 1}};
  CHECK(!same_curve(a, c));
  // The middle is there in one and not in the other.
  const Net d{{0, 0, 2}, {1, 0, 0}, {1, 1, 2}};
  CHECK(!same_curve(a, d));
  // r_1 = 2, r_2 = 3: no power law.
  const Net e{{0, 2, 4}, {1, 1, 1}, {1, 1, 1}}, f{{0, 4, 12}, {1, 2, 3}, {1, 2, 3}};
  CHECK(!same_curve(e, f));
}

TEST_CASE("other curves and other speeds") {
  const Net line{{0, 4}, {0, 0}, {1, 1}}, uneven{{0, 3, 4}, {0, 0, 0}, {1, 1, 1}};
  CHECK(!same_curve(line, uneven));
  CHECK(!same_curve(line, reversed(line)));
  const Net parabola{{0, 2, 4}, {0, 2, 0}, {1, 1, 1}}, conic{{0, 4, 4}, {0, 4, 0}, {1, 2, 1}};
  CHECK(!same_curve(parabola, conic));
  CHECK(!same_curve(parabola, line));
}

}  // namespace bezcert::test
