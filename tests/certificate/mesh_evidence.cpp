// Evidence for the verdicts of meshes, checked by the verifier, which was written from the specification
// alone.
#include "bezcert/certificate/mesh_evidence.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "rules.hpp"
#include "mesh_parts.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

using namespace bezcert;
using test::MeshParts;

namespace {

verifier::Claim claim_of(ElementVerdict verdict) {
  switch (verdict) {
    case ElementVerdict::injective: return verifier::Claim::injective;
    case ElementVerdict::regular: return verifier::Claim::regular;
    case ElementVerdict::overlapping: return verifier::Claim::overlapping;
    case ElementVerdict::degenerate: return verifier::Claim::degenerate;
    case ElementVerdict::folded: return verifier::Claim::folded;
    case ElementVerdict::reversed: return verifier::Claim::reversed;
    default: return verifier::Claim::undecided;
  }
}

// What the verifier makes of a mesh's claim: its words, or why it refuses.
std::string verified(const verifier::Elements& elements, const std::vector<verifier::Claim>& claims,
                     const std::string& text) {
  std::istringstream stream(text + "end\n");
  std::string line;
  const auto next = [&]() -> std::string_view {
    std::getline(stream, line);
    verifier::begin_line();
    return line;
  };
  try {
    verifier::Tokens tokens(next());
    if (!tokens.accept("mesh")) return "no claim of the mesh";
    return verifier::check_mesh(elements, claims, tokens, next);
  } catch (const verifier::Rejected& rejected) {
    return "rejected: " + rejected.why;
  } catch (const verifier::Malformed& malformed) {
    return "malformed: " + malformed.why;
  }
}

// The evidence of the mesh's verdict, and what the verifier makes of it.
struct Outcome {
  bool complete = false;
  MeshVerdict verdict = MeshVerdict::undecided;
  std::string text, words;
};

Outcome outcome_of(const Mesh& mesh) {
  std::vector<ElementState> states;
  std::vector<verifier::Claim> claims;
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    const Element element = mesh.element(i);
    const ElementVerdict verdict = decide(element).verdict;
    claims.push_back(claim_of(verdict));
    states.push_back(is_invalid(verdict)                    ? ElementState::invalid
                     : verdict == ElementVerdict::injective ? ElementState::injective
                                                            : ElementState::open);
  }
  const MeshResult decided = examine_mesh(mesh, states);
  std::ostringstream evidence, json;
  Outcome result;
  result.complete = write_mesh_evidence(evidence, decided, states);
  result.verdict = decided.verdict;
  result.text = evidence.str();
  write_bez_json(json, mesh);
  result.words = verified(verifier::Elements(json.str(), "mixed", "decimal"), claims, result.text);
  return result;
}

// Complete, accepted, and of the right kind.
std::string checked(const Mesh& mesh) {
  const Outcome outcome = outcome_of(mesh);
  INFO(name(outcome.verdict) << ": " << outcome.text.substr(0, 200) << ": " << outcome.words);
  CHECK(outcome.complete);
  CHECK(outcome.words.find(':') == std::string::npos);
  CHECK((outcome.verdict == MeshVerdict::embedding) == (outcome.words == "embedding"));
  CHECK((outcome.verdict == MeshVerdict::undecided) == (outcome.words == "undecided"));
  return outcome.words;
}

// The verdicts' evidence of all meshes of a folder; counts by the claim's words.
std::map<std::string, int> check_folder(const std::string& folder) {
  std::map<std::string, int> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().string(), stem = entry.path().filename().string();
    if (stem.starts_with("curves-") || !(stem.ends_with(".msh") || stem.ends_with(".bez.json"))) continue;
    INFO(stem);
    ++result[checked(read_mesh(file, read_file(file)))];
  }
  return result;
}

// A copy of a node, moved.
std::uint32_t moved_copy(MeshParts& mesh, std::uint32_t node, const Rational& dx, const Rational& dy) {
  mesh.x.push_back(mesh.x[node] + dx);
  mesh.y.push_back(mesh.y[node] + dy);
  if (!mesh.weights.empty()) mesh.weights.push_back(mesh.weights[node]);
  return static_cast<std::uint32_t>(mesh.x.size() - 1);
}

std::size_t node_count(const MeshElement& element) { return coefficient_count(element.shape); }

// One thing that goes wrong in meshes, or may.
void damage(MeshParts& mesh, test::Random& random) {
  const auto any = [&](std::size_t count) {
    return static_cast<std::size_t>(random.integer(0, static_cast<long>(count) - 1));
  };
  const auto shift = [&] {
    const long size = random.integer(0, 2);  // large, medium, tiny
    return random.rational(-1, 1, 64) / (size == 0 ? 1L : size == 1 ? 4L : 1000000000L);
  };
  const std::size_t entry = any(mesh.connectivity.size());
  const MeshElement element = mesh.elements[any(mesh.elements.size())];
  switch (random.integer(0, 4)) {
    case 0: {  // a node moves, for all its elements
      const std::uint32_t from = mesh.connectivity[entry], to = moved_copy(mesh, from, shift(), shift());
      std::replace(mesh.connectivity.begin(), mesh.connectivity.end(), from, to);
      return;
    }
    case 1:  // for one of them
      mesh.connectivity[entry] = moved_copy(mesh, mesh.connectivity[entry], shift(), shift());
      return;
    case 2:  // it is there twice
      mesh.connectivity[entry] = moved_copy(mesh, mesh.connectivity[entry], 0, 0);
      return;
    case 3: {  // an element is missing
      std::vector<MeshElement>& elements = mesh.elements;
      if (elements.size() > 1)
        elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(any(elements.size())));
      return;
    }
    default: {  // an element is there twice, the second time with its own nodes, perhaps elsewhere
      MeshElement twice = element;
      twice.first_node = mesh.connectivity.size();
      const Rational dx = random.rational(-4, 4, 2), dy = random.rational(-4, 4, 2);
      for (std::size_t i = 0; i < node_count(element); ++i) {
        const std::uint32_t node = mesh.connectivity[element.first_node + i];
        mesh.connectivity.push_back(moved_copy(mesh, node, dx, dy));
      }
      mesh.elements.push_back(twice);
    }
  }
}

}  // namespace

TEST_CASE("every mesh made for its verdict has evidence") {
  std::map<std::string, int> counts = check_folder(BEZCERT_SOURCE_DIR "/corpus/whole");
  CHECK(counts["embedding"] == 43);  // expected.tsv
  for (const char* words :
       {"refuted element", "refuted cover", "refuted touch", "refuted pinch", "refuted gap"}) {
    INFO(words);
    CHECK(counts[words] > 0);
  }
  CHECK(counts["undecided"] == 0);
}

TEST_CASE("every mesh of gmsh has evidence") {
  std::map<std::string, int> counts = check_folder(BEZCERT_SOURCE_DIR "/corpus/meshes");
  CHECK(counts["embedding"] >= 12);
  CHECK(counts["refuted element"] > 0);
  CHECK(counts["undecided"] == 0);
}

TEST_CASE("meshes that something went wrong with have evidence") {
  const std::uint64_t seed = test::seed_or(20261123);
  test::Random random(seed);
  constexpr int cases = 24;
  std::map<std::string, int> counts;
  for (const char* name : {"good-disc-p1", "good-disc-p3", "good-disc-conic", "good-annulus-conic",
                           "good-mixed-holes", "good-holes-p3", "good-spiral-q2"}) {
    const std::string file = std::string(BEZCERT_SOURCE_DIR "/corpus/whole/") + name + ".bez.json";
    const Mesh good = read_mesh(file, read_file(file));
    for (int k = 0; k < cases; ++k) {
      INFO("seed " << seed << ' ' << name << " case " << k);
      MeshParts mesh(good);
      for (long i = random.integer(1, 3); i > 0; --i) damage(mesh, random);
      ++counts[checked(mesh.build())];
    }
  }
  CHECK(counts["undecided"] == 0);
  for (const char* words :
       {"embedding", "refuted element", "refuted cover", "refuted touch", "refuted pinch", "refuted gap"}) {
    INFO(words << ' ' << counts[words]);
    CHECK(counts[words] > 0);
  }
}

TEST_CASE("what certificates do not claim of elements they do not use") {
  const std::string file = BEZCERT_SOURCE_DIR "/corpus/whole/good-disc-p2.bez.json";
  const Mesh mesh = read_mesh(file, read_file(file));
  std::vector<ElementState> states(mesh.elements().size(), ElementState::injective);
  const MeshResult decided = examine_mesh(mesh, states);
  CHECK(decided.verdict == MeshVerdict::embedding);
  states[0] = ElementState::open;
  std::ostringstream evidence;
  CHECK_FALSE(write_mesh_evidence(evidence, decided, states));
  CHECK(evidence.str() == "mesh undecided\n");
}
