// Checks one file of the corpus against what its derivation says: `corpus_check element|mesh|whole CORPUS
// FILE`.
//
// Elements: the verdict in the file and the criteria's statuses in criteria.tsv (both made by
// corpus/make_elements.py, exact arithmetic in Python). Meshes: the counts and the bad elements in
// meshes/expected*.tsv (made by corpus/mesh_oracle.py). Prints what differs; exit code 0 or 1.
#include "bezcert/criterion/subdivision.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/curve/bez_json.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/surface/domain.hpp"
#include "bezcert/surface/embedding.hpp"
#include "bezcert/number/parse.hpp"
#include "bezcert/check/cross_check.hpp"

#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

using namespace bezcert;

namespace {

int failures = 0;

void expect(bool holds, const std::string& what) {
  if (holds) return;
  std::cout << "differs: " << what << '\n';
  ++failures;
}

using Row = std::map<std::string, std::string>;

std::vector<Row> read_table(const std::string& path) {
  std::ifstream stream(path);
  std::string line;
  std::vector<std::string> header;
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    std::vector<std::string> cells;
    std::istringstream cut(line);
    for (std::string cell; std::getline(cut, cell, '\t');) cells.push_back(cell);
    if (header.empty()) {
      header = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[header[i]] = cells[i];
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error(path + " is missing or empty");
  return rows;
}

std::set<std::string> read_names(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error(path + " is missing");
  std::set<std::string> names;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string name;
    if (words >> name) names.insert(name);
  }
  return names;
}

// zeros.tsv: the dimension of the zero set of det J; where it is finite, all zeros to 12 decimals.
void check_zero(const std::string& corpus, const std::string& name,
                const std::optional<AlgebraicZero>& zero) {
  expect(zero.has_value(), "a degenerate element shows its zero");
  if (!zero) return;
  for (const Row& row : read_table(corpus + "/zeros.tsv")) {
    if (row.at("element") != name) continue;
    const std::string dimension = std::to_string(zero->dimension);
    expect(dimension == row.at("dimension"),
           "the zeros have dimension " + dimension + ", expected " + row.at("dimension"));
    if (row.at("dimension") != "0") return;
    const Rational tolerance(Integer(1), Integer(1) << 36);
    std::istringstream list(row.at("zeros"));
    for (std::string pair; std::getline(list, pair, ';');) {
      const std::size_t comma = pair.find(',');
      const Rational u = *parse_decimal(pair.substr(0, comma)), v = *parse_decimal(pair.substr(comma + 1));
      if (abs(u - zero->at.u.lower) < tolerance && abs(u - zero->at.u.upper) < tolerance &&
          abs(v - zero->at.v.lower) < tolerance && abs(v - zero->at.v.upper) < tolerance) {
        return;
      }
    }
    expect(false, "the zero is none of " + row.at("zeros"));
    return;
  }
  expect(false, "zeros.tsv has no row for the element");
}

void check_element(const std::string& corpus, const std::string& file) {
  const std::string path = corpus + "/" + file;
  const Mesh mesh = read_mesh(path, read_file(path));
  expect(mesh.elements().size() == 1, "one element a file");
  const std::string name(mesh.origin().name(0));
  const std::string expected(mesh.origin().expected(0));
  expect(!expected.empty(), "the file has an expected verdict");

  const Element element = mesh.element(0);
  const CheckedElement checked = check_element(element, all_criteria(), {});
  const std::string verdict(bezcert::name(checked.decision.verdict));
  expect(verdict == expected, "the verdict is " + verdict + ", expected " + expected);
  const bool beyond = read_names(corpus + "/beyond_subdivision.txt").contains(name);
  Budget no_algebra;
  no_algebra.algebra_bits = 0;
  const Decision by_subdivision = decide(Forms(element), no_algebra);
  const std::string without(bezcert::name(by_subdivision.verdict));
  if (!beyond) {
    expect(without == expected, "without algebra the verdict is " + without + ": beyond subdivision");
  } else if (expected == "degenerate") {
    expect(without == "undecided",
           "without algebra the verdict is " + without + ": bisection should not end");
  }

  const Forms exact_only(element, Filter::off);
  const Decision unfiltered = decide(exact_only);
  expect(unfiltered.verdict == checked.decision.verdict,
         "the verdict without filter is " + std::string(bezcert::name(unfiltered.verdict)));

  if (verdict == "degenerate") check_zero(corpus, name, checked.decision.zero);

  std::map<std::string, std::string> statuses;
  for (const Row& row : read_table(corpus + "/criteria.tsv")) {
    if (row.at("element") == name) statuses[row.at("criterion")] = row.at("status");
  }
  expect(statuses.size() == 4, "criteria.tsv has four rows for the element");
  for (const CheckedCriterion& one : checked.criteria) {
    const std::string status(bezcert::name(one.verdict.status));
    const std::string criterion(one.criterion->name);
    if (statuses.contains(criterion)) {
      expect(status == statuses[criterion],
             criterion + " is " + status + ", expected " + statuses[criterion]);
    } else {
      // subdivision: proves what is regular, if its budget lasts; what is not, it never proves.
      const bool regular = expected == "injective" || expected == "overlapping";
      const bool long_way = beyond || by_subdivision.pieces > SubdivisionOptions{}.pieces / 2;
      expect((status == "proved") == regular || (long_way && status == "inconclusive"),
             criterion + " is " + status + " for " + expected);
    }
    expect(!one.is_defect(), criterion + " contradicts the decision");
  }
}

void check_mesh(const std::string& corpus, const std::string& file) {
  const std::string path = corpus + "/" + file;
  const std::string base = file.substr(file.find('/') + 1);
  const Mesh mesh = read_mesh(path, read_file(path));
  std::map<std::string, std::size_t> seen;
  std::map<std::string, std::pair<std::string, DeterminantBounds>> bad;
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    const CheckedElement checked = check_element(mesh.element(i), all_criteria(), {});
    const ElementVerdict verdict = checked.decision.verdict;
    ++seen["elements"];
    ++seen[mesh.elements()[i].shape.domain == Domain::triangle ? "triangles" : "quadrilaterals"];
    const std::string word(is_regular(verdict) ? "positive" : name(verdict));
    ++seen[word];
    if (word != "positive") bad[std::to_string(mesh.origin().number(i))] = {word, checked.decision.bounds};
    for (const auto& one : checked.criteria)
      expect(!one.is_defect(), std::string(one.criterion->name) + " contradicts");
  }
  seen["ignored_points"] = mesh.origin().ignored.points;
  seen["ignored_lines"] = mesh.origin().ignored.lines;
  seen["ignored_volumes"] = mesh.origin().ignored.volumes;

  bool listed = false;
  for (const Row& row : read_table(corpus + "/meshes/expected.tsv")) {
    if (row.at("file") != base) continue;
    listed = true;
    for (const auto& [column, value] : row) {
      if (column == "file") continue;
      expect(seen[column] == std::stoul(value),
             column + " is " + std::to_string(seen[column]) + ", expected " + value);
    }
  }
  expect(listed, "expected.tsv has a row for the mesh");
  std::size_t bad_listed = 0;
  for (const Row& row : read_table(corpus + "/meshes/expected_bad.tsv")) {
    if (row.at("file") != base) continue;
    ++bad_listed;
    const auto& [word, bounds] = bad[row.at("element")];
    expect(word == row.at("class"),
           "element " + row.at("element") + " is " + word + ", expected " + row.at("class"));
    // The oracle's minimum is a decimal close to the true one (1e-12 relative): it must not lie below our
    // bound.
    const Rational minimum(std::stod(row.at("det_min")));
    const Rational slack = abs(minimum) / 1000000 + Rational(1, Integer(1) << 60);
    expect(to_rational(bounds.min_lower) <= minimum + slack,
           "element " + row.at("element") + ": min_det lower bound too high");
  }
  expect(bad_listed == bad.size(), "expected_bad.tsv lists " + std::to_string(bad_listed) +
                                       " elements, found " + std::to_string(bad.size()));
}

// "1;5" as a set.
std::set<std::string> listed(const std::string& text) {
  std::set<std::string> result;
  std::istringstream cut(text);
  for (std::string one; std::getline(cut, one, ';');) result.insert(one);
  return result;
}

std::string cell(const Row& row, const std::string& column) {
  return row.contains(column) ? row.at(column) : "";
}

// Whole meshes: whole/expected.tsv and whole/domain.tsv (made by corpus/make_whole.py).
void check_whole(const std::string& corpus, const std::string& file) {
  const std::string path = corpus + "/" + file;
  const std::string base = file.substr(file.find('/') + 1);
  const Mesh mesh = read_mesh(path, read_file(path));
  std::vector<ElementState> states;
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    states.push_back(state_of(decide(mesh.element(i))));
  }
  const MeshResult result = examine_mesh(mesh, states);
  bool found = false;
  for (const Row& row : read_table(corpus + "/whole/expected.tsv")) {
    if (row.at("file") != base) continue;
    found = true;
    const std::string verdict(bezcert::name(result.verdict));
    expect(verdict == row.at("verdict"), "the verdict is " + verdict + ", expected " + row.at("verdict"));
    const auto compare = [&](const std::string& column, const std::string& value) {
      if (!cell(row, column).empty())
        expect(value == row.at(column), column + " is " + value + ", expected " + row.at(column));
    };
    compare("components", std::to_string(result.components));
    compare("loops", result.loops ? std::to_string(*result.loops) : "unknown");
    compare("holes", result.holes ? std::to_string(*result.holes) : "unknown");
    compare("area", result.area && result.area->is_exact() ? to_string(result.area->lower) : "unknown");
    std::set<std::string> elements, nodes;
    for (const MeshObstacle& obstacle : result.obstacles.all()) {
      if (obstacle.kind() != result.verdict) continue;
      for (const std::uint32_t i : obstacle.elements)
        elements.insert(std::to_string(mesh.origin().number(i)));
      for (const std::uint32_t i : obstacle.nodes) nodes.insert(std::to_string(i));
    }
    if (!cell(row, "obstacle_elements").empty()) {
      expect(elements == listed(row.at("obstacle_elements")),
             "the obstacle names other elements than " + row.at("obstacle_elements"));
    }
    if (!cell(row, "obstacle_nodes").empty()) {
      expect(nodes == listed(row.at("obstacle_nodes")),
             "the obstacle names other nodes than " + row.at("obstacle_nodes"));
    }
  }
  expect(found, "expected.tsv has a row for the mesh");
  for (const Row& row : read_table(corpus + "/whole/domain.tsv")) {
    if (row.at("mesh") != base) continue;
    const std::string curves_path = corpus + "/whole/" + row.at("curves");
    const DomainResult domain =
        check_domain(*result.surface, read_bez_json_curves(curves_path, read_file(curves_path)));
    const std::string verdict = domain.conforming() ? "conforming" : "not_conforming";
    expect(verdict == row.at("verdict"),
           row.at("curves") + ": " + verdict + ", expected " + row.at("verdict"));
    expect(
        std::to_string(domain.covered) == row.at("covered"),
        row.at("curves") + ": " + std::to_string(domain.covered) + " covered, expected " + row.at("covered"));
    std::set<std::string> failing;
    for (const DomainFailure& failure : domain.failures) failing.insert(std::to_string(failure.curve + 1));
    expect(failing == listed(cell(row, "not_covered")), row.at("curves") + ": other curves fail");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "corpus_check element|mesh|whole CORPUS FILE\n";
    return 2;
  }
  const std::string kind = argv[1];
  if (kind == "element") check_element(argv[2], argv[3]);
  if (kind == "mesh") check_mesh(argv[2], argv[3]);
  if (kind == "whole") check_whole(argv[2], argv[3]);
  if (failures == 0) std::cout << "as expected\n";
  return failures == 0 ? 0 : 1;
}
