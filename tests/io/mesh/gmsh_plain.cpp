// Lines that are written plainly are read in one go, others token by token: the mesh, and what is refused,
// must not depend on which.
#include "reading.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <cstdio>

namespace bezcert::test {
namespace {

// A strip of quadratic triangles with random coordinates; `sign` goes before every coordinate that is not
// negative: with "+" no line of nodes is plain.
std::string strip(std::uint64_t seed, bool version_2, const std::string& sign, std::uint64_t first_tag,
                  std::uint64_t step) {
  Random random(seed);
  constexpr int count = 40;
  std::string tags, points, nodes, elements;
  for (std::uint64_t i = 0; i < count + 5; ++i) {
    const std::string tag = std::to_string(first_tag + step * i);
    std::string point;
    for (int k = 0; k < 2; ++k) {
      const double value = random.any_double(-60, 60);
      std::array<char, 40> text{};
      std::snprintf(text.data(), text.size(), random.chance(50) ? "%.17g" : "%.3e", value);
      point += (value >= 0 ? sign : std::string()) + text.data() + " ";
    }
    point += sign + "0\n";
    tags += tag + "\n";
    points += point;
    nodes += tag + " " + point;
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    elements += std::to_string(i + 1) + (version_2 ? " 9 2 1 1" : "");
    for (std::uint64_t k = 0; k < 6; ++k) elements += " " + std::to_string(first_tag + step * (i + k));
    elements += "\n";
  }
  const std::string n = std::to_string(count + 5), e = std::to_string(count);
  if (version_2) {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + n + "\n" + nodes + "$EndNodes\n$Elements\n" +
           e + "\n" + elements + "$EndElements\n";
  }
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + n + " 1 1\n2 1 0 " + n + "\n" + tags + points +
         "$EndNodes\n$Elements\n1 " + e + " 1 1\n2 1 9 " + e + "\n" + elements + "$EndElements\n";
}

}  // namespace

TEST_CASE("plain lines and others give one mesh") {
  const std::uint64_t seed = seed_or(601);
  std::size_t compared = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    for (const bool version_2 : {true, false}) {
      // Consecutive tags, dense ones, sparse ones, and ones of more than 32 bits.
      for (const auto& [first, step] : {std::pair<std::uint64_t, std::uint64_t>{1, 1},
                                        {7, 3},
                                        {5, 1000000007},
                                        {(1ULL << 32) - 20, 1},
                                        {100000000000, 1}}) {
        INFO("seed " << seed << " case " << i << " tags from " << first << " by " << step);
        const Mesh plain = read_mesh("plain", strip(seed + i, version_2, "", first, step));
        const Mesh other = read_mesh("other", strip(seed + i, version_2, "+", first, step));
        REQUIRE(plain.elements().size() == 40);
        REQUIRE(plain.connectivity() == other.connectivity());
        REQUIRE(plain.origin().node_tags == other.origin().node_tags);
        for (std::size_t k = 0; k < 45; ++k) {
          REQUIRE(plain.coordinates(0)[k] == other.coordinates(0)[k]);
          REQUIRE(plain.coordinates(1)[k] == other.coordinates(1)[k]);
          REQUIRE(plain.origin().node_tags[k] == first + step * k);
        }
        for (std::size_t k = 0; k < 40; ++k) {
          REQUIRE(plain.origin().number(k) == k + 1);
          REQUIRE(plain.origin().line(k) == other.origin().line(k));
          REQUIRE(plain.connectivity()[plain.elements()[k].first_node] == k);
        }
        ++compared;
      }
    }
  }
  CHECK(compared == 1000);
}

TEST_CASE("a height that comes late is seen, with the lines of both nodes' files") {
  for (const bool version_2 : {true, false}) {
    const std::string flat = strip(5, version_2, "", 1, 1);
    const std::size_t end = flat.find("$EndNodes");
    std::string text = flat;
    text.replace(end - 2, 1, "1e-300");
    const auto one = refusal(text);
    REQUIRE(one);
    CHECK(one->what.find("not planar: node 45") != std::string::npos);
    CHECK(one->line ==
          static_cast<std::size_t>(std::count(flat.begin(), flat.begin() + static_cast<long>(end), '\n')));
    // -0 is 0.
    text = flat;
    text.replace(end - 2, 1, "-0");
    CHECK(!refusal(text));
  }
}

TEST_CASE("numbers that only look plain are refused") {
  const std::string text = strip(5, false, "", 1, 1);
  const std::size_t at = text.find("$EndNodes") - 2;
  for (const char* wrong : {"nan", "inf", "0x1", "0 0", "", "1e400", "0,5"}) {
    std::string bad = text;
    bad.replace(at, 1, wrong);
    INFO("'" << wrong << "'");
    CHECK(refusal(bad));
  }
}

}  // namespace bezcert::test
