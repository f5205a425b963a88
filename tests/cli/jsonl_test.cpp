// The JSON Lines report: keys as designed, numbers exact, witnesses and bounds that hold.
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "exact_determinant.hpp"
#include "jsonl_report.hpp"
#include "program.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

const std::vector<std::string> criterion_names = {"control-net", "orientation", "cone", "coefficients",
                                                  "subdivision"};
const std::vector<std::string> verdict_names = {"injective", "overlapping", "degenerate", "folded",
                                                "reversed",  "undecided",   "regular"};

std::vector<std::string> all_files(const std::string& folder, const std::string& ending) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<MeshReport> report_on(const Folder& folder, const std::vector<std::string>& files,
                                  const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"check", "--format=jsonl"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), files.begin(), files.end());
  const Outcome outcome = folder.run(arguments);
  CHECK(outcome.err.empty());
  CHECK((outcome.code == 0 || outcome.code == 1 || outcome.code == 3));
  CHECK(folder.files().empty());  // no reproducer of a contradiction
  const auto reports = parse_report(outcome.out);
  REQUIRE(reports.size() == files.size());
  return reports;
}

void check_header(const MeshReport& report, const std::string& file, const Mesh& mesh) {
  CHECK(keys_of(report.header) ==
        std::vector<std::string>{"schema", "tool", "input", "sha256", "basis", "numbers"});
  CHECK(report.header["schema"] == "bezcert.report/1");
  CHECK(report.header["tool"].get<std::string>().starts_with("bezcert "));
  CHECK(report.header["input"] == file);
  CHECK(report.header["sha256"] == sha256(read_file(file)));
  CHECK(report.header["basis"] == mesh.origin().basis_name);
  CHECK(report.header["numbers"] == (mesh.origin().numbers == Numbers::decimal ? "decimal" : "binary64"));
}

// docs/report.md: `name` if the file names it, `zero` if degenerate, `overlap` if overlapping, `open` if
// undecided or regular.
void check_keys(const Json& element, bool named) {
  const std::string verdict = element["verdict"];
  std::vector<std::string> expected = {"element", "line"};
  if (named) expected.push_back("name");
  for (const std::string key : {"kind", "degree", "rational", "verdict", "min_det", "witness"})
    expected.push_back(key);
  if (verdict == "degenerate") expected.push_back("zero");
  if (verdict == "overlapping") expected.push_back("overlap");
  if (verdict == "undecided" || verdict == "regular") expected.push_back("open");
  for (const std::string key : {"criteria", "agreement"}) expected.push_back(key);
  REQUIRE(keys_of(element) == expected);
  REQUIRE(keys_of(element["min_det"]) == std::vector<std::string>{"lower", "upper"});
  if (!element["witness"].is_null())
    REQUIRE(keys_of(element["witness"]) ==
            std::vector<std::string>{"parameter", "det", "place", "place_decimal"});
}

// What the file says of an element.
void check_identity(const Json& object, const Mesh& mesh, std::size_t i, const Element& element) {
  const MeshElement& entry = mesh.elements()[i];
  CHECK(object["element"] == mesh.origin().number(i));
  const std::uint32_t line = mesh.origin().line(i);
  CHECK(object["line"] == (line > 0 ? Json(line) : Json(nullptr)));
  CHECK(object["rational"] == element.rational());
  if (element.is_triangle()) {
    CHECK(object["kind"] == "triangle");
    CHECK(object["degree"] == entry.shape.degree(0));
  } else {
    CHECK(object["kind"] == "quadrilateral");
    CHECK(object["degree"] == Json({entry.shape.degree(0), entry.shape.degree(1)}));
  }
  if (object.contains("name")) CHECK(object["name"] == std::string(mesh.origin().name(i)));
}

bool in_domain(const Element& element, const Values& parameter) {
  if (parameter.size() != (element.is_triangle() ? 3U : 2U)) return false;
  Rational sum = 0;
  for (const Rational& value : parameter) {
    if (value < 0 || value > 1) return false;
    sum += value;
  }
  return !element.is_triangle() || sum == 1;
}

Values random_parameter(const Element& element, Random& random) {
  if (!element.is_triangle()) return {random.rational(0, 1, 12), random.rational(0, 1, 12)};
  const long a = random.integer(0, 12);
  const long b = random.integer(0, 12 - a);
  return {Rational(12 - a - b, 12), Rational(a, 12), Rational(b, 12)};
}

// A coordinate of a zero: [lower, upper], with opposite signs of its polynomial at the ends unless it is
// exact.
std::pair<Rational, Rational> interval_of(const Json& coordinate) {
  if (coordinate.is_string()) return {rational_of(coordinate), rational_of(coordinate)};
  const Rational lower = rational_of(coordinate["lower"]), upper = rational_of(coordinate["upper"]);
  REQUIRE(lower < upper);
  if (coordinate.contains("polynomial")) {
    Rational at_lower = 0, at_upper = 0, power_lower = 1, power_upper = 1;
    for (const Json& c : coordinate["polynomial"]) {
      at_lower += rational_of(c) * power_lower;
      at_upper += rational_of(c) * power_upper;
      power_lower *= lower;
      power_upper *= upper;
    }
    REQUIRE(at_lower.sign() * at_upper.sign() == -1);
  }
  return {lower, upper};
}

// The zero of a degenerate element: exact, or so near that det J is tiny there.
void check_zero(const Json& object, const Element& element) {
  const Json& zero = object["zero"];
  REQUIRE(keys_of(zero) == std::vector<std::string>{"u", "v", "dimension"});
  REQUIRE((zero["dimension"] == 0 || zero["dimension"] == 1 || zero["dimension"] == 2));
  const auto [u_low, u_high] = interval_of(zero["u"]);
  const auto [v_low, v_high] = interval_of(zero["v"]);
  const Rational u = (u_low + u_high) / 2, v = (v_low + v_high) / 2;
  const Values parameter = element.is_triangle() ? Values{1 - u - v, u, v} : Values{u, v};
  const Rational det = exact_determinant(element, parameter);
  if (u_low == u_high && v_low == v_high) {
    REQUIRE(det == 0);
  } else {
    // The intervals are 2^-40 wide and det J >= 0 has a double zero: its size is that of curvature times
    // 2^-80.
    REQUIRE(abs(det) < Rational(1, Integer(1) << 50));
  }
}

// The verdict's evidence against det J evaluated independently.
void check_evidence(const Json& object, const Element& element, Random& random) {
  const std::string verdict = object["verdict"];
  const Rational lower = rational_of(object["min_det"]["lower"]);
  const Rational upper = rational_of(object["min_det"]["upper"]);
  REQUIRE(lower <= upper);
  // Of a degenerate element the zero may be irrational, and there is no other witness.
  const bool rational_zero =
      verdict == "degenerate" && object["zero"]["u"].is_string() && object["zero"]["v"].is_string();
  const bool needs_witness = verdict == "folded" || verdict == "reversed" || rational_zero;
  if (needs_witness) REQUIRE(!object["witness"].is_null());
  if (verdict == "injective" || verdict == "regular" || verdict == "overlapping")
    REQUIRE(object["witness"].is_null());
  if (!object["witness"].is_null()) {
    Values parameter;
    for (const Json& value : object["witness"]["parameter"]) parameter.push_back(rational_of(value));
    const Rational det = rational_of(object["witness"]["det"]);
    REQUIRE(in_domain(element, parameter));
    REQUIRE(exact_determinant(element, parameter) == det);
    const DualPoint place = exact_map(element, parameter);
    REQUIRE(object["witness"]["place"] == Json({to_string(place.x.value), to_string(place.y.value)}));
    REQUIRE(object["witness"]["place_decimal"] ==
            Json({to_decimal(place.x.value), to_decimal(place.y.value)}));
    REQUIRE(lower <= det);
    REQUIRE(det <= 0);
    REQUIRE((verdict == "degenerate") == (det == 0 && verdict != "undecided"));
  }
  if (verdict == "degenerate") check_zero(object, element);
  // Elsewhere: never below the bound, and of the sign that the verdict says.
  for (int round = 0; round < 6; ++round) {
    const Values parameter = random_parameter(element, random);
    const Rational det = exact_determinant(element, parameter);
    INFO("det J = " << det << " at a random parameter");
    REQUIRE(lower <= det);
    if (verdict == "reversed") REQUIRE(det < 0);
    if (verdict == "degenerate") REQUIRE(det >= 0);
    if (verdict == "injective" || verdict == "regular" || verdict == "overlapping") REQUIRE(det > 0);
  }
}

// The cross-check as the design defines it, again from what the report says.
void check_agreement(const Json& object) {
  const std::string verdict = object["verdict"];
  const bool regular = verdict == "injective" || verdict == "regular" || verdict == "overlapping";
  const bool bad = verdict == "folded" || verdict == "reversed" || verdict == "degenerate" ||
                   (verdict == "undecided" && !object["witness"].is_null());
  std::string expected = "consistent";
  for (const auto& item : object["criteria"].items()) {
    const bool claims_regular = item.key() != "orientation" && item.key() != "cone";
    const bool proved = claims_regular ? regular : verdict == "injective";
    const bool refuted = bad || (!claims_regular && verdict == "overlapping");
    const std::string status = item.value();
    REQUIRE((status == "proved" || status == "refuted" || status == "inconclusive" ||
             status == "not_applicable"));
    if ((status == "proved" && refuted) || (status == "refuted" && proved)) {
      expected = "contradiction";
    } else if (status == "inconclusive" && proved && expected == "consistent") {
      expected = "strength_gap";
    }
  }
  CHECK(object["agreement"] == expected);
}

void check_summary(const MeshReport& report, const Mesh& mesh) {
  const Json& summary = report.summary;
  for (const std::string key : {"elements", "verdicts", "contradictions", "criteria", "mesh", "seconds"}) {
    INFO(key);
    REQUIRE(summary.contains(key));
  }
  CHECK(summary["elements"] == report.elements.size());
  std::map<std::string, std::size_t> verdicts;
  std::map<std::string, std::map<std::string, std::size_t>> statuses;
  std::size_t invalid = 0;
  for (const Json& element : report.elements) {
    ++verdicts[element["verdict"]];
    invalid += !element["witness"].is_null() || element["verdict"] == "overlapping" ||
               element["verdict"] == "degenerate";
    for (const auto& item : element["criteria"].items()) ++statuses[item.key()][item.value()];
  }
  std::size_t sum = 0;
  for (const std::string& name : verdict_names) {
    INFO(name);
    CHECK(summary["verdicts"].value(name, std::size_t{0}) == verdicts[name]);
    sum += verdicts[name];
  }
  CHECK(sum == report.elements.size());  // no verdict beyond the list
  for (const auto& [name, counts] : statuses) {
    for (const auto& [status, count] : counts) CHECK(summary["criteria"][name][status] == count);
  }
  CHECK(keys_of(summary["mesh"]) ==
        std::vector<std::string>{"verdict", "obstacles", "components", "loops", "holes", "area"});
  CHECK(summary["mesh"]["obstacles"].is_array());
  if (invalid > 0) {
    CHECK(summary["mesh"]["verdict"] != "embedding");
    CHECK(!summary["mesh"]["obstacles"].empty());
  }
  CHECK(summary["seconds"].is_number());
  CHECK(summary["seconds"].get<double>() >= 0);
  if (summary.contains("ignored")) CHECK(summary["ignored"]["lines"] == mesh.origin().ignored.lines);
}

struct Counts {
  std::size_t elements = 0;
  std::size_t witnesses = 0;
  std::set<std::string> verdicts;
};

Counts check_reports(const std::vector<std::string>& files, const std::vector<MeshReport>& reports,
                     std::uint64_t seed) {
  INFO("seed " << seed);
  Random random(seed);
  Counts counts;
  for (std::size_t f = 0; f < files.size(); ++f) {
    INFO(files[f]);
    const Mesh mesh = read_mesh(files[f], read_file(files[f]));
    check_header(reports[f], files[f], mesh);
    REQUIRE(reports[f].elements.size() == mesh.elements().size());
    for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
      const Json& object = reports[f].elements[i];
      INFO("element in place " << i << ": " << object.dump());
      const Element element = mesh.element(i);
      check_keys(object, !mesh.origin().name(i).empty());
      check_identity(object, mesh, i, element);
      check_evidence(object, element, random);
      check_agreement(object);
      REQUIRE(keys_of(object["criteria"]) == criterion_names);
      ++counts.elements;
      counts.witnesses += !object["witness"].is_null();
      counts.verdicts.insert(object["verdict"].get<std::string>());
    }
    check_summary(reports[f], mesh);
  }
  return counts;
}

}  // namespace

TEST_CASE("reports on the corpus elements have the designed keys and evidence that holds") {
  const Folder folder;
  const auto files = all_files(elements_folder, ".bez.json");
  REQUIRE(files.size() > 100);
  const Counts counts = check_reports(files, report_on(folder, files), seed_or(4711));
  CHECK(counts.elements == files.size());
  CHECK(counts.witnesses > 30);
  for (const std::string verdict : {"injective", "degenerate", "folded", "reversed"}) {
    INFO(verdict);
    CHECK(counts.verdicts.count(verdict) == 1);
  }
}

TEST_CASE("reports on gmsh meshes have the designed keys and evidence that holds") {
  const Folder folder;
  std::vector<std::string> files;
  for (const std::string name : {"crescent_p3_22a", "crescent_p3_22b", "crescent_p3_mirrored_22a",
                                 "classes_22a", "annulus_q3_turned_41a", "notch_q2_22b", "quarter_point_22a",
                                 "fan_p1234_22a", "slab_p2_41a", "crescent_mixed_p4_41b"}) {
    files.push_back(meshes_folder + name + ".msh");
  }
  const Counts counts = check_reports(files, report_on(folder, files), seed_or(4712));
  // expected.tsv: 14 + 14 + 14 + 17 + 8 + 9 + 8 + 8 + 6 + 13 elements, of which 2 + 2 + 14 + 14 + 4 + 1 + 8 +
  // 0 + 0 + 1 are folded, reversed or degenerate.
  CHECK(counts.elements == 111);
  CHECK(counts.witnesses == 46);
  CHECK(counts.verdicts.count("injective") == 1);
}

TEST_CASE("classes and least determinants of gmsh meshes agree with the oracle") {
  const Folder folder;
  const auto files = all_files(meshes_folder, ".msh");
  REQUIRE(files.size() == 45);
  const auto reports = report_on(folder, files, {"--criteria=none"});
  // file -> element -> class, least sample of det J, proven lower bound; others are positive.
  struct Bad {
    std::string verdict;
    double sample = 0;
    double bound = 0;
  };
  std::map<std::string, std::map<std::uint64_t, Bad>> expected;
  std::istringstream table(bytes_of(meshes_folder + "expected_bad.tsv"));
  std::string line;
  std::getline(table, line);
  std::size_t rows = 0;
  for (; std::getline(table, line); ++rows) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    REQUIRE(row.size() == 7);
    expected[row[0]][std::stoul(row[1])] = {row[2], std::stod(row[3]), std::stod(row[6])};
  }
  std::size_t elements = 0, bad = 0;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string name = std::filesystem::path(files[f]).filename();
    for (const Json& object : reports[f].elements) {
      INFO(name << ": " << object.dump());
      ++elements;
      const std::string verdict = object["verdict"];
      const auto found = expected[name].find(object["element"].get<std::uint64_t>());
      if (found == expected[name].end()) {
        CHECK((verdict == "injective" || verdict == "regular" || verdict == "overlapping"));
        continue;
      }
      ++bad;
      CHECK(verdict == found->second.verdict);
      // The table's numbers are rounded to doubles.
      const Rational slack = Rational(std::abs(found->second.bound)) / 1000000000;
      CHECK(rational_of(object["min_det"]["lower"]) <= Rational(found->second.sample) + slack);
      CHECK(rational_of(object["min_det"]["upper"]) >= Rational(found->second.bound) - slack);
    }
  }
  CHECK(elements == 1093);
  CHECK(bad == rows);
  CHECK(rows == 99);
}

TEST_CASE("only the chosen criteria are run") {
  const Folder folder;
  const std::vector<std::string> file = {meshes_folder + "crescent_p3_22a.msh"};
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"all", criterion_names},
      {"none", {}},
      {"cone", {"cone"}},
      {"subdivision,control-net", {"subdivision", "control-net"}},
      {"orientation,orientation", {"orientation"}},
      {"coefficients,cone,orientation,control-net,subdivision", criterion_names}};
  std::vector<std::string> verdicts;
  for (const auto& [list, names] : cases) {
    INFO("--criteria=" << list);
    const auto report = report_on(folder, file, {"--criteria=" + list}).at(0);
    const std::set<std::string> expected(names.begin(), names.end());
    std::string all;
    for (const Json& element : report.elements) {
      const auto keys = keys_of(element["criteria"]);
      CHECK(keys.size() == expected.size());
      CHECK(std::set<std::string>(keys.begin(), keys.end()) == expected);
      CHECK(element["criteria"].is_object());
      if (expected.empty()) CHECK(element["agreement"] == "consistent");
      all += element["verdict"].get<std::string>() + element["witness"].dump() + " ";
    }
    const auto counted = keys_of(report.summary["criteria"]);
    CHECK(std::set<std::string>(counted.begin(), counted.end()) == expected);
    verdicts.push_back(all);
  }
  // The decision does not depend on them.
  CHECK(verdicts.size() == 6);
  for (const std::string& one : verdicts) CHECK(one == verdicts.front());
}

TEST_CASE("names and paths of any bytes give valid JSON") {
  const Folder folder;
  const std::string mesh = folder.write("m\xff \xe9\".msh", trap_mesh);
  const std::string named = folder.write(
      "named.bez.json",
      R"({"bezcert":1,"elements":[{"name":"a\n\"b\" \u0001é","kind":"triangle","degree":1,"points":[[0,0],[1,0],[0,1]]}]})");
  const Outcome outcome = folder.run({"check", mesh, named, "--format=jsonl"});
  CHECK(outcome.code == 1);
  CHECK(outcome.err.empty());
  const auto reports = parse_report(outcome.out);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].elements[0]["verdict"] == "folded");
  CHECK(reports[1].elements[0]["name"] == "a\n\"b\" \x01\xc3\xa9");
}

}  // namespace bezcert::test
