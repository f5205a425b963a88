// What the points of a .msh are, and what their text means, decides the verdict: --basis and --numbers.
#include "bezcert/number/rational.hpp"
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace bezcert::test {
namespace {

using Json = nlohmann::json;

// The element's object of a report on one element, and the exit code.
struct Report {
  int code = -1;
  Json header;
  Json element;
};

Report check_one(const Folder& folder, const std::string& mesh, const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {"check", mesh, "--format=jsonl"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);
  return {outcome.code, Json::parse(lines[0]), Json::parse(lines[1])};
}

Rational rational(const Json& text) {
  const std::string value = text.get<std::string>();
  const std::size_t slash = value.find('/');
  return slash == std::string::npos
             ? Rational(Integer(value))
             : Rational(Integer(value.substr(0, slash)), Integer(value.substr(slash + 1)));
}

// Bounds that hold, and to about three digits (docs/report.md: rounded outwards to 10 bits) where the least
// coefficient is at a corner.
void check_bounds(const Json& element, const Rational& minimum) {
  const Rational lower = rational(element["min_det"]["lower"]);
  const Rational upper = rational(element["min_det"]["upper"]);
  CHECK(lower <= minimum);
  CHECK(upper >= minimum);
  CHECK(upper - lower <= abs(minimum) / 100);
}

}  // namespace

// The edge point E between corners (0,0) and (1,0) is the control point P in the Bernstein basis; a node
// E = P/2 + (corner + corner)/4 in the Lagrange basis, so there P = 2 E - (1/2, 0) = (1/2, 2 e) for
// E = (1/2, e) with 2 (1/2) - 1/2 = 1/2. The other edges are straight, their control points the middles.
// det J at a corner of a quadratic triangle is 4 times the cross product of the control vectors there,
// counter-clockwise. With P = (1/2, p):
//   corner 0: 4 (P - (0,0)) x ((0,1/2) - (0,0))   = 4 (1/2, p) x (0, 1/2)          = 1
//   corner 1: 4 ((1/2,1/2) - (1,0)) x (P - (1,0)) = 4 (-1/2, 1/2) x (-1/2, p)      = 1 - 2 p
//   corner 2: 4 ((0,1/2) - (0,1)) x ((1/2,1/2) - (0,1)) = 4 (0,-1/2) x (1/2,-1/2)  = 1
// e = 0.45: p = 0.9 and det J = -4/5 as a node; p = 0.45 and det J = 1/10 as a control point.
TEST_CASE("the bezier-guarding trap: folded as nodes, fine as control points") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);

  const Report lagrange = check_one(folder, mesh, {"--basis=lagrange", "--numbers=decimal"});
  CHECK(lagrange.code == 1);
  CHECK(lagrange.header["basis"] == "lagrange");
  CHECK(lagrange.header["numbers"] == "decimal");
  CHECK(lagrange.element["verdict"] == "folded");
  CHECK(lagrange.element["witness"]["det"] == "-4/5");
  CHECK(lagrange.element["witness"]["parameter"] == Json({"0", "1", "0"}));
  // The Bernstein coefficients of det J are those at the corners, 1, -4/5 and 1, and half the sums of cross
  // products in between, 1/10, 1 and 1/10: none is below -4/5, which is taken.
  check_bounds(lagrange.element, Rational(-4, 5));

  const Report bernstein = check_one(folder, mesh, {"--basis=bernstein", "--numbers=decimal"});
  CHECK(bernstein.code == 0);
  CHECK(bernstein.header["basis"] == "bernstein");
  CHECK(bernstein.element["verdict"] == "injective");
  CHECK(bernstein.element["witness"].is_null());
  // Likewise 1, 1/10, 1 and between them 11/20, 1, 11/20.
  check_bounds(bernstein.element, Rational(1, 10));

  CHECK(check_one(folder, mesh, {}).element["verdict"] == "folded");
  CHECK(check_one(folder, mesh, {}).header["basis"] == "lagrange");

  const Outcome text = folder.run({"check", mesh, "--numbers=decimal", "--criteria=none"});
  const auto lines = lines_of(text.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0] ==
        mesh + ":15: element 7 (triangle, degree 2): folded, det J = -4/5 at (0, 1, 0), the point (1, 0)");
  CHECK(lines[1] == mesh + ": 1 element: 1 folded");
  CHECK(lines[2].starts_with(mesh + ": mesh: invalid_element"));
}

// As a double 0.45 is 8106479329266893 / 2^54 (0.45 2^54 = 8106479329266892.8), so at corner 1
// det J = 1 - 4 e = 1 - 8106479329266893 / 2^52 = -3602879701896397 / 4503599627370496.
TEST_CASE("the trap read as doubles has the determinant of the doubles") {
  const Folder folder;
  const Report report = check_one(folder, folder.write("trap.msh", trap_mesh), {});
  CHECK(report.code == 1);
  CHECK(report.header["numbers"] == "binary64");
  CHECK(report.element["witness"]["det"] == "-3602879701896397/4503599627370496");
  CHECK(report.element["witness"]["parameter"] == Json({"0", "1", "0"}));
}

// det J of the straight triangle (0,0), (a,b), (c,d) is a d - b c everywhere.
// (0.1, 0.3), (0.3, 0.9): 0.09 - 0.09 = 0 as decimals. As doubles 0.1 is 3602879701896397 / 2^55, 0.9 is
// 8106479329266893 / 2^53 and 0.3 is 5404319552844595 / 2^54, so a d - b c is
// (3602879701896397 * 8106479329266893 - 5404319552844595^2) / 2^108 = 2^52 / 2^108 = 2^-56.
TEST_CASE("degenerate as decimals, and not as doubles") {
  const Folder folder;
  const Rational tiny = power_of_two(-56);
  const std::string positive = folder.write("positive.msh", straight_mesh("0.1 0.3", "0.3 0.9"));
  const std::string negative = folder.write("negative.msh", straight_mesh("0.3 0.9", "0.1 0.3"));

  const Report as_doubles = check_one(folder, positive, {"--numbers=binary64"});
  CHECK(as_doubles.code == 0);
  CHECK(as_doubles.header["numbers"] == "binary64");
  CHECK(as_doubles.element["verdict"] == "injective");
  check_bounds(as_doubles.element, tiny);

  const Report reversed = check_one(folder, negative, {"--numbers=binary64"});
  CHECK(reversed.code == 1);
  CHECK(reversed.element["verdict"] == "reversed");
  CHECK(rational(reversed.element["witness"]["det"]) == -tiny);
  check_bounds(reversed.element, -tiny);

  for (const std::string& mesh : {positive, negative}) {
    const Report as_decimals = check_one(folder, mesh, {"--numbers=decimal"});
    CHECK(as_decimals.code == 1);
    CHECK(as_decimals.header["numbers"] == "decimal");
    CHECK(as_decimals.element["verdict"] == "degenerate");
    CHECK(as_decimals.element["witness"]["det"] == "0");
    check_bounds(as_decimals.element, Rational(0));
  }
}

// 2.00000000000000001 is 2 as a double (the next one is 2 + 2^-51 > 2 + 4e-16): 1 * 2 - 1 * 2 = 0.
// As decimals 1 * 2.00000000000000001 - 1 * 2 = 10^-17, and 10^-17 below 2 the other sign.
TEST_CASE("degenerate as doubles, and not as decimals") {
  const Folder folder;
  const Rational tiny(Integer(1), Integer("100000000000000000"));
  const std::string above = folder.write("above.msh", straight_mesh("1 1", "2 2.00000000000000001"));
  const std::string below = folder.write("below.msh", straight_mesh("1 1", "2 1.99999999999999999"));

  const Report positive = check_one(folder, above, {"--numbers=decimal"});
  CHECK(positive.code == 0);
  CHECK(positive.element["verdict"] == "injective");
  check_bounds(positive.element, tiny);

  const Report negative = check_one(folder, below, {"--numbers=decimal"});
  CHECK(negative.code == 1);
  CHECK(negative.element["verdict"] == "reversed");
  CHECK(negative.element["witness"]["det"] == "-1/100000000000000000");

  for (const std::string& mesh : {above, below}) {
    const Report as_doubles = check_one(folder, mesh, {});
    CHECK(as_doubles.code == 1);
    CHECK(as_doubles.header["numbers"] == "binary64");
    CHECK(as_doubles.element["verdict"] == "degenerate");
    CHECK(as_doubles.element["witness"]["det"] == "0");
  }
}

TEST_CASE("a .bez.json says itself what its points and numbers are") {
  const Folder folder;
  const std::vector<std::vector<std::string>> choices = {
      {}, {"--basis=bernstein"}, {"--basis=lagrange", "--numbers=binary64"}, {"--numbers=decimal"}};
  for (const auto& options : choices) {
    const Report node = check_one(folder, corpus_element("trap-node"), options);
    CHECK(node.header["basis"] == "lagrange");
    CHECK(node.header["numbers"] == "decimal");
    CHECK(node.element["verdict"] == "folded");
    CHECK(node.element["witness"]["det"] == "-4/5");
    const Report control = check_one(folder, corpus_element("trap-control-point"), options);
    CHECK(control.header["basis"] == "bernstein");
    CHECK(control.element["verdict"] == "injective");
  }
  CHECK(choices.size() == 4);
}

}  // namespace bezcert::test
