// Conformity to input curves.
#include "mesh_sketch.hpp"

#include "bezcert/curve/incidence.hpp"
#include "bezcert/surface/domain.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;
using Points = std::vector<std::pair<Rational, Rational>>;

InputCurve curve(const Points& points, const std::vector<Rational>& weights = {}) {
  InputCurve result;
  for (const auto& [x, y] : points) {
    result.x.push_back(x);
    result.y.push_back(y);
  }
  for (const Rational& w : weights) result.weights.push_back(w);
  return result;
}

const Points parabola = {{0, 0}, {6, 3}, {12, 0}};

// Quadrilaterals above pieces of the parabola, cut at these parameters.
Mesh above_parabola(const std::vector<Rational>& cuts, const Rational& nudge = 0) {
  MeshSketch builder;
  const CurveNet<Integer> whole = curve(parabola).exact();
  std::vector<Node> low, high;
  for (const Rational& t : cuts) {
    const Point p = point_at(whole, t);
    low.push_back(builder.node(p.x, p.y));
    high.push_back(builder.node(p.x, 6));
  }
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const CurveNet<Integer> part = part_of(whole, cuts[k], cuts[k + 1]);
    builder.curve(low[k], low[k + 1],
                  {builder.node(Rational(part.x[1], part.w[1]),
                                Rational(part.y[1], part.w[1]) + (k == 1 ? nudge : Rational(0)))});
    builder.quad(low[k], low[k + 1], high[k + 1], high[k], 2, 2);
  }
  return builder.build();
}

DomainResult check(const Mesh& mesh, const std::vector<InputCurve>& curves) {
  ObstacleList obstacles;
  return check_domain(Surface(mesh, obstacles), curves);
}

}  // namespace

TEST_CASE("parts of a curve by blossoming") {
  // x = t, y = t^2 between 1/3 and 1: at the ends and with the control point where the tangents meet, ((a +
  // b) / 2, a b).
  const CurveNet<Integer> net = curve({{0, 0}, {Rational(1, 2), 0}, {1, 1}}).exact();
  const CurveNet<Integer> part = part_of(net, Rational(1, 3), 1);
  const auto at = [&](std::size_t i) {
    return Point{Rational(part.x[i], part.w[i]), Rational(part.y[i], part.w[i])};
  };
  CHECK(at(0) == Point{Rational(1, 3), Rational(1, 9)});
  CHECK(at(1) == Point{Rational(2, 3), Rational(1, 3)});
  CHECK(at(2) == Point{1, 1});
  CHECK(rational_parameters(net, {Rational(2, 7), Rational(4, 49)}, 0) ==
        std::vector<Rational>{Rational(2, 7)});
  CHECK(rational_parameters(net, {Rational(2, 7), Rational(4, 50)}, 0).empty());
  CHECK(rational_parameters(net, {0, 0}, 0).empty());
  CHECK(passes_inside(net, {Rational(1, 2), Rational(1, 4)}));
  CHECK(!passes_inside(net, {1, 1}));
  // x = t^2 + ..., at an irrational parameter: x = y = t^2 passes (1/2, 1/2).
  CHECK(passes_inside(curve({{0, 0}, {0, 0}, {1, 1}}).exact(), {Rational(1, 2), Rational(1, 2)}));
}

TEST_CASE("curves covered by edges, forwards, backwards, raised and reparametrised") {
  const Mesh mesh = above_parabola({0, Rational(1, 3), Rational(5, 7), 1});
  const std::vector<InputCurve> curves = {
      curve(parabola),
      curve({{12, 0}, {6, 3}, {0, 0}}),
      curve({{0, 0}, {4, 2}, {8, 2}, {12, 0}}),  // raised
      curve(parabola, {1, 3, 9}),                // t -> 3 t / (3 t + 1 - t)
      curve({{0, 0}, {0, 3}, {0, 6}}),           // the left side
      curve({{4, Rational(4, 3)}, {4, 6}}),      // an edge inside
      curve({{0, 6}, {12, 6}}),                  // the top, three edges
  };
  const DomainResult result = check(mesh, curves);
  for (const DomainFailure& failure : result.failures) {
    INFO("curve " << failure.curve << " at " << failure.parameter << ": " << message(mesh, failure));
    CHECK(false);
  }
  CHECK(result.covered == curves.size());
  CHECK(result.conforming());
}

TEST_CASE("where the coverage stops, and why") {
  const Mesh mesh = above_parabola({0, Rational(1, 3), Rational(5, 7), 1}, Rational(1, 100));
  const DomainResult result = check(mesh, {curve(parabola), curve({{1, 1}, {2, 1}}), curve({{0, 6}, {11, 6}}),
                                           curve({{0, 6}, {3, 6}, {12, 6}})});
  CHECK(result.covered == 0);
  REQUIRE(result.failures.size() == 4);
  CHECK(result.failures[0].parameter == Rational(1, 3));
  CHECK(result.failures[0].point == Point{4, Rational(4, 3)});
  CHECK(result.failures[0].elements == std::vector<std::uint32_t>{0, 1});
  CHECK(message(mesh, result.failures[0]).find("of element 2") != std::string::npos);
  CHECK(result.failures[1].parameter == 0);
  CHECK(result.failures[1].elements.empty());
  // The top ends between nodes: covered up to the last node before.
  CHECK(result.failures[2].parameter == Rational(60, 77));
  CHECK(message(mesh, result.failures[2]).find("ends at (11, 6)") != std::string::npos);
  CHECK(result.failures[3].parameter == 0);
}

TEST_CASE("a closed curve, and one that passes a node twice") {
  // x = 12 u (1 - u) (1 - 2 u) 3, y = 36 u (1 - u): a teardrop? A cubic from the origin back to it.
  const Points loop = {{0, 0}, {12, 12}, {-12, 12}, {0, 0}};
  const CurveNet<Integer> whole = curve(loop).exact();
  MeshSketch builder;
  const Node centre = builder.node(0, 5), start = builder.node(0, 0);
  std::vector<Node> corners = {start};
  const std::vector<Rational> cuts = {0, Rational(1, 4), Rational(1, 2), Rational(3, 4), 1};
  for (std::size_t k = 1; k < 4; ++k) {
    const Point p = point_at(whole, cuts[k]);
    corners.push_back(builder.node(p.x, p.y));
  }
  corners.push_back(start);
  for (std::size_t k = 0; k < 4; ++k) {
    const CurveNet<Integer> part = part_of(whole, cuts[k], cuts[k + 1]);
    std::vector<Node> inner;
    for (const std::size_t i : {1, 2}) {
      inner.push_back(builder.node(Rational(part.x[i], part.w[i]), Rational(part.y[i], part.w[i])));
    }
    builder.curve(corners[k], corners[k + 1], inner);
    builder.triangle(centre, corners[k], corners[k + 1], 3);
  }
  const Mesh mesh = builder.build();
  const DomainResult result = check(mesh, {curve(loop), curve({{0, 0}, {-12, 12}, {12, 12}, {0, 0}})});
  CHECK(result.covered == 2);
  // Twice round: 1 and a half of the loop is not one polynomial; another loop through the same corner fails
  // at once.
  const DomainResult other = check(mesh, {curve({{0, 0}, {12, 12}, {-12, 13}, {0, 0}})});
  CHECK(other.covered == 0);
  CHECK(other.failures[0].parameter == 0);
}

}  // namespace bezcert::test
