// Exit codes: 0 all certified, 1 something invalid, 2 usage or input, 3 undecided; the worst of several.
#include "program.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace bezcert::test {
namespace {

// With one piece and no algebra the first two are settled by their coefficients; the third has det J > 0 with
// negative coefficients inside, so the budget runs out.
const std::string good = corpus_element("affine");
const std::string folded = corpus_element("trap-node");
const std::string open_element = corpus_element("subdivision-only-quadratic");
const std::string missing = "no-such-file.msh";

}  // namespace

TEST_CASE("each exit code is shown") {
  const Folder folder;
  const auto code = [&](const std::string& mesh) { return folder.run({"check", mesh, "--budget=1"}).code; };
  CHECK(code(good) == 0);
  CHECK(code(folded) == 1);
  CHECK(code(missing) == 2);
  CHECK(code(open_element) == 3);
  CHECK(folder.run({"check", folder.write("bad.msh", "$MeshFormat\n2.2 0 8\n")}).code == 2);
  CHECK(folder.run({"check", folder.write("trap.msh", trap_mesh)}).code == 1);
}

TEST_CASE("an undecided element says which budget ran out") {
  const Folder folder;
  const Outcome outcome = folder.run({"check", open_element, "--budget=1", "--criteria=none"});
  CHECK(outcome.code == 3);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("undecided") != std::string::npos);
  CHECK(outcome.out.find("budget") != std::string::npos);
  CHECK(outcome.out.find("1 element: 1 undecided") != std::string::npos);
}

TEST_CASE("of several meshes the worst code counts, in any order: 2, 1, 3, 0") {
  const Folder folder;
  const std::vector<std::pair<std::string, int>> meshes = {
      {good, 0}, {folded, 1}, {missing, 2}, {open_element, 3}};
  const std::vector<int> worst_first = {2, 1, 3, 0};
  std::size_t seen = 0;
  for (unsigned subset = 1; subset < 16; ++subset) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(i);
    }
    int expected = -1;
    for (const int code : worst_first) {
      for (const std::size_t i : chosen) {
        if (expected < 0 && meshes[i].second == code) expected = code;
      }
    }
    do {
      std::vector<std::string> arguments = {"check", "--budget=1", "--criteria=none"};
      for (const std::size_t i : chosen) arguments.push_back(meshes[i].first);
      INFO("certify" << joined(arguments));
      CHECK(folder.run(arguments).code == expected);
      ++seen;
    } while (std::next_permutation(chosen.begin(), chosen.end()));
  }
  // Permutations of the non-empty subsets of four: 4 + 12 + 24 + 24.
  CHECK(seen == 64);
}

TEST_CASE("option --fail-on=invalid lets undecided elements pass and nothing else") {
  const Folder folder;
  const auto code = [&](const std::string& mesh, const std::string& fail_on) {
    return folder.run({"check", mesh, "--budget=1", "--fail-on=" + fail_on}).code;
  };
  CHECK(code(good, "invalid") == 0);
  CHECK(code(folded, "invalid") == 1);
  CHECK(code(missing, "invalid") == 2);
  CHECK(code(open_element, "invalid") == 0);
  CHECK(code(good, "undecided") == 0);
  CHECK(code(folded, "undecided") == 1);
  CHECK(code(open_element, "undecided") == 3);
}

TEST_CASE("a mesh with one bad element among good ones is bad, each way of being so") {
  const Folder folder;
  // classes_22a holds every class, quarter_point only degenerate ones, crescent's mirror only turned ones.
  for (const std::string name :
       {"classes_22a", "quarter_point_22a", "crescent_p3_mirrored_22a", "notch_q2_22b"}) {
    INFO(name);
    CHECK(folder.run({"check", meshes_folder + name + ".msh"}).code == 1);
  }
  for (const std::string name : {"affine-clockwise", "zero-corner", "trap-node", "single-point"}) {
    INFO(name);
    CHECK(folder.run({"check", corpus_element(name)}).code == 1);
  }
}

}  // namespace bezcert::test
