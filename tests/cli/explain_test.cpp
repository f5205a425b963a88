// certify explain and certify criteria, and that reports are the same every time.
#include "jsonl_report.hpp"
#include "program.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <regex>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

const std::vector<std::string> criterion_names = {"control-net", "orientation", "cone", "coefficients",
                                                  "subdivision"};

// The place of a line that is `text`, from `start` on.
std::size_t place_of(const std::vector<std::string>& lines, const std::string& text, std::size_t start = 0) {
  for (std::size_t i = start; i < lines.size(); ++i) {
    if (lines[i] == text) return i;
  }
  FAIL("no line '" << text << "'");
  return 0;
}

// name -> its line in the last part of an explanation.
std::map<std::string, std::string> criterion_lines(const std::vector<std::string>& lines) {
  std::map<std::string, std::string> found;
  for (std::size_t i = place_of(lines, "criteria") + 1; i < lines.size(); ++i) {
    for (const std::string& name : criterion_names) {
      if (lines[i].starts_with("  " + name + " ")) found[name] = lines[i];
    }
  }
  return found;
}

std::string without_seconds(const std::string& text) {
  static const std::regex seconds("\"seconds\":[-+0-9.e]+");
  return std::regex_replace(text, seconds, "\"seconds\":0");
}

}  // namespace

TEST_CASE("certify criteria lists five names with their standing") {
  const Folder folder;
  const Outcome outcome = folder.run({"criteria"});
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  std::map<std::string, std::string> standing;
  std::vector<std::string> names;
  for (const std::string& line : lines_of(outcome.out)) {
    if (line.empty() || line.front() != ' ') {
      names.push_back(line);
    } else if (line.starts_with("  standing")) {
      REQUIRE(!names.empty());
      CHECK(standing.emplace(names.back(), line).second);
    }
  }
  CHECK(names == criterion_names);
  REQUIRE(standing.size() == 5);
  // The corpus holds counterexamples to these two (control-net-folded-*, cone-folded-*): only claimed.
  for (const std::string name : {"control-net", "cone"})
    CHECK(standing[name].find("claimed") != std::string::npos);
  // These are proved (corpus/README.md, docs/criteria.md).
  for (const std::string name : {"orientation", "coefficients", "subdivision"}) {
    CHECK(standing[name].find("sound") != std::string::npos);
    CHECK(standing[name].find("claimed") == std::string::npos);
  }
}

// The trap of trap_test.cpp with e = 0.45 exact: control vectors along the rows A = (1/2, 9/10),
// (1/2, -9/10), (1/2, 0), across them B = (0, 1/2), (0, -2/5), (0, 1/2), in the order corner 0, 1, 2 of
// linear polynomials. The coefficients of N = A x B are A_k x B_k at the corners, 1/4, -1/5, 1/4, and
// (A_j x B_k + A_k x B_j) / 2 between them: corners 0 and 1: 1/40; 0 and 2: 1/4; 1 and 2: 1/40.
TEST_CASE("certify explain tells verdict, signs, witness and failing conditions") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  const Outcome outcome = folder.run({"explain", mesh, "--element", "7", "--numbers=decimal"});
  INFO(outcome.out);
  CHECK(outcome.code == 1);
  CHECK(outcome.err.empty());
  const auto lines = lines_of(outcome.out);
  CHECK(lines.at(0) ==
        mesh + ":15: element 7 (triangle, degree 2): folded, det J = -4/5 at (0, 1, 0), the point (1, 0)");
  place_of(lines, "verdict: folded");
  const std::size_t witness = place_of(lines, "witness");
  CHECK(lines.at(witness + 1) == "  parameter  (0, 1, 0)");
  CHECK(lines.at(witness + 2) == "  decimal    (0, 1, 0)");
  CHECK(lines.at(witness + 3) == "  place      (1, 0)");
  CHECK(lines.at(witness + 4) == "  det J      -0.8 (exactly -4/5)");
  std::size_t signs = 0;
  while (signs < lines.size() && !lines[signs].starts_with("signs of the Bernstein coefficients")) ++signs;
  REQUIRE(signs + 3 < lines.size());
  CHECK(lines[signs].find("degree 2") != std::string::npos);
  CHECK(lines[signs + 1] == "  +");
  CHECK(lines[signs + 2] == "  + +");
  CHECK(lines[signs + 3] == "  + + -");
  const auto criteria = criterion_lines(lines);
  CHECK(criteria.size() == 5);
  for (const auto& [name, line] : criteria) {
    INFO(line);
    const std::size_t status = std::min(line.find(": inconclusive - "), line.find(": refuted - "));
    REQUIRE(status != std::string::npos);
    CHECK(line.size() > status + 20);  // and which condition failed
  }
  // Nodes are shown as in the file, the mid-edge node among them.
  CHECK(outcome.out.find("(0.5, 0.45)") != std::string::npos);
}

TEST_CASE("certify explain of a good element proves it and shows no witness") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  const Outcome outcome =
      folder.run({"explain", mesh, "--element=7", "--basis=bernstein", "--numbers=decimal"});
  INFO(outcome.out);
  CHECK(outcome.code == 0);
  const auto lines = lines_of(outcome.out);
  place_of(lines, "verdict: injective");
  CHECK(std::find(lines.begin(), lines.end(), "witness") == lines.end());
  // All coefficients are positive (trap_test.cpp).
  std::size_t signs = 0;
  while (signs < lines.size() && !lines[signs].starts_with("signs of the Bernstein coefficients")) ++signs;
  REQUIRE(signs + 3 < lines.size());
  CHECK(lines[signs + 1] == "  +");
  CHECK(lines[signs + 2] == "  + +");
  CHECK(lines[signs + 3] == "  + + +");
  const auto criteria = criterion_lines(lines);
  CHECK(criteria.size() == 5);
  // Coefficients >= 0 with positive corners, so these two hold.
  for (const std::string name : {"coefficients", "subdivision"})
    CHECK(criteria.at(name).find(": proved") != std::string::npos);
}

TEST_CASE("certify explain gives long numbers as decimals and exactly") {
  const Folder folder;
  // det J = 10^-17 (trap_test.cpp), clockwise.
  const std::string mesh = folder.write("thin.msh", straight_mesh("1 1", "2 1.99999999999999999"));
  const Outcome outcome = folder.run({"explain", mesh, "--element=1", "--numbers=decimal"});
  CHECK(outcome.code == 1);
  CHECK(outcome.out.find("verdict: reversed") != std::string::npos);
  CHECK(outcome.out.find("-1e-17 (exactly -1/100000000000000000)") != std::string::npos);
}

TEST_CASE("certify explain finds elements by number and name, and exits like check") {
  const Folder folder;
  std::size_t seen = 0;
  std::map<int, std::size_t> codes;
  for (const std::string name : {"affine", "trap-node", "subdivision-only-quadratic", "zero-corner",
                                 "quad-clockwise", "cone-folded-conic", "quarter-disc", "lagrange-quad"}) {
    const std::string mesh = corpus_element(name);
    const Outcome by_name = folder.run({"explain", mesh, "--element", name, "--budget=1,0"});
    const Outcome by_number = folder.run({"explain", mesh, "--element", "1", "--budget=1,0"});
    INFO(name << "\n" << by_name.out << by_name.err);
    CHECK(by_name.out == by_number.out);
    CHECK(by_name.code == by_number.code);
    CHECK(by_name.code == folder.run({"check", mesh, "--budget=1,0"}).code);
    CHECK(by_name.out.find("verdict: ") != std::string::npos);
    CHECK(criterion_lines(lines_of(by_name.out)).size() == 5);
    ++codes[by_name.code];
    ++seen;
  }
  CHECK(seen == 8);
  for (const int code : {0, 1, 3}) CHECK(codes[code] > 0);
  // The number of the file, not the place: the mesh's surface elements begin behind points and lines.
  const Outcome outcome = folder.run({"explain", meshes_folder + "notch_q2_22b.msh", "--element", "1"});
  CHECK(outcome.code == 2);
}

TEST_CASE("reports are the same from run to run") {
  const Folder folder;
  std::vector<std::string> arguments = {"check", "--format=jsonl"};
  for (const auto& entry : std::filesystem::directory_iterator(elements_folder))
    arguments.push_back(entry.path());
  std::sort(arguments.begin() + 2, arguments.end());
  arguments.push_back(meshes_folder + "aerofoil_p6_22a.msh");
  const std::string first = folder.run(arguments).out;
  const std::string second = folder.run(arguments).out;
  CHECK(parse_report(first).size() > 100);
  CHECK(without_seconds(first) == without_seconds(second));
  // Nothing but "seconds" is left out of the comparison.
  CHECK(without_seconds("{\"a\":1,\"seconds\":0.25,\"b\":2}") == "{\"a\":1,\"seconds\":0,\"b\":2}");
  arguments[1] = "--format=text";
  CHECK(folder.run(arguments).out == folder.run(arguments).out);
}

}  // namespace bezcert::test
