// Files made to hurt: certify answers or refuses with one line, in bounded memory, and never crashes.
#include "program.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {
namespace {

constexpr rlim_t gigabytes = rlim_t{1} << 30;

// The places of the numbers of a text.
std::vector<std::pair<std::size_t, std::size_t>> numbers_in(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_of("0123456789", at);
    if (begin == std::string::npos) break;
    at = std::min(text.find_first_not_of("0123456789./eE", begin), text.size());
    found.emplace_back(begin, at - begin);
  }
  return found;
}

// A few numbers replaced by nasty ones, or bytes by others.
std::string spoiled(std::string bytes, Random& random) {
  static const std::vector<std::string> nasty = {
      "0",      "-1",     "1e300",   "-1e300", "1e-300", "5e-324", "1/3", "0.1", "1e309",
      "1e-400", "nan",    "1e99999", "1e22",   "65",     "64",     "-0",  "2",   "99999999999999999999",
      "1/0",    "3000000"};
  const long changes = random.integer(1, 4);
  for (long i = 0; i < changes; ++i) {
    const auto numbers = numbers_in(bytes);
    if (random.chance(75) && !numbers.empty()) {
      const auto& [at, length] =
          numbers[static_cast<std::size_t>(random.integer(0, static_cast<long>(numbers.size()) - 1))];
      bytes.replace(at, length,
                    nasty[static_cast<std::size_t>(random.integer(0, static_cast<long>(nasty.size()) - 1))]);
    } else {
      bytes[static_cast<std::size_t>(random.integer(0, static_cast<long>(bytes.size()) - 1))] =
          static_cast<char>(random.integer(0, 255));
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("spoiled files end in an answer or in one line, never in a crash") {
  const std::uint64_t seed = seed_or(31337);
  INFO("seed " << seed);
  Random random(seed);
  const Folder folder;
  std::vector<std::string> files = {meshes_folder + "classes_22a.msh", meshes_folder + "crescent_p3_22b.msh",
                                    meshes_folder + "annulus_q3_41b.msh",
                                    meshes_folder + "quarter_point_22a.msh"};
  for (const std::string name : {"trap-node", "zero-third", "quad-rational-folded", "quarter-disc",
                                 "lagrange-cubic", "overlapping-quad", "thin-a-decimal", "zero-motzkin-plus"})
    files.push_back(corpus_element(name));
  std::map<int, std::size_t> codes;
  constexpr std::size_t rounds = 360;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::string& file = files[round % files.size()];
    const std::string bytes = spoiled(bytes_of(file), random);
    const std::string mesh = folder.write("spoiled", bytes);
    const std::string numbers = random.chance(50) ? "--numbers=decimal" : "--numbers=binary64";
    const std::string format = random.chance(50) ? "--format=text" : "--format=jsonl";
    const Outcome outcome = folder.run({"check", mesh, numbers, format}, "", 4 * gigabytes);
    INFO("round " << round << " of " << file << ", " << numbers << ", " << format << "\nexit code "
                  << outcome.code << "\n"
                  << outcome.err << "file:\n"
                  << bytes);
    REQUIRE((outcome.code >= 0 && outcome.code <= 3));
    if (outcome.code == 2) {
      REQUIRE(outcome.out.empty());
      REQUIRE(lines_of(outcome.err).size() == 1);
      REQUIRE(outcome.err.starts_with(mesh + ":"));
    } else {
      REQUIRE(outcome.err.empty());
      REQUIRE(!outcome.out.empty());
    }
    REQUIRE(folder.files() == std::vector<std::string>{"spoiled"});
    ++codes[outcome.code];
  }
  CHECK(codes[0] + codes[1] + codes[2] + codes[3] == rounds);
  // Answers and refusals are both common.
  CHECK(codes[1] > 40);
  CHECK(codes[2] > 40);
}

// A rational triangle of degree 10 over a grid whose weights are up to 10^5000: a file of 2 kB. N has degree
// 27 and coefficients of some 50,000 bits, so 4096 pieces that are all kept are more than ten gigabytes.
TEST_CASE("a small file does not take all memory") {
  std::string points, weights;
  int i = 0;
  for (int r = 0; r <= 10; ++r) {
    for (int c = 0; c + r <= 10; ++c, ++i) {
      const std::string separator = i > 0 ? "," : "";
      points +=
          separator + "[" + std::to_string(c) + "," + (r == 2 && c == 6 ? "1e300" : std::to_string(r)) + "]";
      weights += separator + (i % 9 == 4   ? "\"1e5000\""
                              : i % 3 == 0 ? "1000"
                              : i % 3 == 1 ? "1"
                                           : "\"1/1000\"");
    }
  }
  const Folder folder;
  const std::string mesh =
      folder.write("large.bez.json", R"({"bezcert":1,"elements":[{"kind":"triangle","degree":10,)"
                                     "\"points\":[" +
                                         points + "],\"weights\":[" + weights + "]}]}");
  REQUIRE(bytes_of(mesh).size() < 2048);
  const Outcome outcome = folder.run({"check", mesh, "--criteria=none"}, "", 2 * gigabytes);
  INFO("exit code " << outcome.code << "\n" << outcome.out << outcome.err);
  CHECK((outcome.code >= 0 && outcome.code <= 3));
  CHECK(lines_of(outcome.err).size() == (outcome.code == 2 ? 1 : 0));
}

}  // namespace bezcert::test
