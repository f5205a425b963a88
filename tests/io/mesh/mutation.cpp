// Spoiled files: reading either succeeds with a sound mesh or throws InputError with one line. Nothing else.
#include "memory_limit.hpp"
#include "random_input.hpp"
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <exception>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

constexpr std::size_t megabytes = std::size_t{1} << 20;

// A .bez.json with everything in it that the format has.
const std::string json_base = R"({ "bezcert": 1,
  "points": [["0","0"],["1/2","-1/4"],[1,0],[0.5, 1e-1],["3/4","1/2"],["0","1"]],
  "weights": ["1","2","1","1","1/3","1"],
  "elements": [
    { "kind": "triangle", "degree": 2, "basis": "bernstein", "nodes": [0, 1, 2, 3, 4, 5], "name": "a" },
    { "kind": "quadrilateral", "degree": [1, 1], "basis": "lagrange", "expect": "injective", "source": "here",
      "points": [[0,0],[1,0],[0,1],[1,1]], "weights": [1, 1.5, 1, "2"] } ],
  "curves": [ { "degree": 1, "points": [["0","0"],["1","0"]], "weights": ["1","2"], "name": "c" } ] }
)";

// One to four changes of one to eight bytes.
std::string mutated(std::string bytes, Random& random) {
  static const std::string special = "0123456789-+.eE$\n\r \t\"\\{}[],:/\0\xff\x80\x7f";
  const auto place = [&](std::size_t size) {
    return static_cast<std::size_t>(random.integer(0, static_cast<long>(size)));
  };
  const long changes = random.chance(60) ? 1 : random.integer(2, 4);
  for (long i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = place(bytes.size() - 1);
    const std::size_t length = std::min(place(8), bytes.size() - at);
    switch (random.integer(0, 7)) {
      case 0: bytes[at] = static_cast<char>(random.integer(0, 255)); break;
      case 1: bytes[at] = special[place(special.size() - 1)]; break;
      case 2: bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.integer(0, 7))); break;
      case 3: bytes.insert(at, 1, special[place(special.size() - 1)]); break;
      case 4: bytes.erase(at, length); break;
      case 5: bytes.insert(at, bytes.substr(at, length)); break;
      case 6: bytes.replace(at, length, length, random.chance(50) ? '\xff' : '\0'); break;
      default: {
        const std::size_t from = place(bytes.size() - 1);
        const std::string piece = bytes.substr(from, length);
        bytes.replace(at, length, piece);
        break;
      }
    }
  }
  return bytes;
}

std::string hexadecimal(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto value = static_cast<unsigned char>(c);
    text += "0123456789abcdef"[value >> 4];
    text += "0123456789abcdef"[value & 15];
  }
  return text;
}

struct Base {
  std::string name;
  std::string bytes;
};

}  // namespace

TEST_CASE("reading survives 20,000 spoiled files") {
  const std::vector<Base> bases = {{"2.2 ASCII", tiny_22a},
                                   {"4.1 ASCII", tiny_41a},
                                   {"2.2 binary", tiny_22b()},
                                   {"4.1 binary", tiny_41b()},
                                   {"bez.json", json_base}};
  const std::uint64_t seed = seed_or(90210);
  INFO("seed " << seed);
  Random random(seed);
  const MemoryLimit limit(1024 * megabytes);
  constexpr std::size_t rounds = 4000;
  std::size_t all = 0;
  for (const Base& base : bases) {
    REQUIRE(!refusal(base.bytes));
    std::size_t read = 0, refused = 0, defects = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
      const std::string bytes = mutated(base.bytes, random);
      const ReadOptions options{random.chance(50) ? Basis::lagrange : Basis::bernstein,
                                random.chance(50) ? Numbers::binary64 : Numbers::decimal};
      std::string defect;
      try {
        const Mesh mesh = read_mesh("spoiled", bytes, options);
        ++read;
        if (!is_sound(mesh)) defect = "the mesh is not sound";
      } catch (const InputError& error) {
        ++refused;
        if (!is_one_line(error.what())) defect = "the message is not one line: " + std::string(error.what());
        if (std::string_view(error.what()).substr(0, 7) != "spoiled")
          defect = "the message does not name the file";
      } catch (const std::exception& error) {
        defect = "not an InputError: " + std::string(error.what());
      }
      ++all;
      if (defect.empty() || ++defects > 3) continue;  // the first few tell enough
      INFO(base.name << ", round " << round << ": " << defect
                     << "\nbytes in hexadecimal: " << hexadecimal(bytes));
      CHECK(defect.empty());
    }
    INFO(base.name << ": " << read << " read, " << refused << " refused");
    CHECK(defects == 0);
    CHECK(read + refused == rounds);
    // Both outcomes are common in every form: a digit of a coordinate reads, a letter of a keyword does not.
    CHECK(read > rounds / 20);
    CHECK(refused > rounds / 20);
  }
  CHECK(all == 20000);
}

}  // namespace bezcert::test
