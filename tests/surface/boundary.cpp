// The boundary: holes, overlapping parts, slits, hanging nodes; and several components.
#include "mesh_sketch.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;

// The ring between two squares with corners (+-r, +-r), four quadrilaterals.
void add_ring(MeshSketch& builder, const Rational& x, const Rational& y, const Rational& inner,
              const Rational& outer, int degree = 1) {
  std::array<Node, 4> in{}, out{};
  const std::array<std::pair<int, int>, 4> sides = {{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    in[k] = builder.node(x + inner * sides[k].first, y + inner * sides[k].second);
    out[k] = builder.node(x + outer * sides[k].first, y + outer * sides[k].second);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    builder.quad(in[k], out[k], out[(k + 1) % 4], in[(k + 1) % 4], degree, degree);
  }
}

void add_square(MeshSketch& builder, const Rational& x, const Rational& y, const Rational& half) {
  const Node a = builder.node(x - half, y - half), b = builder.node(x + half, y - half);
  const Node c = builder.node(x + half, y + half), d = builder.node(x - half, y + half);
  builder.triangle(a, b, c);
  builder.triangle(a, c, d);
}

// A strip of `turns` quarter turns between the radii 2 + growth k and 4 + growth k.
MeshSketch spiral(int quarters, const Rational& growth) {
  MeshSketch builder;
  std::vector<Node> in, out;
  for (int k = 0; k <= quarters; ++k) {
    for (const int wide : {0, 1}) {
      const Rational r = 2 + growth * k + 2 * wide;
      const std::array<std::pair<Rational, Rational>, 4> at = {{{r, 0}, {0, r}, {-r, 0}, {0, -r}}};
      const auto& [x, y] = at[static_cast<std::size_t>(k % 4)];
      (wide == 0 ? in : out).push_back(builder.node(x, y));
    }
  }
  for (std::size_t k = 0; k + 1 < in.size(); ++k) builder.quad(in[k], out[k], out[k + 1], in[k + 1]);
  return builder;
}

// Above (0, 0) (6, 0) one triangle, below it two that meet in m, and more around both ends so that they are
// inside.
struct Hanging {
  MeshSketch builder;
  Node a, b, m;
  int degree;

  Hanging(const Rational& x, const Rational& y, int p) : degree(p) {
    a = builder.node(0, 0);
    b = builder.node(6, 0);
    m = builder.node(x, y);
  }
  Mesh build(bool by_nodes = true) {
    const Node top = builder.node(3, 3), low = builder.node(3, -3), left = builder.node(-2, 0),
               right = builder.node(8, 0);
    builder.triangle(a, b, top, degree);
    builder.triangle(m, a, low, degree);
    builder.triangle(b, m, low, degree);
    builder.triangle(a, top, left, degree);
    builder.triangle(a, left, low, degree);
    builder.triangle(b, right, top, degree);
    builder.triangle(b, low, right, degree);
    return builder.build(by_nodes);
  }
};

}  // namespace

TEST_CASE("rings and plates with holes") {
  for (const int degree : {1, 2, 3}) {
    MeshSketch ring;
    add_ring(ring, 0, 0, 1, 3, degree);
    const Examined result = examine(ring.build());
    INFO(text_of(result));
    CHECK(result.verdict == MeshVerdict::embedding);
    CHECK(result.loops == std::size_t{2});
    CHECK(result.holes == std::size_t{1});
    CHECK(result.area->lower == 36 - 4);
  }
  // 7 x 3 unit cells without three of the middle row.
  MeshSketch plate;
  std::map<std::pair<int, int>, Node> at;
  for (int j = 0; j <= 3; ++j) {
    for (int i = 0; i <= 7; ++i) at[{i, j}] = plate.node(i, j);
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 7; ++i) {
      if (j == 1 && i % 2 == 1) continue;
      plate.quad(at[{i, j}], at[{i + 1, j}], at[{i + 1, j + 1}], at[{i, j + 1}], 2, 2);
    }
  }
  for (const bool by_nodes : {true, false}) {
    const Examined result = examine(plate.build(by_nodes));
    INFO(text_of(result));
    CHECK(result.verdict == MeshVerdict::embedding);
    CHECK(result.components == 1);
    CHECK(result.holes == std::size_t{3});
    CHECK(result.loops == std::size_t{4});
    CHECK(result.area->lower == 18);
  }
}

TEST_CASE("a spiral strip stays clear of itself, or not") {
  CHECK(examine(spiral(5, Rational(3, 4)).build()).verdict == MeshVerdict::embedding);
  const Examined over = examine(spiral(5, Rational(1, 4)).build());
  INFO(text_of(over));
  CHECK(over.verdict == MeshVerdict::overlapping_boundary);
  CHECK(over.components == 1);
  // The outside of the first turn is the inside of the second: they touch along edges.
  CHECK(examine(spiral(5, Rational(1, 2)).build()).verdict == MeshVerdict::overlapping_boundary);
}

TEST_CASE("components side by side, one in the hole of another, one on another") {
  struct Case {
    Rational x, half;
    MeshVerdict verdict;
  };
  // A square against the ring between half widths 2 and 4.
  const std::vector<Case> cases = {
      {0, 1, MeshVerdict::embedding},
      {10, 1, MeshVerdict::embedding},
      {3, Rational(1, 2), MeshVerdict::overlapping_boundary},  // inside the ring's material
      {0, 3, MeshVerdict::overlapping_boundary},               // covers the hole and more
      {0, 5, MeshVerdict::overlapping_boundary},               // covers the ring
      {5, 2, MeshVerdict::overlapping_boundary},               // crosses it
      {0, 2, MeshVerdict::overlapping_boundary}};              // touches along the hole
  for (const Case& one : cases) {
    MeshSketch builder;
    add_ring(builder, 0, 0, 2, 4);
    add_square(builder, one.x, 0, one.half);
    const Examined result = examine(builder.build());
    INFO("square at " << one.x << " of " << one.half << ": " << text_of(result));
    CHECK(result.verdict == one.verdict);
    CHECK(result.components == 2);
    CHECK(result.loops == std::size_t{3});
    if (result.verdict == MeshVerdict::embedding) CHECK(result.area->lower == 48 + 4 * one.half * one.half);
  }
  // An annulus around the hole of a wider one: neither's first vertices lie in the other but the outer loop
  // does.
  MeshSketch nested;
  add_ring(nested, 0, 0, 3, 10);
  add_ring(nested, 0, 0, 1, 5);
  CHECK(examine(nested.build()).verdict == MeshVerdict::overlapping_boundary);
}

TEST_CASE("a slit is an overlapping boundary with its likely causes") {
  // A square of 2 x 2 cells; the node in the middle and its edge to the right side's middle are doubled.
  MeshSketch builder;
  const Node n00 = builder.node(0, 0), n10 = builder.node(1, 0), n20 = builder.node(2, 0);
  const Node n01 = builder.node(0, 1), n11 = builder.node(1, 1), n21 = builder.node(2, 1),
             other = builder.node(2, 1);
  const Node n02 = builder.node(0, 2), n12 = builder.node(1, 2), n22 = builder.node(2, 2);
  builder.quad(n00, n10, n11, n01);
  builder.quad(n10, n20, n21, n11);
  builder.quad(n01, n11, n12, n02);
  builder.quad(n11, other, n22, n12);
  const Examined result = examine(builder.build());
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::overlapping_boundary);
  const MeshObstacle obstacle = first_obstacle(result);
  CHECK(obstacle.elements == std::vector<std::uint32_t>{1, 3});
  CHECK(hint(obstacle).find("not merged") != std::string::npos);
  CHECK(hint(obstacle).find("slit") != std::string::npos);
  // Glued by points there is no slit.
  CHECK(examine(builder.build(false)).verdict == MeshVerdict::embedding);
}

TEST_CASE("a hanging node on an edge, exactly") {
  for (const int degree : {1, 2, 3}) {
    for (const Rational& x : {Rational(2), Rational(3), Rational(37, 10)}) {
      for (const bool by_nodes : {true, false}) {
        Hanging mesh(x, 0, degree);
        const Examined result = examine(mesh.build(by_nodes));
        INFO(text_of(result));
        CHECK(result.verdict == MeshVerdict::non_conforming);
        const MeshObstacle obstacle = first_obstacle(result);
        CHECK(obstacle.elements == std::vector<std::uint32_t>{0, 1, 2});
        CHECK(obstacle.points == std::vector<Point>{{x, 0}});
        CHECK(hint(obstacle).find("hanging node") != std::string::npos);
        REQUIRE(obstacle.distance);
        CHECK(sign(obstacle.distance->upper) == 0);
        CHECK(result.obstacles.count(MeshVerdict::non_conforming) == 1);
      }
    }
  }
}

TEST_CASE("a node beside the edge: a hole if it leaves a gap, a fold or a hanging node otherwise") {
  Hanging gap(2, Rational(-1, 10), 1);
  const Examined hole = examine(gap.build());
  INFO(text_of(hole));
  CHECK(hole.verdict == MeshVerdict::embedding);
  CHECK(hole.holes == std::size_t{1});
  // On the other side the elements overlap from both ends of the edge on.
  Hanging over(2, Rational(1, 10), 1);
  CHECK(examine(over.build()).verdict == MeshVerdict::folded_vertex);
  // One curved edge that crosses: below the edge at m, above it near a.
  Hanging crossing(3, Rational(-1, 10), 2);
  crossing.builder.curve(crossing.a, crossing.m, {crossing.builder.node(1, Rational(1, 10))});
  const Examined result = examine(crossing.build());
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::non_conforming);
  const MeshObstacle obstacle = first_obstacle(result);
  CHECK(obstacle.nodes == std::vector<std::uint32_t>{crossing.m});
  REQUIRE(obstacle.distance);
  CHECK(to_rational(obstacle.distance->upper) >= Rational(1, 10));
  CHECK(to_rational(obstacle.distance->upper) <= Rational(11, 100));
}

}  // namespace bezcert::test
