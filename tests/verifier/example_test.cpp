// Every example certificate gets its exit code, and rejected ones their line.
#include "checking.hpp"
#include "example_table.hpp"

#include <map>
#include <set>

namespace bezcert::test {
namespace {

const std::map<std::string, int> codes = {{"accepted", 0}, {"rejected", 1}, {"malformed", 2}};

// "rejected: PATH:LINE: why" -> LINE; 0 if there is no such place.
std::size_t line_in(const std::string& output, const std::string& path) {
  const std::size_t at = output.find(path + ':');
  return at == output.npos ? 0 : std::strtoul(output.c_str() + at + path.size() + 1, nullptr, 10);
}

void check_folder(const std::string& name, std::size_t least) {
  const Folder folder;
  std::size_t seen = 0;
  for (const Example& example : examples()) {
    if (example.folder() != name) continue;
    ++seen;
    const Outcome outcome = folder.verify(example.elements_path(), example.path());
    INFO(example.certificate << " of " << example.elements << "\nverifier: " << outcome.out << outcome.err);
    CHECK(outcome.code == example.code);
    CHECK(outcome.err.size() + outcome.out.size() > 0);
    const std::string first_word = outcome.out.substr(0, outcome.out.find(':'));
    if (!outcome.out.empty()) {
      CHECK(first_word == name);
      CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
    }
    if (example.line > 0) CHECK(line_in(outcome.out, example.path()) == example.line);

    // The checks inside tests are those of the program.
    const Judgement inside = judge(bytes_of(example.elements_path()), bytes_of(example.path()));
    INFO("inside: " << inside.code << ' ' << inside.why);
    CHECK(inside.code == outcome.code);
  }
  CHECK(seen >= least);
}

// The words of the lines from the elements' on.
std::set<std::string> words_of(const std::string& path) {
  std::set<std::string> words;
  std::ifstream stream(path);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream tokens(line);
    if (++number > 5)
      for (std::string word; tokens >> word;) words.insert(word);
  }
  return words;
}

}  // namespace

TEST_CASE("accepted certificates are accepted") { check_folder("accepted", 150); }
TEST_CASE("rejected certificates are rejected, in their line") { check_folder("rejected", 300); }
TEST_CASE("malformed certificates are malformed") { check_folder("malformed", 300); }

TEST_CASE("the table lists what is in the folders") {
  std::set<std::string> listed;
  for (const Example& example : examples()) {
    INFO(example.certificate);
    CHECK(listed.insert(example.certificate).second);
    CHECK(codes.at(example.folder()) == example.code);
    CHECK((example.line > 0) == (example.code == 1));
  }
  std::size_t files = 0;
  for (const auto& [folder, code] : codes) {
    for (const auto& entry : std::filesystem::directory_iterator(verifier_folder + folder)) {
      const std::string name = folder + "/" + entry.path().filename().string();
      INFO(name);
      CHECK(listed.count(name) == 1);
      ++files;
    }
  }
  CHECK(files == listed.size());
}

TEST_CASE("every rule occurs in accepted and in rejected certificates") {
  std::map<std::string, std::map<int, std::size_t>> seen;
  for (const Example& example : examples())
    for (const std::string& word : words_of(example.path())) ++seen[word][example.code];
  for (const char* rule :
       {"injective", "regular", "overlapping", "degenerate", "folded", "reversed", "invalid", "coefficients",
        "tree",      "factors", "columns",     "none",       "+",      "-",        "u",       "v",
        "open",      "root",    "slab",        "at",         "cross",  "midpoint", "hull",    "boundary",
        "m",         "h",       "s",           "j",          "a",      "b",        "r",       "mesh",
        "embedding", "refuted", "pair",        "element",    "cover",  "touch",    "pinch",   "gap",
        "undecided"}) {
    INFO(rule);
    CHECK(seen[rule][0] > 0);
    CHECK(seen[rule][1] > 0);
  }
}

// Too large for a file in the repository.
TEST_CASE("what is beyond the limits is refused, not tried") {
  const Folder folder;
  const std::string elements = verifier_folder + "elements/linear.msh";
  const std::string sound = bytes_of(verifier_folder + "accepted/coefficients-linear.cert");
  const std::string regular = "regular coefficients";
  REQUIRE(sound.find(regular) != sound.npos);
  std::string wide = "tree ";  // 2^17 leaves, 17 deep
  const auto full = [&wide](auto&& self, int depth) -> void {
    wide += depth == 0 ? '0' : '1';
    for (int half = 0; half < 2 && depth > 0; ++half) self(self, depth - 1);
  };
  full(full, 17);
  std::string many_factors = "factors 4096";
  for (int i = 0; i < 4096; ++i) many_factors += " 1 1,1 + coefficients";
  const std::map<std::string, std::string> claims = {
      {"a number of 2^23 bits", "degenerate coefficients at 1" + std::string(2'600'000, '0') + " 0"},
      {"a long denominator", "degenerate coefficients at 1/" + std::string(2'600'000, '7') + " 0"},
      {"a tree of 2^17 leaves", "regular " + wide},
      {"a tree of depth 10000", "regular tree " + std::string(10000, '1') + std::string(10001, '0')},
      {"a million bits without an end", "regular tree " + std::string(1'000'000, '1')},
      {"degree 5000", "degenerate coefficients root " +
                          [] {
                            std::string text = "-2";
                            for (int i = 1; i < 5000; ++i) text += ",0";
                            return text + ",1 1 2 0,1 0";
                          }()},
      {"a line of 2^26 characters", "regular " + std::string((std::size_t{1} << 26) + 1, 'x')},
      {"a self of depth 100000", "injective coefficients boundary" +
                                     [] {
                                       std::string text;
                                       for (int i = 0; i < 100000; ++i) text += " h";
                                       return text;
                                     }()},
      {"4096 factors", "regular " + many_factors}};
  for (const auto& [name, claim] : claims) {
    std::string certificate = sound;
    certificate.replace(certificate.find(regular), regular.size(), claim);
    const Outcome outcome = folder.verify(elements, folder.write("large.cert", certificate));
    INFO(name << ": " << outcome.out.substr(0, 300) << outcome.err.substr(0, 300));
    CHECK(outcome.code == (name == "4096 factors" ? 1 : 2));
    CHECK(outcome.out.size() < 400);
  }
}

TEST_CASE("usage errors of the verifier are exit code 2") {
  const Folder folder;
  const std::string elements = verifier_folder + "elements/linear.msh";
  CHECK(folder.verify(elements, folder / "missing.cert").code == 2);
  CHECK(folder.verify(folder / "missing.msh", verifier_folder + "accepted/coefficients-linear.cert").code ==
        2);
  CHECK(folder.verify(elements, "/").code == 2);
  CHECK(folder.verify("/", verifier_folder + "accepted/coefficients-linear.cert").code == 2);
}

}  // namespace bezcert::test
