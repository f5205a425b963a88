// Large sections are read in parts, into their places, by whatever threads there are: the
// mesh, and what is refused, is that of reading alone, line by line where a line is not plain.
#include "reading.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <cstring>
#include <thread>

namespace bezcert::test {
namespace {

// Two threads, one of which goes backwards.
class TwoThreads : public Executor {
 public:
  std::size_t threads() const override { return 2; }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override {
    std::thread other([&] {
      for (std::size_t i = count; i-- > count / 2;) work(i);
    });
    for (std::size_t i = 0; i < count / 2; ++i) work(i);
    other.join();
  }
};

ReadOptions with_threads() {
  static TwoThreads threads;
  ReadOptions options;
  options.executor = &threads;
  return options;
}

struct Strip {
  std::vector<std::uint64_t> tags;
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::uint64_t>> elements;  // tag and nodes
};

// Quadratic triangles.
Strip random_strip(Random& random, std::uint64_t first_tag, std::uint64_t step, std::uint64_t count = 5000,
                   std::uint64_t nodes = 0) {
  Strip strip;
  const double height = random.chance(50) ? 0 : 2.5;
  for (std::uint64_t i = 0; i < std::max(nodes, count + 5); ++i) {
    strip.tags.push_back(first_tag + step * i);
    strip.points.push_back({random.any_double(-60, 60), random.any_double(-60, 60), height});
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    std::vector<std::uint64_t>& element = strip.elements.emplace_back();
    element.push_back(3 * i + 7);
    for (std::uint64_t k = 0; k < 6; ++k) element.push_back(strip.tags[i + k]);
  }
  return strip;
}

std::string point_text(const std::array<double, 3>& point) {
  std::array<char, 100> line{};
  std::snprintf(line.data(), line.size(), "%.17g %.17g %.17g\n", point[0], point[1], point[2]);
  return line.data();
}

std::string text_of(const Strip& strip) {
  const std::string n = std::to_string(strip.tags.size()), e = std::to_string(strip.elements.size());
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + n + " 1 1\n2 1 0 " + n + "\n";
  for (const std::uint64_t tag : strip.tags) text += std::to_string(tag) + "\n";
  for (const auto& point : strip.points) text += point_text(point);
  text += "$EndNodes\n$Elements\n1 " + e + " 1 1\n2 1 9 " + e + "\n";
  for (const auto& element : strip.elements) {
    for (const std::uint64_t number : element) text += std::to_string(number) + " ";
    text += "\n";
  }
  return text + "$EndElements\n";
}

// Version 2.2, with lines of another type before the elements at these places.
std::string text_2_of(const Strip& strip, const std::vector<std::size_t>& others) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
  text += std::to_string(strip.tags.size()) + "\n";
  for (std::size_t i = 0; i < strip.tags.size(); ++i) {
    text += std::to_string(strip.tags[i]) + " " + point_text(strip.points[i]);
  }
  text += "$EndNodes\n$Elements\n" + std::to_string(strip.elements.size() + others.size()) + "\n";
  const std::string other = "90 15 2 1 1 " + std::to_string(strip.tags[0]) + "\n";
  for (std::size_t i = 0; i < strip.elements.size(); ++i) {
    if (std::find(others.begin(), others.end(), i) != others.end()) text += other;
    text += std::to_string(strip.elements[i][0]) + " 9 2 1 1";
    for (std::size_t k = 1; k < 7; ++k) text += " " + std::to_string(strip.elements[i][k]);
    text += "\n";
  }
  return text + "$EndElements\n";
}

std::string bytes_of(const Strip& strip, bool swapped) {
  std::string bytes = "$MeshFormat\n4.1 1 8\n";
  const auto put = [&](auto number) {
    char raw[sizeof(number)];
    std::memcpy(raw, &number, sizeof(number));
    if (swapped) std::reverse(raw, raw + sizeof(number));
    bytes.append(raw, sizeof(number));
  };
  const auto header = [&](std::size_t count, std::int32_t third) {
    for (const std::uint64_t number :
         {std::uint64_t{1}, std::uint64_t{count}, std::uint64_t{1}, std::uint64_t{1}})
      put(number);
    for (const std::int32_t number : {2, 1, third}) put(number);
    put(std::uint64_t{count});
  };
  put(std::int32_t{1});
  bytes += "\n$EndMeshFormat\n$Nodes\n";
  header(strip.tags.size(), 0);
  for (const std::uint64_t tag : strip.tags) put(tag);
  for (const auto& point : strip.points) {
    for (const double number : point) put(number);
  }
  bytes += "\n$EndNodes\n$Elements\n";
  header(strip.elements.size(), 9);
  for (const auto& element : strip.elements) {
    for (const std::uint64_t number : element) put(number);
  }
  return bytes + "\n$EndElements\n";
}

// The places of corners and middles in our order: gmsh's nodes 0 3 1 / 5 4 / 2 (docs/formats.md).
constexpr std::array<std::size_t, 6> place = {0, 2, 5, 1, 4, 3};

// Where elements are: in no lines, in those of a version, or anywhere.
enum class Lines { none, version_4, version_2, any };

void require_is(const Mesh& mesh, const Strip& strip, Lines lines,
                const std::vector<std::size_t>& others = {}) {
  const std::size_t n = strip.tags.size();
  REQUIRE(mesh.origin().node_tags.size() == n);
  REQUIRE(mesh.node_count() == n);
  REQUIRE(mesh.coordinates(1).size() == n);
  std::size_t wrong_nodes = 0, wrong_elements = 0, wrong_lines = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool right = mesh.origin().node_tags[i] == strip.tags[i] &&
                       mesh.coordinates(0).doubles()[i] == strip.points[i][0] &&
                       mesh.coordinates(1).doubles()[i] == strip.points[i][1];
    if (!right) ++wrong_nodes;
  }
  REQUIRE(mesh.elements().size() == strip.elements.size());
  REQUIRE(mesh.connectivity().size() == 6 * strip.elements.size());
  std::size_t before = 0;
  for (std::size_t i = 0; i < strip.elements.size(); ++i) {
    const MeshElement& entry = mesh.elements()[i];
    bool right = mesh.origin().number(i) == strip.elements[i][0] && entry.first_node == 6 * i;
    for (std::size_t k = 0; k < 6; ++k) right = right && mesh.connectivity()[6 * i + place[k]] == i + k;
    if (!right) ++wrong_elements;
    before += static_cast<std::size_t>(std::count(others.begin(), others.end(), i));
    const std::size_t line = lines == Lines::none        ? 0
                             : lines == Lines::version_4 ? 6 + 2 * n + 4 + i + 1
                                                         : 5 + n + 3 + before + i + 1;
    if (lines != Lines::any && mesh.origin().line(i) != line) ++wrong_lines;
  }
  CHECK(wrong_nodes == 0);
  CHECK(wrong_elements == 0);
  CHECK(wrong_lines == 0);
}

}  // namespace

TEST_CASE("parts read by threads are the mesh that was written") {
  const std::uint64_t seed = seed_or(621);
  Random random(seed);
  // Tags that follow each other, dense ones, sparse ones, and ones of more than 32 bits.
  for (const auto& [first, step] : {std::pair<std::uint64_t, std::uint64_t>{1, 1},
                                    {0, 1},
                                    {7, 3},
                                    {5, 1000003},
                                    {(1ULL << 32) - 2000, 1},
                                    {100000000000, 1}}) {
    INFO("seed " << seed << ", tags from " << first << " by " << step);
    const Strip strip = random_strip(random, first, step);
    for (const ReadOptions& options : {ReadOptions(), with_threads()}) {
      require_is(read_mesh("text", text_of(strip), options), strip, Lines::version_4);
      for (const std::vector<std::size_t>& others : {std::vector<std::size_t>{}, {0, 4000}}) {
        require_is(read_mesh("text", text_2_of(strip, others), options), strip, Lines::version_2, others);
      }
      require_is(read_mesh("binary", bytes_of(strip, false), options), strip, Lines::none);
      require_is(read_mesh("binary", bytes_of(strip, true), options), strip, Lines::none);
    }
  }
}

TEST_CASE("sections of several rounds are read, whatever round is not plain") {
  const std::uint64_t seed = seed_or(625);
  Random random(seed);
  // Elements of version 2 come in rounds of 2^13 lines, those of version 4.1 and nodes in rounds of 2^19.
  const Strip elements = random_strip(random, 1, 1, 30000), sparse = random_strip(random, 1, 2, 30000);
  Strip nodes = random_strip(random, 1, 1, 100, (1 << 19) + 100);
  for (auto& point : nodes.points) point[2] = 0;
  std::string text = text_of(nodes);
  text.insert(text.find("$EndNodes") - 2, "+");  // the sign of the last z
  for (const ReadOptions& options : {ReadOptions(), with_threads()}) {
    for (const std::vector<std::size_t>& others :
         {std::vector<std::size_t>{}, {9000}, {0, 8191, 8192, 20000}}) {
      for (const Strip& strip : {elements, sparse}) {
        require_is(read_mesh("text", text_2_of(strip, others), options), strip, Lines::version_2, others);
      }
    }
    require_is(read_mesh("text", text_of(nodes), options), nodes, Lines::version_4);
    require_is(read_mesh("text", text, options), nodes, Lines::version_4);
    require_is(read_mesh("text", text_2_of(nodes, {}), options), nodes, Lines::version_2);
    require_is(read_mesh("binary", bytes_of(nodes, false), options), nodes, Lines::none);
  }
}

TEST_CASE("lines that are not plain are read all the same, by threads or not") {
  const std::uint64_t seed = seed_or(622);
  Random random(seed);
  for (int i = 0; i < 6; ++i) {
    INFO("seed " << seed << " case " << i);
    Strip strip = random_strip(random, 1, 1);
    strip.points[4000] = {1, 2, strip.points[0][2]};
    std::string text = text_of(strip);
    // A sign, a blank line among the tags, one among the elements.
    const std::size_t at = text.find("\n1 2 ");
    REQUIRE(at != std::string::npos);
    text.insert(at + 1, "+");
    if (i % 3 == 1) text.insert(text.find("\n3000\n"), "\n \t");
    if (i % 3 == 2) text.insert(text.rfind("\n9001 "), "\n");
    for (const ReadOptions& options : {ReadOptions(), with_threads()}) {
      const Mesh mesh = read_mesh("text", text, options);
      require_is(mesh, strip, i % 3 == 0 ? Lines::version_4 : Lines::any);
      const std::size_t last = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) - 1;
      CHECK(mesh.origin().line(mesh.elements().size() - 1) == last);
    }
  }
}

TEST_CASE("what is wrong is refused in the same words by threads") {
  const std::uint64_t seed = seed_or(623);
  Random random(seed);
  const Strip good = random_strip(random, 1, 1);
  int refused = 0;
  const auto compare = [&](const std::string& bytes, const std::string& phrase) {
    INFO("seed " << seed << ", expected: " << phrase);
    const auto alone = refusal(bytes), together = refusal(bytes, with_threads());
    REQUIRE(alone);
    REQUIRE(together);
    CHECK(alone->what == together->what);
    CHECK(alone->line == together->line);
    CHECK(alone->what.find(phrase) != std::string::npos);
    ++refused;
  };
  const auto all = [&](const Strip& strip, const std::string& phrase) {
    compare(text_of(strip), phrase);
    compare(text_2_of(strip, {}), phrase);
    compare(bytes_of(strip, false), phrase);
  };
  Strip bad = good;
  bad.elements[4500][3] = 6000;
  bad.elements[4900][3] = 7000;
  all(bad, "element 13507 uses node 6000");
  bad = good;
  bad.elements[10][1] = 0;
  all(bad, "element 37 uses node 0");
  bad = good;
  bad.points[4321][2] += 1;
  all(bad, "not planar: node 4322");
  bad = good;
  bad.tags[4321] = 17;
  all(bad, "node 17 is defined twice");
  for (const double value :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (const std::size_t axis : {0, 1, 2}) {
      bad = good;
      bad.points[3000][axis] = value;
      compare(bytes_of(bad, false), "a coordinate of node 3001 is not finite");
      compare(bytes_of(bad, true), "a coordinate of node 3001 is not finite");
    }
    bad = good;
    for (auto& point : bad.points) point[2] = value;
    compare(bytes_of(bad, false), "a coordinate of node 1 is not finite");
  }
  const std::string text = text_of(good);
  const auto with = [&](std::size_t at, const std::string& inserted) {
    return std::string(text).insert(at, inserted);
  };
  compare(with(text.find("\n4000\n") + 1, "x"), "the node tag is 'x4000'");
  compare(with(text.find("\n4000\n") + 1, "4 "), "expected 1 numbers for a node tag, found 2");
  compare(with(text.rfind("\n9001 ") + 1, "12345678901234567890"), "expected an integer below 2^63");
  compare(with(text.rfind("\n9001 ") + 1, "1 "), "expected 7 numbers");
  compare(with(text.find("$EndNodes") - 2, "x"), "a coordinate of node 5005 is");
  // Cut off anywhere.
  for (int i = 0; i < 40; ++i) {
    compare(
        text.substr(0, static_cast<std::size_t>(random.integer(100, static_cast<long>(text.size()) - 14))),
        "");
    const std::string text_2 = text_2_of(good, {}), bytes = bytes_of(good, false);
    compare(text_2.substr(
                0, static_cast<std::size_t>(random.integer(100, static_cast<long>(text_2.size()) - 14))),
            "");
    compare(
        bytes.substr(0, static_cast<std::size_t>(random.integer(100, static_cast<long>(bytes.size()) - 14))),
        "");
  }
  CHECK(refused == 4 * 3 + 2 * 7 + 5 + 120);
}

TEST_CASE("a mesh in several planes is read line by line, and refused only where elements use both") {
  const std::uint64_t seed = seed_or(624);
  Random random(seed);
  Strip strip = random_strip(random, 1, 1);
  // Nodes behind the last element's, in another plane.
  for (std::uint64_t i = 0; i < 3000; ++i) {
    strip.tags.push_back(strip.tags.size() + 1);
    strip.points.push_back({1, 2, 77});
  }
  for (const ReadOptions& options : {ReadOptions(), with_threads()}) {
    require_is(read_mesh("text", text_of(strip), options), strip, Lines::version_4);
    require_is(read_mesh("text", text_2_of(strip, {}), options), strip, Lines::version_2);
    require_is(read_mesh("binary", bytes_of(strip, false), options), strip, Lines::none);
  }
}

}  // namespace bezcert::test
