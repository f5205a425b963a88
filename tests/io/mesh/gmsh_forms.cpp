// .msh files that look unusual and are right.
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

// The tiny mesh, whatever the form.
void require_tiny(const std::string& bytes) {
  const Mesh mesh = read_mesh("form", bytes);
  REQUIRE(mesh.elements().size() == 2);
  REQUIRE(mesh.origin().number(0) == 11);
  REQUIRE(mesh.origin().number(1) == 12);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto points = points_of(mesh, i);
    const std::size_t nodes[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(points[k].first == Rational(tiny_nodes[nodes[i][k]][0]));
      REQUIRE(points[k].second == Rational(tiny_nodes[nodes[i][k]][1]));
    }
  }
}

std::string section(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("$" + name + "\n");
  const std::size_t end = text.find("$End" + name + "\n");
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  return text.substr(begin, end + name.size() + 5 - begin);
}

std::string line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

}  // namespace

TEST_CASE("sections in another order, unknown ones and comments do not matter") {
  std::size_t seen = 0;
  for (const std::string& text : {tiny_22a, tiny_41a}) {
    const std::string format = section(text, "MeshFormat");
    const std::string nodes = section(text, "Nodes");
    const std::string elements = section(text, "Elements");
    require_tiny(format + elements + nodes);
    require_tiny(format + "$Comments\n$Nodes\n1\n9 9 9 9\n$EndNodes\n$EndComments\n" + nodes + elements);
    require_tiny(format + nodes + elements + "$NodeData\n1\n\"a\"\n$EndNodeData\n");
    require_tiny(format + "$PhysicalNames\n1\n2 7 \"$Elements\"\n$EndPhysicalNames\n" + nodes + elements);
    require_tiny("$Comments\nbefore the format\n$EndComments\n" + format + nodes + elements);
    require_tiny("\n \n" + format + "\n\n" + nodes + elements + "\n\n");
    require_tiny(text.substr(0, text.size() - 1));
    seen += 7;
  }
  CHECK(seen == 14);
}

TEST_CASE("blanks, tabs, blank lines and CR LF are no part of the numbers") {
  std::size_t seen = 0;
  for (const std::string& text : {tiny_22a, tiny_41a}) {
    require_tiny(line_ends(text, "\r\n"));
    require_tiny(line_ends(text, " \t \n"));
    require_tiny(line_ends(text, "\n\n"));
    require_tiny(line_ends(text, "\n\t "));
    std::string wide;
    for (const char c : text) wide += c == ' ' ? std::string(" \t  ") : std::string(1, c);
    require_tiny(wide);
    seen += 5;
  }
  CHECK(seen == 10);
}

TEST_CASE("version 2 by its other numbers, any number of tags, parametric nodes") {
  require_tiny(replaced(tiny_22a, "2.2 0 8", "2 0 8"));
  require_tiny(replaced(tiny_22a, "2.2 0 8", "2.0 0 8"));
  require_tiny(replaced(tiny_22a, "2.2 0 8", "2.1 0 8"));
  require_tiny(replaced(tiny_22a, "11 2 2 7 7 1 2 3", "11 2 0 1 2 3"));
  require_tiny(replaced(tiny_22a, "11 2 2 7 7 1 2 3", "11 2 5 7 7 2 1 -2 1 2 3"));
  // $ParametricNodes of version 2.2: the dimension and number of an entity and its parameters follow.
  std::string text = tiny_22a;
  text = replaced(text, "$Nodes", "$ParametricNodes");
  text = replaced(text, "$EndNodes", "$EndParametricNodes");
  text = replaced(text, "2 1.5 0.25 0", "2 1.5 0.25 0 1 3 0.5");
  text = replaced(text, "3 1.25 1 0", "3 1.25 1 0 2 3 0.5 9.5");
  require_tiny(text);
  // The same of version 4.1: parameters behind the coordinates, one on a curve and two on a surface.
  text = tiny_41a;
  text = replaced(text, "1 1 0 2\n1\n2\n0 0 0\n1.5 0.25 0\n", "1 1 1 2\n1\n2\n0 0 0 7.5\n1.5 0.25 0 8.5\n");
  text = replaced(text, "2 1 0 2\n3\n4\n1.25 1 0\n-0.5 0.75 0\n",
                  "2 1 1 2\n3\n4\n1.25 1 0 6 7\n-0.5 0.75 0 8 9\n");
  require_tiny(text);
}

TEST_CASE("binary forms: blocks of one, parameters, no tags, numbers that look like text") {
  ByteWriter two = binary_start("2.2");
  write_nodes_22b(two);
  two.text("$Elements\n2\n");
  two.int32(2).int32(1).int32(0).int32(11).int32(1).int32(2).int32(3);
  two.int32(2).int32(1).int32(3).int32(12).int32(-5).int32(0).int32(9).int32(1).int32(3).int32(4);
  two.text("\n$EndElements\n");
  require_tiny(two.str());

  ByteWriter four = binary_start("4.1");
  // An unknown section whose bytes hold the words of the format, and its own end inside a line.
  four.text("$Data\n")
      .text("$Nodes\n$EndNodes x$EndData\n")
      .float64(1)
      .text("$EndData")
      .text("\n$EndDatabase\n")
      .uint64(3);
  four.text("\n$EndData\n");
  four.text("$Nodes\n").uint64(2).uint64(4).uint64(1).uint64(4);
  four.int32(2).int32(1).int32(1).uint64(0);  // an empty block
  four.int32(2).int32(1).int32(1).uint64(4);  // parametric: u and v behind each node
  for (std::uint64_t tag = 1; tag <= 4; ++tag) four.uint64(tag);
  for (const auto& [x, y] : tiny_nodes) four.float64(x).float64(y).float64(0).float64(0.5).float64(0.25);
  four.text("\n$EndNodes\n$Elements\n").uint64(2).uint64(2).uint64(11).uint64(12);
  four.int32(2).int32(1).int32(2).uint64(1).uint64(11).uint64(1).uint64(2).uint64(3);
  four.int32(2).int32(8).int32(2).uint64(1).uint64(12).uint64(1).uint64(3).uint64(4);
  four.text("\n$EndElements\n");
  require_tiny(four.str());

  // Coordinates and tags whose bytes are line ends and dollars: 0x0a0a0a0a0a0a0a0a, "$EndNode" as a double.
  double word = 0;
  double ends = 0;
  std::memcpy(&word, "$EndNode", 8);
  std::memcpy(&ends, "\n\n\n\n\n\n\n\n", 8);
  ByteWriter w = binary_start("2.2");
  write_nodes_22b(w, {{{word, ends}, {1, 10}, {ends, word}, {2, 0}}});
  w.text("$Elements\n1\n")
      .int32(2)
      .int32(1)
      .int32(0)
      .int32(10)
      .int32(1)
      .int32(2)
      .int32(3)
      .text("\n$EndElements\n");
  const Mesh mesh = read_mesh("words", w.str());
  CHECK(mesh.coordinates(0)[0] == Rational(word));
  CHECK(mesh.coordinates(1)[0] == Rational(ends));
  CHECK(mesh.coordinates(1)[2] == Rational(word));
  CHECK(mesh.origin().number(0) == 10);
}

TEST_CASE("planar means one z for the nodes of surface elements, any z") {
  std::string text = tiny_22a;
  text = replaced(text, "1 0 0 0\n", "1 0 0 -0.0\n");
  require_tiny(text);
  for (const std::string z : {"3.5", "-1e300", "1e-320"}) {
    std::string lifted;
    for (const std::string from : {"1 0 0 0\n", "2 1.5 0.25 0\n", "3 1.25 1 0\n", "4 -0.5 0.75 0\n"}) {
      lifted = replaced(lifted.empty() ? tiny_22a : lifted, from, from.substr(0, from.size() - 2) + z + "\n");
    }
    require_tiny(lifted);
  }
  // A node off the plane that no surface element uses.
  require_tiny(replaced(replaced(tiny_22a, "$Nodes\n4\n", "$Nodes\n5\n"), "$EndNodes", "5 0 0 9\n$EndNodes"));
}

TEST_CASE("cells of other dimensions may name nodes that are missing") {
  require_tiny(replaced(tiny_22a, "2 1 2 7 7 1 2", "2 1 2 7 7 98 99"));
  require_tiny(replaced(tiny_41a, "2 1 2\n2 1 2 2", "2 98 99\n2 1 2 2"));
}

}  // namespace bezcert::test
