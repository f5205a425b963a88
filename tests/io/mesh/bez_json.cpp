// .bez.json as it should be: points, weights, shared nodes, numbers, names, curves, and writing it.
#include "bezcert/io/mesh/bez_json.hpp"
#include "random_input.hpp"
#include "reading.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {
namespace {

std::string file_of(const std::string& elements, const std::string& more = "") {
  return "{ \"bezcert\": 1, " + more + " \"elements\": [" + elements + "] }";
}

Mesh read_element(const std::string& members, const std::string& more = "") {
  return read_mesh("test.bez.json", file_of("{" + members + "}", more));
}

// x of the second point of a triangle of degree 1, given as a JSON value.
Rational read_number(const std::string& json) {
  return read_element("\"kind\":\"triangle\",\"degree\":1,\"points\":[[0,0],[" + json + ",0],[0,1]]")
      .coordinates(0)[1];
}

Rational ten_to(int exponent) { return power(Rational(10), exponent); }

}  // namespace

TEST_CASE("bez.json numbers mean their exact value, however written") {
  const std::vector<std::pair<std::string, Rational>> cases = {
      {"0.1", Rational(1, 10)},
      {"\"0.1\"", Rational(1, 10)},
      {"\"1/10\"", Rational(1, 10)},
      {"1e-1", Rational(1, 10)},
      {"10E-2", Rational(1, 10)},
      {"\"-7/21\"", Rational(-1, 3)},
      {"\"0/5\"", Rational(0)},
      {"-0.0", Rational(0)},
      {"-0", Rational(0)},
      {"-1.5e-3", Rational(-3, 2000)},
      {"\"-1.5e-3\"", Rational(-3, 2000)},
      {"1E2", Rational(100)},
      {"0.30000000000000004", Rational(Integer("30000000000000004"), Integer("100000000000000000"))},
      {"18446744073709551615", Rational(Integer("18446744073709551615"))},
      {"18446744073709551616", Rational(Integer("18446744073709551616"))},
      {"-9223372036854775809", Rational(Integer("-9223372036854775809"))},
      {"1234567890123456789012345678901234567890",
       Rational(Integer("1234567890123456789012345678901234567890"))},
      {"1e-400", 1 / ten_to(400)},
      {"\"1e-400\"", 1 / ten_to(400)},
      {"\"1e400\"", ten_to(400)},
      {"5e-324", 5 / ten_to(324)},
      {"\"5000000000000000000000000000001/3\"",
       Rational(Integer("5000000000000000000000000000001"), Integer(3))},
      {"\"-1/" + std::string(1, '1') + std::string(300, '0') + "\"", -1 / ten_to(300)},
  };
  std::size_t seen = 0;
  for (const auto& [json, value] : cases) {
    INFO("number " << json);
    CHECK(read_number(json) == value);
    ++seen;
  }
  CHECK(seen == 23);
}

// docs/formats.md: JSON numbers beyond the range of doubles must be strings.
TEST_CASE("a JSON number beyond the doubles is refused, the same text as a string is exact") {
  std::size_t seen = 0;
  for (const auto& [text, value] : {std::pair{"1e400", ten_to(400)}, {"-1.5E309", -15 * ten_to(308)}}) {
    const std::string start =
        "{\"bezcert\":1,\"elements\":[{\"kind\":\"triangle\",\"degree\":1,\n\"points\":[[0,0],\n[";
    require_refused(start + text + ",0],[0,1]]}]}", text, 3);
    CHECK(read_number("\"" + std::string(text) + "\"") == value);
    ++seen;
  }
  CHECK(seen == 2);
}

TEST_CASE("bez.json elements have their points by rows, their basis, names and expected verdicts") {
  const Mesh mesh = read_mesh("test.bez.json", R"({ "bezcert": 1,
  "elements": [
    { "name": "bent \"one\" \u00e9", "expect": "folded", "source": "here", "kind": "triangle", "degree": 2,
      "points": [[0, 0], ["1/2", -0.25], [1, 0], [0, 0.5], ["0.5", "1/2"], [0, "1"]] },
    { "kind": "quadrilateral", "degree": [2, 1], "basis": "lagrange",
      "points": [[0, 0], [1, 0], [2, 0],
                 [0, 3], [1, 4], [2, 3]] } ] })");
  REQUIRE(mesh.elements().size() == 2);
  CHECK(mesh.elements()[0].shape == Shape::triangle(2));
  CHECK(mesh.elements()[1].shape == Shape::square(2, 1));
  CHECK(mesh.elements()[0].basis == Basis::bernstein);
  CHECK(mesh.elements()[1].basis == Basis::lagrange);
  CHECK(mesh.origin().basis_name == "mixed");
  CHECK(mesh.origin().numbers == Numbers::decimal);
  CHECK(mesh.origin().number(0) == 1);
  CHECK(mesh.origin().number(1) == 2);
  CHECK(mesh.origin().line(0) == 3);
  CHECK(mesh.origin().line(1) == 5);
  CHECK(mesh.origin().element_names == std::vector<std::string>{"bent \"one\" \xc3\xa9", ""});
  CHECK(mesh.origin().element_expected == std::vector<std::string>{"folded", ""});
  CHECK(mesh.weights().empty());
  const Rational half(1, 2);
  const std::vector<std::pair<Rational, Rational>> first = {
      {0, 0}, {half, Rational(-1, 4)}, {1, 0}, {0, half}, {half, half}, {0, 1}};
  CHECK(points_of(mesh, 0) == first);
  const std::vector<std::pair<Rational, Rational>> second = {{0, 0}, {1, 0}, {2, 0}, {0, 3}, {1, 4}, {2, 3}};
  CHECK(points_of(mesh, 1) == second);
  CHECK(!mesh.element(0).rational());
  CHECK(is_sound(mesh));
}

TEST_CASE("bez.json reading does not look at the options for .msh") {
  const std::string text = file_of(R"({"kind":"triangle","degree":1,"points":[[0,0],[0.1,0],[0,1]]})");
  const Mesh mesh = read_mesh("t", text, {Basis::lagrange, Numbers::binary64});
  CHECK(mesh.elements()[0].basis == Basis::bernstein);
  CHECK(mesh.origin().basis_name == "bernstein");
  CHECK(mesh.origin().numbers == Numbers::decimal);
  CHECK(mesh.coordinates(0)[1] == Rational(1, 10));
}

TEST_CASE("bez.json weights belong to their points, and elements without have ones") {
  const Mesh mesh = read_mesh("t", file_of(R"({"kind":"triangle","degree":1,"points":[[0,0],[1,0],[0,1]]},
                      {"kind":"triangle","degree":1,"points":[[0,0],[1,0],[0,1]],"weights":[1,"2/3",0.1]},
                      {"kind":"triangle","degree":1,"points":[[0,0],[1,0],[0,1]],"weights":[7,7,7]})"));
  CHECK(!mesh.element(0).rational());
  CHECK(mesh.element(1).rational());
  CHECK(!mesh.element(2).rational());
  CHECK(mesh.element(1).weights()[1] == Rational(2, 3));
  CHECK(mesh.element(1).weights()[2] == Rational(1, 10));
  CHECK(mesh.element(2).weights()[0] == 7);
}

TEST_CASE("bez.json nodes refer to shared points and weights") {
  const std::string shared = R"("points": [[0,0],[1,0],[1,1],[0,1]], "weights": [1,2,3,4],)";
  const std::string elements =
      R"({"kind":"triangle","degree":1,"nodes":[0,1,2]}, {"kind":"triangle","degree":1,"nodes":[0,2,3]},
         {"kind":"quadrilateral","degree":[1,1],"nodes":[0,1,3,2]},
         {"kind":"triangle","degree":1,"points":[[5,5],[6,5],[5,6]],"weights":[9,8,7]})";
  const Mesh mesh = read_mesh("t", file_of(elements, shared));
  REQUIRE(mesh.elements().size() == 4);
  CHECK(mesh.node_count() == 7);
  CHECK(mesh.connectivity() == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 1, 3, 2, 4, 5, 6});
  const Element square = mesh.element(2);
  CHECK(square.weights()[2] == 4);
  CHECK(square.coordinates()[1][2] == 1);
  CHECK(square.coordinates()[0][2] == 0);
  CHECK(mesh.element(3).weights()[2] == 7);
  CHECK(mesh.element(3).coordinates()[0][1] == 6);
  // The same without weights, and with the shared points behind the elements.
  const Mesh plain = read_mesh(
      "t",
      R"({"elements":[{"kind":"triangle","degree":1,"nodes":[2,0,1]}],"points":[[0,0],[1,0],[1,1]],"bezcert":1})");
  CHECK(plain.weights().empty());
  CHECK(plain.connectivity() == std::vector<std::uint32_t>{2, 0, 1});
}

TEST_CASE("bez.json curves are accepted and left out") {
  const std::string curves = R"("curves": [
    {"degree": 2, "points": [["0","0"],["1/2","-1/4"],["1","0"]], "weights": ["1","2","1"]},
    {"degree": 1, "name": "chord", "source": "test", "points": [[0,0],[1,0]]} ],)";
  const Mesh mesh = read_element(R"("kind":"triangle","degree":1,"points":[[0,0],[1,0],[0,1]])", curves);
  CHECK(mesh.elements().size() == 1);
  CHECK(mesh.node_count() == 3);
  CHECK(mesh.origin().ignored.lines == 0);
}

TEST_CASE("bez.json degrees from 1 to 64 in each direction") {
  std::size_t seen = 0;
  for (const auto& [p, q] : {std::pair{1, 64}, {64, 1}, {2, 5}, {5, 2}, {1, 1}}) {
    std::string points;
    for (int r = 0; r <= q; ++r) {
      for (int c = 0; c <= p; ++c) {
        points += (points.empty() ? "[" : ",[") + std::to_string(c) + "," + std::to_string(r) + "]";
      }
    }
    const Mesh mesh = read_element("\"kind\":\"quadrilateral\",\"degree\":[" + std::to_string(p) + "," +
                                   std::to_string(q) + "],\"points\":[" + points + "]");
    CHECK(mesh.elements()[0].shape == Shape::square(p, q));
    // Row 1, column 0 is behind the p + 1 points of row 0.
    CHECK(mesh.coordinates(1)[static_cast<std::size_t>(p) + 1] == 1);
    CHECK(mesh.coordinates(0)[static_cast<std::size_t>(p) + 1] == 0);
    ++seen;
  }
  std::string points;
  for (int i = 0; i < 65 * 66 / 2; ++i) points += (i > 0 ? ",[0," : "[0,") + std::to_string(i) + "]";
  CHECK(read_element("\"kind\":\"triangle\",\"degree\":64,\"points\":[" + points + "]").node_count() == 2145);
  CHECK(seen == 5);
}

TEST_CASE("what write_bez_json writes is read back exactly") {
  const std::uint64_t seed = seed_or(20240611);
  INFO("seed " << seed);
  Random random(seed);
  std::size_t triangles = 0, quadrilaterals = 0, rational = 0, lagrange = 0, doubles = 0;
  for (int round = 0; round < 400; ++round) {
    const bool triangle = random.chance(50);
    const Shape shape = triangle ? Shape::triangle(static_cast<int>(random.integer(1, 5)))
                                 : Shape::square(static_cast<int>(random.integer(1, 4)),
                                                 static_cast<int>(random.integer(1, 4)));
    const Basis basis = random.chance(50) ? Basis::bernstein : Basis::lagrange;
    const bool as_doubles = random.chance(50);
    ExactVector x, y, weights;
    for (std::size_t i = 0; i < coefficient_count(shape); ++i) {
      for (ExactVector* to : {&x, &y}) {
        if (as_doubles) {
          to->push_back(random.any_double(-1000, 1000));
        } else {
          to->push_back(random.rational(-100, 100, random.integer(1, 1000000)));
        }
      }
    }
    // Nearly equal: weights of Lagrange nodes must stay positive as weights of control points.
    if (random.chance(50)) {
      for (std::size_t i = 0; i < coefficient_count(shape); ++i)
        weights.push_back(Rational(random.integer(1000000, 1000010), 3));
    }
    const Element element(shape, basis, {x, y}, weights);
    const std::string name = random.chance(50) ? "n\"a\\m\ne \xc3\xa9 " + std::to_string(round) : "";
    std::ostringstream stream;
    write_bez_json(stream, element, name, random.chance(50) ? "made by a test" : "");
    INFO("round " << round << ": " << stream.str());
    const Mesh mesh = read_mesh("written", stream.str());
    REQUIRE(mesh.elements().size() == 1);
    const Element again = mesh.element(0);
    REQUIRE(again.shape() == shape);
    REQUIRE(again.basis() == basis);
    REQUIRE(again.weights().size() == weights.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      REQUIRE(again.coordinates()[0][i] == x[i]);
      REQUIRE(again.coordinates()[1][i] == y[i]);
      if (!weights.empty()) REQUIRE(again.weights()[i] == weights[i]);
    }
    REQUIRE(mesh.origin().element_names == std::vector<std::string>{name});
    triangles += triangle;
    quadrilaterals += !triangle;
    rational += again.rational();
    lagrange += basis == Basis::lagrange;
    doubles += as_doubles;
  }
  CHECK(triangles + quadrilaterals == 400);
  for (const std::size_t count : {triangles, quadrilaterals, rational, lagrange, doubles}) {
    CHECK(count > 100);
    CHECK(count < 300);
  }
}

// `source` holds the path of a mesh in the reproducer of a contradiction, and a path may hold any bytes.
TEST_CASE("write_bez_json does not fail on names that are no UTF-8") {
  const Element element(
      Shape::triangle(1), Basis::bernstein,
      {ExactVector(std::vector<double>{0, 1, 0}), ExactVector(std::vector<double>{0, 0, 1})});
  std::ostringstream stream;
  REQUIRE_NOTHROW(write_bez_json(stream, element, "bad \xff name", "mesh\xe9.msh"));
  CHECK(read_mesh("written", stream.str()).elements().size() == 1);
}

}  // namespace bezcert::test
