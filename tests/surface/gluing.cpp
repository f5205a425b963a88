// Edges: glued, of too many elements, turned over, of different curves.
#include "mesh_sketch.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;

// Two triangles of degree p on the edge from (0, 0) to (4, 0), which is bent up by `bend`; each one's control
// points of that edge are its own nodes.
struct Pair {
  MeshSketch builder;
  Node a, b;
  std::vector<Node> lower, upper;
  std::size_t below, above;

  explicit Pair(const Rational& bend = Rational(1, 2)) {
    a = builder.node(0, 0);
    b = builder.node(4, 0);
    const Node low = builder.node(2, -4), high = builder.node(2, 4);
    lower = {builder.node(2, bend)};
    upper = {builder.node(2, bend)};
    builder.curve(a, b, lower);
    below = builder.triangle(b, a, low, 2);
    builder.curve(a, b, upper);
    above = builder.triangle(a, b, high, 2);
  }
};

void check(const Mesh& mesh, MeshVerdict expected) {
  const Examined result = examine(mesh);
  INFO(text_of(result));
  CHECK(result.verdict == expected);
}

}  // namespace

TEST_CASE("equal curves glue, whatever their nodes are called") {
  const Pair pair;
  const Examined result = examine(pair.builder.build());
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::embedding);
  CHECK(result.components == 1);
  CHECK(result.loops == std::size_t{1});
  CHECK(result.holes == std::size_t{0});
  // The bend is inside: two triangles with base 4 and height 4.
  REQUIRE(result.area);
  CHECK(result.area->lower == 16);
  CHECK(result.area->upper == 16);
  check(pair.builder.build(false), MeshVerdict::embedding);
}

TEST_CASE("a node with many edges: glued, and one element there twice") {
  // A fan over the points (k, k^2) of a parabola.
  for (const int count : {3, 8, 33, 200}) {
    INFO(count);
    MeshSketch open;
    const Node top = open.node(0, count * count + 1);
    std::vector<Node> bottom;
    for (int k = -count; k <= count; ++k) bottom.push_back(open.node(k, k * k));
    for (std::size_t k = 0; k + 1 < bottom.size(); ++k) open.triangle(top, bottom[k], bottom[k + 1]);
    const Examined good = examine(open.build());
    CHECK(good.verdict == MeshVerdict::embedding);
    CHECK(good.loops == std::size_t{1});
    open.triangle(top, bottom[0], bottom[1]);
    const Examined doubled = examine(open.build());
    CHECK(doubled.verdict == MeshVerdict::non_manifold);
    CHECK(first_obstacle(doubled).elements ==
          std::vector<std::uint32_t>{0, static_cast<std::uint32_t>(2 * count)});
  }
}

TEST_CASE("different curves between the same nodes do not conform, with the distance") {
  for (const bool by_nodes : {true, false}) {
    Pair pair;
    pair.builder.y(pair.upper[0]) += Rational(1, 10);
    const Examined result = examine(pair.builder.build(by_nodes));
    INFO(text_of(result));
    CHECK(result.verdict == MeshVerdict::non_conforming);
    const MeshObstacle obstacle = first_obstacle(result);
    CHECK(obstacle.elements == std::vector<std::uint32_t>{0, 1});
    CHECK(obstacle.nodes == (by_nodes ? std::vector<std::uint32_t>{0, 1} : std::vector<std::uint32_t>{}));
    CHECK(obstacle.points.size() == 2);
    // The difference is 2 t (1-t) / 10, at most 1/20.
    REQUIRE(obstacle.distance);
    CHECK(to_rational(obstacle.distance->lower) <= Rational(1, 20));
    CHECK(to_rational(obstacle.distance->upper) >= Rational(1, 20));
    CHECK(to_rational(obstacle.distance->upper) - to_rational(obstacle.distance->lower) <= Rational(1, 2000));
    CHECK(hint(obstacle).find("differ") != std::string::npos);
  }
}

TEST_CASE("an edge of one shape and two parametrisations: projective is fine, another is not") {
  // Weights 1, 2, 4 are a projective change of the parameter of 1, 1, 1.
  Pair projective;
  MeshSketch& builder = projective.builder;
  const Node a2 = builder.node(0, 0, 1), b2 = builder.node(4, 0, 4);
  builder.weight(projective.upper[0]) = 2;
  // By points: the corners are one vertex though their weights differ.
  builder.replace(projective.above, projective.a, a2);
  builder.replace(projective.above, projective.b, b2);
  check(builder.build(false), MeshVerdict::embedding);

  // A straight edge with its control point off the middle: the same points, another speed.
  Pair uneven(0);
  uneven.builder.x(uneven.upper[0]) = Rational(9, 4);
  const Examined result = examine(uneven.builder.build());
  INFO(text_of(result));
  CHECK(result.verdict == MeshVerdict::non_conforming);
  CHECK(hint(first_obstacle(result)).find("one shape") != std::string::npos);

  // A conic and a parabola with the same control points.
  Pair conic;
  conic.builder.weight(conic.upper[0]) = Rational(3, 2);
  check(conic.builder.build(), MeshVerdict::non_conforming);
}

TEST_CASE("three elements on an edge, and two on one side, are not manifold") {
  for (const int p : {1, 2, 3}) {
    MeshSketch three;
    const Node a = three.node(0, 0), b = three.node(4, 0);
    three.triangle(a, b, three.node(0, 3), p);
    three.triangle(a, b, three.node(4, 3), p);
    three.triangle(b, a, three.node(2, -3), p);
    const Examined result = examine(three.build());
    INFO(text_of(result));
    CHECK(result.verdict == MeshVerdict::non_manifold);
    CHECK(first_obstacle(result).elements == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(first_obstacle(result).nodes == std::vector<std::uint32_t>{a, b});
    check(three.build(false), MeshVerdict::non_manifold);

    MeshSketch side;
    const Node c = side.node(0, 0), d = side.node(4, 0);
    side.triangle(c, d, side.node(0, 3), p);
    side.triangle(c, d, side.node(4, 3), p);
    const Examined same = examine(side.build());
    CHECK(same.verdict == MeshVerdict::non_manifold);
    CHECK(first_message(same).find("same side") != std::string::npos);
  }
}

TEST_CASE("a Moebius-like gluing is not manifold") {
  // A ring of five triangles whose last one runs along edge 0 1 as the first does. (Nodes on a pentagon
  // star.)
  MeshSketch builder;
  const Node n0 = builder.node(0, 0), n1 = builder.node(4, 0), n2 = builder.node(2, 3),
             n3 = builder.node(6, 3);
  const Node n4 = builder.node(4, 6);
  builder.triangle(n0, n1, n2);
  builder.triangle(n2, n1, n3);
  builder.triangle(n2, n3, n4);
  builder.triangle(n0, n1, n4);
  check(builder.build(), MeshVerdict::non_manifold);
}

TEST_CASE("a curve raised in degree is the same edge") {
  MeshSketch builder;
  const Node a = builder.node(0, 0), b = builder.node(4, 0), low = builder.node(2, -4),
             high = builder.node(2, 4);
  builder.curve(a, b, {builder.node(2, 1)});
  builder.triangle(b, a, low, 2);
  // (2, 1) raised: 1/3 of the ends and 2/3 of it.
  builder.curve(a, b,
                {builder.node(Rational(4, 3), Rational(2, 3)), builder.node(Rational(8, 3), Rational(2, 3))});
  builder.triangle(a, b, high, 3);
  check(builder.build(), MeshVerdict::embedding);
}

TEST_CASE("gluing obstacles are reported beside invalid elements") {
  MeshSketch builder;
  const Node a = builder.node(0, 0), b = builder.node(4, 0);
  builder.triangle(a, b, builder.node(0, 3));
  builder.triangle(a, b, builder.node(4, 3));
  builder.triangle(a, b, builder.node(8, 0));  // flat
  const Examined result = examine(builder.build());
  CHECK(result.verdict == MeshVerdict::invalid_element);
  CHECK(result.obstacles.count(MeshVerdict::invalid_element) == 1);
  CHECK(result.obstacles.count(MeshVerdict::non_manifold) == 1);
}

}  // namespace bezcert::test
