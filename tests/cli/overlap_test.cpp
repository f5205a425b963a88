// The evidence of `overlapping`: two parts of the boundary that really meet.
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "exact_determinant.hpp"
#include "jsonl_report.hpp"
#include "program.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {
namespace {

using Point = std::pair<Rational, Rational>;

// Edge i leads from corner i to the next.
Values edge_parameter(const Element& element, int edge, const Rational& t) {
  const Rational s = 1 - t;
  if (element.is_triangle()) {
    if (edge == 0) return {s, t, 0};
    return edge == 1 ? Values{0, s, t} : Values{t, 0, s};
  }
  switch (edge) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {s, 1};
    default: return {0, s};
  }
}

// The points of a range of an edge, in equal steps.
std::vector<Point> samples(const Element& element, const Json& range) {
  const Rational lower = rational_of(range["lower"]);
  const Rational upper = rational_of(range["upper"]);
  REQUIRE(lower >= 0);
  REQUIRE(lower <= upper);
  REQUIRE(upper <= 1);
  constexpr int steps = 64;
  std::vector<Point> points;
  for (int k = 0; k <= steps; ++k) {
    const DualPoint point = exact_map(
        element, edge_parameter(element, range["edge"], lower + (upper - lower) * Rational(k, steps)));
    points.emplace_back(point.x.value, point.y.value);
  }
  return points;
}

int turn(const Point& a, const Point& b, const Point& c) {
  return sign(
      Rational((b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first)));
}

bool between(const Rational& a, const Rational& b, const Rational& c) {
  return (a <= b && b <= c) || (c <= b && b <= a);
}

bool contains(const Point& a, const Point& b, const Point& p) {
  return turn(a, b, p) == 0 && between(a.first, p.first, b.first) && between(a.second, p.second, b.second);
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
  return contains(a, b, c) || contains(a, b, d) || contains(c, d, a) || contains(c, d, b);
}

bool polygons_meet(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (std::size_t j = 1; j < b.size(); ++j) {
      if (segments_meet(a[i - 1], a[i], b[j - 1], b[j])) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("overlapping elements show two parts of the boundary that meet") {
  const Folder folder;
  std::size_t seen = 0;
  // corpus/beyond_regular.txt: the elements with two parameters of one image.
  for (const std::string name : {"overlapping-corners", "overlapping-interior", "overlapping-quad"}) {
    INFO(name);
    const std::string file = corpus_element(name);
    const Outcome outcome = folder.run({"check", file, "--format=jsonl"});
    CHECK(outcome.code == 1);
    const Json object = parse_report(outcome.out).at(0).elements.at(0);
    REQUIRE(object["verdict"] == "overlapping");
    const Json& overlap = object["overlap"];
    REQUIRE(overlap.size() == 2);
    const Element element = read_mesh(file, read_file(file)).element(0);
    for (const Json& range : overlap) {
      REQUIRE(keys_of(range) == std::vector<std::string>{"edge", "lower", "upper"});
      REQUIRE(range["edge"].is_number_unsigned());
      REQUIRE(range["edge"].get<int>() < (element.is_triangle() ? 3 : 4));
    }
    // Without a common parameter: on one edge the ranges do not touch.
    if (overlap[0]["edge"] == overlap[1]["edge"]) {
      CHECK((rational_of(overlap[0]["upper"]) < rational_of(overlap[1]["lower"]) ||
             rational_of(overlap[1]["upper"]) < rational_of(overlap[0]["lower"])));
    }
    const auto first = samples(element, overlap[0]);
    const auto second = samples(element, overlap[1]);
    const bool points = first.front() == first.back() && second.front() == second.back();
    if (points) CHECK(first.front() == second.front());
    CHECK(polygons_meet(first, second));
    ++seen;
  }
  CHECK(seen == 3);
}

}  // namespace bezcert::test
