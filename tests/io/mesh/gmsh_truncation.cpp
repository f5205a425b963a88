// A .msh file cut at any byte is refused, in every form.
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {

TEST_CASE("a .msh file cut before the end of $EndElements is refused, at every byte") {
  const std::vector<std::pair<std::string, std::string>> forms = {
      {"2.2 ASCII", tiny_22a},    {"4.1 ASCII", tiny_41a},         {"2.2 binary", tiny_22b()},
      {"4.1 binary", tiny_41b()}, {"2.2 swapped", tiny_22b(true)}, {"4.1 swapped", tiny_41b(true)}};
  for (const auto& [name, bytes] : forms) {
    INFO(name);
    CHECK(!refusal(bytes));
    // All but the last line end: complete.
    CHECK(!refusal(bytes.substr(0, bytes.size() - 1)));
    const bool binary = name.find("ASCII") == std::string::npos;
    std::size_t refused = 0;
    for (std::size_t size = 0; size + 1 < bytes.size(); ++size) {
      const auto one = refusal(bytes.substr(0, size));
      INFO("the first " << size << " of " << bytes.size() << " bytes");
      REQUIRE(one.has_value());
      CAPTURE(one->what);
      REQUIRE(is_one_line(one->what));
      REQUIRE(is_printable(one->what));
      REQUIRE(one->what.size() < 400);
      // Behind $MeshFormat a binary file has no lines.
      if (binary && size > 30) REQUIRE(one->line == 0);
      ++refused;
    }
    CHECK(refused == bytes.size() - 1);
    CHECK(refused > 150);
  }
  CHECK(forms.size() == 6);
}

TEST_CASE("a .msh file cut behind its elements but before its nodes is refused") {
  const std::size_t nodes = tiny_22a.find("$Nodes");
  const std::size_t elements = tiny_22a.find("$Elements");
  const std::string text =
      tiny_22a.substr(0, nodes) + tiny_22a.substr(elements) + tiny_22a.substr(nodes, elements - nodes);
  std::size_t refused = 0;
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    INFO("the first " << size << " bytes");
    REQUIRE(refusal(text.substr(0, size)).has_value());
    ++refused;
  }
  CHECK(refused == text.size() - 1);
  CHECK(!refusal(text));
}

}  // namespace bezcert::test
