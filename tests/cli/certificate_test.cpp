// Certificates as a user makes and checks them: every verdict of the corpus is claimed with evidence that
// verifier accepts, of the same elements whatever the file format; and what the options refuse.
#include "jsonl_report.hpp"

#include <algorithm>
#include <map>
#include <set>

using namespace bezcert::test;

namespace {

// What a certificate claims: the words after the positions, and the mesh's.
struct Claims {
  std::vector<std::string> elements;
  std::string mesh;
};

Claims claims_of(const std::string& certificate) {
  Claims claims;
  bool counted = false;
  for (const std::string& line : lines_of(certificate)) {
    std::istringstream words(line);
    std::string first, second;
    words >> first >> second;
    if (first == "mesh") {
      claims.mesh = second;
      break;
    }
    if (counted) claims.elements.push_back(second);
    counted = counted || first == "count";
  }
  return claims;
}

// The mesh verdicts that only say by size that something is wrong have no other name in a certificate.
std::string claimed_mesh(const std::string& verdict) {
  return verdict == "embedding" || verdict == "undecided" ? verdict : "refuted";
}

// certify writes a certificate that claims what its report says; verifier accepts it.
void require_certified(const Folder& folder, const std::string& mesh, const std::vector<std::string>& options,
                       std::map<std::string, std::size_t>& seen) {
  INFO(mesh << joined(options));
  std::vector<std::string> arguments = {"check", "--format=jsonl", "--criteria=none", "--certificate=c.cert",
                                        mesh};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = folder.run(arguments);
  REQUIRE(outcome.code < 2);
  CHECK(outcome.err.empty());
  const MeshReport report = parse_report(outcome.out).at(0);
  const Claims claims = claims_of(bytes_of(folder / "c.cert"));
  REQUIRE(claims.elements.size() == report.elements.size());
  for (std::size_t i = 0; i < claims.elements.size(); ++i) {
    CHECK(claims.elements[i] == report.elements[i]["verdict"].get<std::string>());
    ++seen[claims.elements[i]];
  }
  CHECK(claims.mesh == claimed_mesh(report.summary["mesh"]["verdict"].get<std::string>()));
  ++seen["mesh " + claims.mesh];

  const bool own_file = std::find(options.begin(), options.end(), "--elements=e.bez.json") != options.end();
  const Outcome verified = folder.verify(own_file ? folder / "e.bez.json" : mesh, "c.cert");
  INFO("verifier: " << verified.out << verified.err);
  CHECK(verified.code == 0);
}

std::vector<std::string> files_in(const std::string& folder, const std::string& ending) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string path = entry.path();
    if (path.ends_with(ending) && entry.path().filename().string().rfind("curves-", 0) != 0) {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_binary(const std::string& mesh) {
  const std::string stem = mesh.substr(0, mesh.rfind('.'));
  return stem.back() == 'b';  // corpus/README.md: the last letters tell version and mode
}

}  // namespace

TEST_CASE("every element of the corpus gets a certificate that is accepted") {
  const Folder folder;
  std::map<std::string, std::size_t> seen;
  for (const std::string& file : files_in(elements_folder, ".bez.json"))
    require_certified(folder, file, {}, seen);
  // As many of each kind as the files expect of themselves (corpus/make_elements.py).
  CHECK(seen["injective"] == 95);
  CHECK(seen["folded"] == 84);
  CHECK(seen["degenerate"] == 75);
  CHECK(seen["overlapping"] == 17);
  CHECK(seen["reversed"] == 10);
  CHECK(seen["regular"] + seen["undecided"] + seen["invalid"] == 0);
}

TEST_CASE("every whole mesh of the corpus gets a certificate that is accepted") {
  const Folder folder;
  std::map<std::string, std::size_t> seen;
  for (const std::string& file : files_in(BEZCERT_SOURCE_DIR "/corpus/whole/", ".bez.json"))
    require_certified(folder, file, {}, seen);
  // corpus/whole/expected.tsv: 43 embeddings, 71 others, none open.
  CHECK(seen["mesh embedding"] == 43);
  CHECK(seen["mesh refuted"] == 71);
  CHECK(seen["mesh undecided"] == 0);
}

TEST_CASE("every gmsh mesh of the corpus gets a certificate that verifier accepts, reading it itself") {
  const Folder folder;
  std::map<std::string, std::size_t> seen;
  std::size_t ascii = 0;
  for (const std::string& file : files_in(meshes_folder, ".msh")) {
    require_certified(folder, file, {"--elements=e.bez.json"}, seen);
    if (is_binary(file)) continue;
    ++ascii;
    require_certified(folder, file, {}, seen);
    require_certified(folder, file, {"--numbers=decimal"}, seen);
  }
  CHECK(ascii == 26);
  CHECK(seen["mesh embedding"] > 0);
}

TEST_CASE("a certificate is about one reading of one file") {
  const Folder folder;
  folder.write("trap.msh", trap_mesh);
  REQUIRE(folder.run({"check", "trap.msh", "--certificate=nodes.cert"}).code == 1);
  REQUIRE(folder.run({"check", "trap.msh", "--basis=bernstein", "--certificate=points.cert"}).code == 0);
  CHECK(folder.verify("trap.msh", "nodes.cert").code == 0);
  CHECK(folder.verify("trap.msh", "points.cert").code == 0);
  // One says folded, the other injective: exchanging their words is caught.
  std::string swapped = bytes_of(folder / "points.cert");
  const std::size_t at = swapped.find("basis bernstein");
  REQUIRE(at != std::string::npos);
  swapped.replace(at, 15, "basis lagrange");
  folder.write("swapped.cert", swapped);
  CHECK(folder.verify("trap.msh", "swapped.cert").code == 1);
  // Another file, although it differs by one blank only.
  std::string other = trap_mesh;
  other.insert(other.size() - 1, " ");
  folder.write("other.msh", other);
  CHECK(folder.verify("other.msh", "nodes.cert").code == 1);
}

TEST_CASE("the elements file holds the same mesh exactly") {
  const Folder folder;
  const std::string mesh = meshes_folder + "plate_mixed_p3_41a.msh";
  REQUIRE(folder.run({"check", mesh, "--elements=e.bez.json", "--format=jsonl", "-o", "a.jsonl"}).code < 2);
  REQUIRE(folder.run({"check", "e.bez.json", "--format=jsonl", "-o", "b.jsonl"}).code < 2);
  const MeshReport a = parse_report(bytes_of(folder / "a.jsonl")).at(0);
  const MeshReport b = parse_report(bytes_of(folder / "b.jsonl")).at(0);
  REQUIRE(a.elements.size() == b.elements.size());
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    for (const char* key : {"kind", "degree", "rational", "verdict", "min_det", "witness"}) {
      CHECK(a.elements[i][key] == b.elements[i][key]);
    }
  }
  CHECK(a.summary["mesh"]["verdict"] == b.summary["mesh"]["verdict"]);
  CHECK(a.summary["mesh"]["area"] == b.summary["mesh"]["area"]);
  // Written again from itself it is the same file.
  REQUIRE(folder.run({"check", "e.bez.json", "--elements=f.bez.json"}).code < 2);
  CHECK(bytes_of(folder / "e.bez.json") == bytes_of(folder / "f.bez.json"));
}

TEST_CASE("what --certificate and --elements refuse leaves no file") {
  const Folder folder;
  folder.write("a.msh", trap_mesh);
  folder.write("b.msh", trap_mesh);
  require_refused(folder, {"check", "a.msh", "b.msh", "--certificate=c"}, "one MESH");
  require_refused(folder, {"check", "a.msh", "b.msh", "--elements=c"}, "one MESH");
  require_refused(folder, {"check", "a.msh", "--certificate=a.msh"}, "is an input");
  require_refused(folder, {"check", "a.msh", "--elements=./a.msh"}, "is an input");
  require_refused(folder, {"check", "a.msh", "--certificate=c", "--elements=c"}, "given twice");
  require_refused(folder, {"check", "a.msh", "--certificate=c", "--elements=./c"}, "given twice");
  require_refused(folder, {"check", "a.msh", "--certificate=c", "-o", "c"}, "given twice");
  require_refused(folder, {"check", meshes_folder + "plate_p4_22b.msh", "--certificate=c"},
                  "--elements=FILE");
  require_refused(folder, {"check", "missing.msh", "--certificate=c"}, "missing.msh");
  CHECK(folder.files() == std::vector<std::string>{"a.msh", "b.msh"});
  CHECK(bytes_of(folder / "a.msh") == trap_mesh);
}

TEST_CASE("cracks and elements that are very thin get their evidence all the same") {
  const Folder folder;
  // Found by a search from outside: a common edge whose middle points differ by 1e-20, and a triangle of
  // height 1e-155. Both verdicts follow from the coordinates.
  folder.write("crack.bez.json",
               R"({"bezcert": 1, "elements": [{"kind": "triangle", "degree": 2, "points": [
 ["2663/2500", "41/2000"], ["6279/4000", "889/20000"], ["20471/10000", "-7/1250"], ["6257/4000", "2199/4000"],
 ["19754000001/10000000000", "2703/5000"], ["3971/2000", "622/625"]]}, {"kind": "triangle", "degree": 2, "points": [
 ["2663/2500", "41/2000"], ["156425000000000000001/100000000000000000000", "2199/4000"], ["3971/2000", "622/625"],
 ["19197/20000", "2563/5000"], ["151/100", "18897/20000"], ["2061/2000", "9613/10000"]]}]}
)");
  folder.write("thin.bez.json", R"({"bezcert": 1, "elements": [{"kind": "triangle", "degree": 1, "points": [
 [0, 0], [1, 0], ["1/2", "1e-155"]]}]}
)");
  std::map<std::string, std::size_t> seen;
  require_certified(folder, folder / "crack.bez.json", {}, seen);
  require_certified(folder, folder / "thin.bez.json", {}, seen);
  CHECK(seen["injective"] == 3);
  CHECK(seen["mesh refuted"] == 1);
  CHECK(seen["mesh embedding"] == 1);
}
