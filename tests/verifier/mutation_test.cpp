// Certificates with one token changed. Those of the examples are accepted exactly if the oracle
// (oracle/check.py, exact fractions in Python) accepts them: mutants.tsv; those that certify writes for the
// corpus never claim what its exact decision denies.
#include "../cli/jsonl_report.hpp"
#include "checking.hpp"
#include "example_table.hpp"
#include "mutants.hpp"

#include <map>
#include <set>

namespace bezcert::test {
namespace {

using verifier::Claim;

// What is true of an elements file under a header, by certify's exact decision.
struct Truth {
  std::vector<std::string> verdicts;
  std::string mesh;
};

Truth truth_of(const Folder& folder, const std::string& path, const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {"check", "--format=jsonl", "--criteria=none", path};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = folder.run(arguments);
  INFO(path << joined(options) << outcome.err);
  REQUIRE(outcome.code < 2);
  const MeshReport report = parse_report(outcome.out).at(0);
  Truth truth;
  for (const auto& element : report.elements) truth.verdicts.push_back(element["verdict"]);
  truth.mesh = report.summary["mesh"]["verdict"];
  return truth;
}

bool holds(Claim claim, const std::string& verdict) {
  switch (claim) {
    case Claim::injective: return verdict == "injective";
    case Claim::regular: return verdict == "injective" || verdict == "overlapping" || verdict == "regular";
    case Claim::overlapping: return verdict == "overlapping";
    case Claim::degenerate: return verdict == "degenerate";
    case Claim::folded: return verdict == "folded";
    case Claim::reversed: return verdict == "reversed";
    case Claim::invalid: return verdict == "degenerate" || verdict == "folded" || verdict == "reversed";
    case Claim::undecided: return true;
  }
  return false;
}

bool holds(const std::string& mesh, const Truth& truth) {
  if (mesh == "undecided") return true;
  return mesh == "embedding" ? truth.mesh == "embedding" : truth.mesh != "embedding";
}

// Asserts that every claim is true.
void check_claims(const Judgement& judgement, const Truth& truth) {
  REQUIRE(judgement.claims.size() == truth.verdicts.size());
  for (std::size_t i = 0; i < judgement.claims.size(); ++i) {
    INFO("element " << i + 1 << " is " << truth.verdicts[i] << ", claim "
                    << static_cast<int>(judgement.claims[i]));
    CHECK(holds(judgement.claims[i], truth.verdicts[i]));
  }
  INFO("the mesh is " << truth.mesh << ", the claim " << judgement.mesh);
  CHECK(holds(judgement.mesh, truth));
}

std::string value_in(const std::string& certificate, const std::string& key) {
  const std::size_t at = certificate.find('\n' + key + ' ') + key.size() + 2;
  return certificate.substr(at, certificate.find('\n', at) - at);
}

std::vector<std::string> options_of(const std::string& certificate) {
  if (value_in(certificate, "basis") == "mixed") return {};
  return {"--basis=" + value_in(certificate, "basis"), "--numbers=" + value_in(certificate, "numbers")};
}

}  // namespace

TEST_CASE("mutants of the examples are accepted only where the oracle accepts them, and claim no falsehood") {
  std::set<std::string> valid;  // rows of mutants.tsv
  std::string counted;
  for (const std::string& row : lines_of(bytes_of(verifier_folder + "mutants.tsv"))) {
    if (row.starts_with("# mutants in all: ")) counted = row.substr(18);
    if (!row.starts_with('#')) REQUIRE(valid.insert(row).second);
  }
  const Folder folder;
  std::map<std::string, Truth> truths;
  std::map<std::string, std::size_t> all, accepted;
  std::size_t codes[3] = {0, 0, 0};
  std::set<std::string> found;
  for (const Example& example : examples()) {
    if (example.code != 0) continue;
    const std::string elements = bytes_of(example.elements_path());
    for_each_mutant(bytes_of(example.path()), [&](const Mutation& mutation, std::size_t line,
                                                  std::size_t token, const std::string& mutant) {
      const Judgement judgement = judge(elements, mutant);
      ++all[mutation.kind];
      ++codes[judgement.code];
      std::string row = example.certificate + '\t' + std::to_string(line) + '\t' + std::to_string(token) +
                        '\t' + (mutation.token.empty() ? "(dropped)" : mutation.token);
      const bool is_valid = valid.count(row) > 0;
      if ((judgement.code == 0) != is_valid) {
        INFO(row << "\noracle: " << (is_valid ? "accepted" : "refused") << "\nverifier: " << judgement.code
                 << ' ' << judgement.why);
        CHECK((judgement.code == 0) == is_valid);
      }
      if (judgement.code != 0) return;
      ++accepted[mutation.kind];
      found.insert(row);
      const std::vector<std::string> options = options_of(mutant);
      const std::string key = example.elements + joined(options);
      if (truths.count(key) == 0) truths[key] = truth_of(folder, example.elements_path(), options);
      INFO(row);
      check_claims(judgement, truths[key]);
    });
  }
  std::string text;
  for (const auto& [kind, count] : all)
    text += (text.empty() ? "" : ", ") + kind + ' ' + std::to_string(count);
  CHECK(text == counted);
  CHECK((found == valid));
  WARN("mutants: " << text << "; accepted " << codes[0] << ", rejected " << codes[1] << ", malformed "
                   << codes[2]);
  CHECK(codes[0] == valid.size());
  CHECK(codes[1] > 3 * codes[0]);
  CHECK(codes[2] > codes[0]);
  CHECK(accepted["hash"] == 0);
  CHECK(accepted["bits"] == 0);
  CHECK(accepted["token"] == 0);
}

// Certificates as certify writes them.
TEST_CASE("mutants of certify's certificates claim no falsehood") {
  const Folder folder;
  std::vector<std::string> meshes;
  for (const char* name : {"affine",
                           "corner-a-doubles",
                           "flat-corner",
                           "overlapping-corners",
                           "overlapping-edge-third",
                           "overlapping-quad",
                           "quad-arrow",
                           "quad-3x3-inner-point",
                           "quarter-disc",
                           "touching-corner",
                           "touching-parabola",
                           "zero-circle",
                           "zero-irrational",
                           "zero-third-quad",
                           "zero-acnode",
                           "zero-motzkin",
                           "clockwise-quadratic",
                           "trap-node",
                           "trap-control-point",
                           "rational-cubic-folded"})
    meshes.push_back(corpus_element(name));
  for (const char* name : {"edge-moebius", "good-disc-p2", "hanging-straight", "overlap-crossing",
                           "overlap-inside", "element-folded-p2", "edge-moved"})
    meshes.push_back(BEZCERT_SOURCE_DIR "/corpus/whole/" + std::string(name) + ".bez.json");
  std::size_t codes[3] = {0, 0, 0};
  for (const std::string& mesh : meshes) {
    INFO(mesh);
    const Outcome outcome = folder.run({"check", "--criteria=none", "--certificate=c.cert", mesh});
    REQUIRE(outcome.code < 2);
    const std::string elements = bytes_of(mesh), certificate = bytes_of(folder / "c.cert");
    const Truth truth = truth_of(folder, mesh, {});
    const Judgement unchanged = judge(elements, certificate);
    INFO("unchanged: " << unchanged.code << " line " << unchanged.line << ' ' << unchanged.why);
    CHECK(unchanged.code == 0);
    std::size_t number = 0;
    for_each_mutant(certificate, [&](const Mutation& mutation, std::size_t line, std::size_t token,
                                     const std::string& mutant) {
      // Long certificates: every 7th, and all changes of words.
      if (certificate.size() > 4000 && mutation.kind != "word" && number++ % 7 != 0) return;
      const Judgement judgement = judge(elements, mutant);
      ++codes[judgement.code];
      if (judgement.code != 0) return;
      INFO("line " << line << ", token " << token << ": " << mutation.token);
      check_claims(judgement, truth);
    });
  }
  WARN("mutants of certify's: accepted " << codes[0] << ", rejected " << codes[1] << ", malformed "
                                         << codes[2]);
  CHECK(codes[0] > 0);
  CHECK(codes[1] > 2 * codes[0]);
  CHECK(codes[2] > 1000);
}

// The verdict of a folded element, made a better one by hand: every line of evidence that the format has.
TEST_CASE("a deliberately broken verdict is caught") {
  const Folder folder;
  std::size_t broken = 0;
  for (const char* name : {"element-folded-p2", "element-folded-conic", "element-folded-q2",
                           "element-degenerate", "element-reversed"}) {
    const std::string mesh = BEZCERT_SOURCE_DIR "/corpus/whole/" + std::string(name) + ".bez.json";
    INFO(mesh);
    REQUIRE(folder.run({"check", "--criteria=none", "--certificate=c.cert", mesh}).code < 2);
    const std::string certificate = bytes_of(folder / "c.cert");
    REQUIRE(folder.verify(mesh, "c.cert").code == 0);
    std::vector<std::string> lines = split(certificate, '\n');
    for (std::size_t i = 5; i < lines.size(); ++i) {
      const std::vector<std::string> words = split(lines[i], ' ');
      if (words.size() < 2 || words[0] == "mesh") continue;
      if (words[1] != "folded" && words[1] != "degenerate" && words[1] != "reversed" && words[1] != "invalid")
        continue;
      for (const char* claim : {"injective coefficients midpoint", "injective hull", "regular coefficients",
                                "injective coefficients orientation"}) {
        std::vector<std::string> edited = lines;
        edited[i] = words[0] + ' ' + claim;
        for (std::string& line : edited)
          if (line.starts_with("mesh ")) line = "mesh undecided";
        std::string text;
        for (const std::string& line : edited) text += line + (&line == &edited.back() ? "" : "\n");
        const Outcome outcome = folder.verify(mesh, folder.write("edited.cert", text));
        INFO(edited[i] << "\n" << outcome.out << outcome.err);
        CHECK(outcome.code == 1);
        CHECK(outcome.out.find("edited.cert:" + std::to_string(i + 1) + ":") != outcome.out.npos);
        ++broken;
      }
    }
  }
  CHECK(broken >= 20);
}

}  // namespace bezcert::test
