// Areas: exact for polynomial edges, enclosed for rational ones; orientation of very thin loops.
#include "mesh_sketch.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;

// pi to 30 digits, rounded down and up.
const Rational pi_low("3141592653589793238462643383279/1000000000000000000000000000000");
const Rational pi_high("3141592653589793238462643383280/1000000000000000000000000000000");

// Between two circles in four parts, glued by points: along v quarter circles, conics with the weights 1, 1,
// 2
// (((1 - t^2), 2 t, 1 + t^2), turned), along u straight.
Mesh ring(const Rational& inner, const Rational& outer) {
  MeshSketch builder;
  const std::array<std::pair<int, int>, 4> at = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [x, y] = at[k];
    const auto& [u, v] = at[(k + 1) % 4];
    std::vector<Node> nodes;
    for (const Rational& r : {inner, outer}) nodes.push_back(builder.node(r * x, r * y, 1));
    for (const Rational& r : {inner, outer}) nodes.push_back(builder.node(r * (x + u), r * (y + v), 1));
    for (const Rational& r : {inner, outer}) nodes.push_back(builder.node(r * u, r * v, 2));
    builder.add(Shape::square(1, 2), std::move(nodes));
  }
  return builder.build(false);
}

}  // namespace

TEST_CASE("the area between two circles is enclosed") {
  const Examined result = examine(ring(1, 2));
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::embedding);
  CHECK(result.holes == std::size_t{1});
  REQUIRE(result.area);
  CHECK(!result.area->is_exact());
  CHECK(result.area->lower <= 3 * pi_low);
  CHECK(result.area->upper >= 3 * pi_high);
  CHECK(result.area->upper - result.area->lower < Rational(1, 50));
}

TEST_CASE("polynomial areas are exact") {
  // The triangle (0,0) (6,0) (0,6) of area 18, its lower side bent down.
  MeshSketch builder;
  const Node a = builder.node(0, 0), b = builder.node(6, 0), c = builder.node(0, 6);
  builder.curve(a, b, {builder.node(3, -1)});
  builder.triangle(a, b, c, 2);
  // Between a parabola and its chord lie 2/3 of the control triangle of area 3.
  CHECK(examine(builder.build()).area->lower == 20);

  MeshSketch cubic;
  const Node d = cubic.node(0, 0), e = cubic.node(6, 0), f = cubic.node(0, 6);
  cubic.curve(d, e, {cubic.node(2, -1), cubic.node(4, -1)});
  cubic.triangle(d, e, f, 3);
  // x = 6 t, y = -3 t (1 - t): the integral of 3 t (1 - t) 6 dt is 3.
  CHECK(examine(cubic.build()).area->lower == 21);
}

TEST_CASE("a hole so thin that only the winding number tells its orientation") {
  // Between the conic with the weights 1, 2, 1 and the one with 1, 2 + 1e-30, 1 on the same control points,
  // cut in its middle: a hole with two cusps. By de Casteljau its halves have the weights 1, h, h with h = (1
  // + w) / 2.
  MeshSketch builder;
  const Node a = builder.node(0, 0), b = builder.node(4, 0), low = builder.node(2, -4),
             high = builder.node(2, 4);
  const Node left = builder.node(-4, 0), right = builder.node(8, 0);
  builder.curve(a, b, {builder.node(2, 1, 2)});
  builder.triangle(b, a, low, 2);
  const Rational w = 2 + Rational(Integer(1), Integer("1000000000000000000000000000000"));
  const Rational h = (1 + w) / 2, y = w / (1 + w);
  const Node m = builder.node(2, y, h);
  builder.curve(a, m, {builder.node(2 * w / (1 + w), y, h)});
  builder.curve(m, b, {builder.node((2 * w + 4) / (1 + w), y, h)});
  builder.triangle(a, m, high, 2);
  builder.triangle(m, b, high, 2);
  builder.triangle(a, high, left, 2);
  builder.triangle(a, left, low, 2);
  builder.triangle(b, right, high, 2);
  builder.triangle(b, low, right, 2);
  const Examined result = examine(builder.build());
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::embedding);
  CHECK(result.holes == std::size_t{1});
  REQUIRE(result.area);
  // All but the hole: the rhombus with the diagonals 12 and 8.
  CHECK(result.area->upper >= 48 - Rational(1, 1000000));
  CHECK(result.area->lower <= 48);
  CHECK(result.area->upper - result.area->lower < Rational(1, 100));
}

}  // namespace bezcert::test
