// Vertices: pinched, wound twice, cusps.
#include "mesh_sketch.hpp"

#include "bezcert/curve/branches.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;

// Triangles around the origin; rim node k in direction k times a right angle, at distance 2 + k / 4.
MeshSketch fan(int rim, bool closed, int degree) {
  MeshSketch builder;
  const Node centre = builder.node(0, 0);
  std::vector<Node> nodes;
  for (int k = 0; k < rim; ++k) {
    const Rational r = 2 + Rational(k, 4);
    const std::array<std::pair<Rational, Rational>, 4> at = {{{r, 0}, {0, r}, {-r, 0}, {0, -r}}};
    nodes.push_back(
        builder.node(at[static_cast<std::size_t>(k % 4)].first, at[static_cast<std::size_t>(k % 4)].second));
  }
  for (int k = 0; k + 1 < rim || (closed && k < rim); ++k) {
    builder.triangle(centre, nodes[static_cast<std::size_t>(k)],
                     nodes[static_cast<std::size_t>((k + 1) % rim)], degree);
  }
  return builder;
}

// The outside of a sliver that ends in the origin, between y = x^2 / 4 (control point (1, 0)) above and
// below; or the same with both edges exchanged, which covers the sliver twice.
MeshSketch aerofoil(bool crossed) {
  MeshSketch builder;
  const Node tip = builder.node(0, 0);
  const Node first = builder.node(2, crossed ? -1 : 1), last = builder.node(2, crossed ? 1 : -1);
  const Node top = builder.node(0, 3), left = builder.node(-3, 0), bottom = builder.node(0, -3);
  builder.curve(tip, first, {builder.node(1, 0)});
  builder.curve(tip, last, {builder.node(1, 0)});
  builder.triangle(tip, first, top, 2);
  builder.triangle(tip, top, left, 2);
  builder.triangle(tip, left, bottom, 2);
  builder.triangle(tip, bottom, last, 2);
  return builder;
}

CurveNet<Integer> net(const std::vector<std::array<int, 2>>& points) {
  CurveNet<Integer> result;
  for (const auto& [x, y] : points) {
    result.x.push_back(x);
    result.y.push_back(y);
    result.w.push_back(1);
  }
  return result;
}

}  // namespace

TEST_CASE("elements that touch in one node only make it pinched") {
  for (const bool by_nodes : {true, false}) {
    MeshSketch builder;
    const Node a = builder.node(0, 0);
    builder.triangle(a, builder.node(2, 0), builder.node(2, 2));
    builder.triangle(a, builder.node(-2, 0), builder.node(-2, -2));
    const Examined result = examine(builder.build(by_nodes));
    INFO(text_of(result));
    CHECK(result.verdict == MeshVerdict::non_manifold);
    CHECK(first_obstacle(result).elements == std::vector<std::uint32_t>{0, 1});
    CHECK(first_obstacle(result).points == std::vector<Point>{{0, 0}});
    CHECK(result.obstacles.count(MeshVerdict::non_manifold) == 1);
    CHECK(result.obstacles.count(MeshVerdict::overlapping_boundary) == 0);
  }
}

TEST_CASE("a closed fan winds once or twice around its node") {
  for (const int degree : {1, 2, 3}) {
    const Examined once = examine(fan(4, true, degree).build());
    INFO(text_of(once));
    CHECK(once.verdict == MeshVerdict::embedding);
    const Examined twice = examine(fan(8, true, degree).build());
    INFO(text_of(twice));
    CHECK(twice.verdict == MeshVerdict::folded_vertex);
    CHECK(first_obstacle(twice).elements.size() == 8);
    CHECK(first_obstacle(twice).nodes == std::vector<std::uint32_t>{0});
    CHECK(first_message(twice).find("2 times") != std::string::npos);
  }
  CHECK(examine(fan(12, true, 1).build()).verdict == MeshVerdict::folded_vertex);
}

TEST_CASE("an open fan has less than a turn, a turn, or more") {
  CHECK(examine(fan(4, false, 1).build()).verdict == MeshVerdict::embedding);  // three right angles
  // Five of them: the last lies on the first.
  const Examined over = examine(fan(6, false, 1).build());
  CHECK(over.verdict == MeshVerdict::folded_vertex);
  // Exactly a turn: the last edge runs along the first, whose end (2, 0) hangs on it.
  const Examined turn = examine(fan(5, false, 1).build());
  INFO(text_of(turn));
  CHECK(turn.verdict == MeshVerdict::non_conforming);
  CHECK(turn.obstacles.count(MeshVerdict::folded_vertex) == 0);
  CHECK(first_obstacle(turn).points == std::vector<Point>{{2, 0}});
}

TEST_CASE("a cusp may leave a sliver out, not cover it twice") {
  const Examined right = examine(aerofoil(false).build());
  INFO(text_of(right));
  CHECK(right.verdict == MeshVerdict::embedding);
  REQUIRE(right.area);
  // The hexagon has area 15; between each parabola and its chord there is 1/3.
  CHECK(right.area->lower == Rational(47, 3));
  CHECK(right.area->is_exact());
  const Examined wrong = examine(aerofoil(true).build());
  INFO(text_of(wrong));
  CHECK(wrong.verdict == MeshVerdict::folded_vertex);
  CHECK(first_obstacle(wrong).nodes == std::vector<std::uint32_t>{0});
}

TEST_CASE("branches are compared by their first different term") {
  const CurveNet<Integer> line = net({{0, 0}, {4, 0}});
  const CurveNet<Integer> above = net({{0, 0}, {2, 0}, {4, 1}});          // y = x^2 / 16
  const CurveNet<Integer> steep = net({{0, 0}, {1, 0}, {2, 1}});          // y = x^2 / 4
  const CurveNet<Integer> cubic = net({{0, 0}, {1, 0}, {2, 0}, {3, 1}});  // y = x^3 / 27
  const CurveNet<Integer> uneven = net({{0, 0}, {1, 0}, {4, 0}});         // along the line, at another speed
  const CurveNet<Integer> raised = net({{0, 0}, {4, 0}, {8, 1}, {12, 3}});  // y = x^2 / 48, raised in degree
  CHECK(compare_branches(line, above) == 1);
  CHECK(compare_branches(above, line) == -1);
  CHECK(compare_branches(above, steep) == 1);
  CHECK(compare_branches(line, cubic) == 1);
  CHECK(compare_branches(cubic, above) == 1);
  CHECK(compare_branches(line, uneven) == 0);
  CHECK(compare_branches(raised, net({{0, 0}, {6, 0}, {12, 3}})) == 0);
  // x = 8 t, y = 16 t^2 = x^2 / 4, and x = 12 t, y = 36 t^2 + t^3 = x^2 / 4 + x^3 / 1728: the third term.
  CHECK(compare_branches(net({{0, 0}, {4, 0}, {8, 16}}), net({{0, 0}, {4, 0}, {8, 12}, {12, 37}})) == 1);
  // Turned by a right angle, as rational curves with W = 1 + t.
  CurveNet<Integer> up = net({{0, 0}, {0, 1}}), left = net({{0, 0}, {0, 1}, {-1, 2}});
  CHECK(compare_branches(up, left) == 1);
  left.w = {1, 2, 4};
  for (std::size_t i = 0; i < 3; ++i) left.x[i] *= left.w[i], left.y[i] *= left.w[i];
  CHECK(compare_branches(up, left) == 1);
  for (Integer& x : left.x) x = -x;
  CHECK(compare_branches(up, left) == -1);
}

}  // namespace bezcert::test
