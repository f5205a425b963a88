// .msh files that are wrong: each is refused with the line and what is wrong with it.
#include "memory_limit.hpp"
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

constexpr std::size_t megabytes = std::size_t{1} << 20;

// The tiny mesh with one place changed.
struct Case {
  std::string from;
  std::string to;
  std::string phrase;
  std::size_t line;
};

void require_all(const std::string& text, const std::vector<Case>& cases) {
  const MemoryLimit limit(1024 * megabytes);
  std::set<std::string> changed;
  for (const Case& one : cases) {
    INFO("'" << one.from.substr(0, 60) << "' replaced by '" << one.to.substr(0, 60) << "'");
    const std::string bytes = replaced(text, one.from, one.to);
    REQUIRE(changed.insert(bytes).second);
    require_refused(bytes, one.phrase, one.line);
  }
}

const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

}  // namespace

TEST_CASE("a format that is not read is refused") {
  const std::vector<Case> cases = {
      {"2.2 0 8", "1 0 8", "version 1 is not read", 2},
      {"2.2 0 8", "1.0 0 8", "version 1.0 is not read", 2},
      {"2.2 0 8", "3.0 0 8", "version 3.0 is not read", 2},
      {"2.2 0 8", "4.0 0 8", "version 4.0 is not read", 2},
      {"2.2 0 8", "4.2 0 8", "version 4.2 is not read", 2},
      {"2.2 0 8", "22 0 8", "version 22 is not read", 2},
      {"2.2 0 8", "-2.2 0 8", "version -2.2 is not read", 2},
      {"2.2 0 8", "2.2 0", "$MeshFormat", 2},
      {"2.2 0 8", "2.2 0 8 1", "$MeshFormat", 2},
      {"2.2 0 8", "2.2 2 8", "the file type is 2", 2},
      {"2.2 0 8", "2.2 -1 8", "the file type is -1", 2},
      {"2.2 0 8", "2.2 x 8", "the file type is 'x'", 2},
      {"2.2 0 8", "2.2 0 4", "the data size is 4, expected 8", 2},
      {"2.2 0 8", "2.2 0 8.0", "the data size is '8.0'", 2},
      {"2.2 0 8\n", "2.2 0 8\n3\n", "expected $EndMeshFormat", 3},
      {head, head + head, "a second $MeshFormat", 4},
      {head, "", "$Nodes before $MeshFormat", 1},
      {"$MeshFormat", "$NoFormat", "$EndNoFormat", 17},  // the whole file is one section without its end
  };
  require_all(tiny_22a, cases);
  CHECK(cases.size() == 18);
}

// "2.2" is a number: what is none is no version.
TEST_CASE("a version that is no number is refused") {
  for (const std::string version : {"2.2x", "2.", "2..2", "2.2.2", "2.-1", "2.abc"}) {
    INFO(version);
    require_refused(replaced(tiny_22a, "2.2 0 8", version + " 0 8"), "version " + version + " is not read",
                    2);
  }
}

TEST_CASE("sections that are missing, doubled or open are refused") {
  const std::string nodes = tiny_22a.substr(head.size(), tiny_22a.find("$Elements") - head.size());
  const std::string elements = tiny_22a.substr(tiny_22a.find("$Elements"));
  const std::vector<Case> cases = {
      {nodes, "", "no $Nodes section", 0},
      {elements, "", "no $Elements section", 0},
      {nodes, nodes + nodes, "a second $Nodes section", 11},
      {elements, elements + elements, "a second $Elements section", 18},
      {nodes, nodes + "7\n", "expected a section", 11},
      {nodes, nodes + "$\n", "expected a section", 11},
      {"$EndNodes\n", "", "expected $EndNodes", 10},
      {"$EndNodes", "$EndNode", "expected $EndNodes", 10},
      {"$EndElements\n", "", "expected $EndElements", 16},
      {nodes, nodes + "$Comments\n$EndComment\n", "$EndComments", 19},
      {"$Nodes", "$NODES", "$NODES", 17},
      {"1 15 2 7 7 1\n2 1 2 7 7 1 2\n11 2 2 7 7 1 2 3\n12 2 2 7 7 1 3 4\n",
       "1 15 2 7 7 1\n2 1 2 7 7 1 2\n3 1 2 7 7 1 2\n4 1 2 7 7 2 3\n",
       "no triangles or quadrangles (ignored: 1 points, 3 lines, 0 volume cells)", 0},
      {"4\n1 15 2 7 7 1\n2 1 2 7 7 1 2\n11 2 2 7 7 1 2 3\n12 2 2 7 7 1 3 4\n", "0\n",
       "no triangles or quadrangles", 0},
  };
  require_all(tiny_22a, cases);
  CHECK(cases.size() == 13);
}

TEST_CASE("nodes of version 2.2 that are wrong are refused") {
  const std::string node = "3 1.25 1 0";
  const std::vector<Case> cases = {
      {node, "3 nan 1 0", "node 3 is 'nan'", 8},
      {node, "3 1.25 NaN 0", "node 3 is 'NaN'", 8},
      {node, "3 inf 1 0", "node 3 is 'inf'", 8},
      {node, "3 -inf 1 0", "node 3 is '-inf'", 8},
      {node, "3 1.25 infinity 0", "node 3 is 'infinity'", 8},
      {node, "3 1.25 1 inf", "node 3 is 'inf'", 8},
      {node, "3 1e400 1 0", "node 3 is '1e400'", 8},
      {node, "3 1.25 -1e400 0", "node 3 is '-1e400'", 8},
      {node, "3 1.25 1 1e400", "node 3 is '1e400'", 8},
      {node, "3 1,25 1 0", "node 3 is '1,25'", 8},
      {node, "3 0x1p2 1 0", "node 3 is '0x1p2'", 8},
      {node, "3 1/4 1 0", "node 3 is '1/4'", 8},
      {node, "3 1.25d0 1 0", "node 3 is '1.25d0'", 8},
      {node, "3 1.25 1", "expected 4 numbers for a node", 8},
      {node, "3 1.25 1 0 0", "expected 4 numbers for a node", 8},
      {node, "3.0 1.25 1 0", "the node number is '3.0'", 8},
      {node, "-3 1.25 1 0", "the node number is -3", 8},
      {node, "x 1.25 1 0", "the node number is 'x'", 8},
      {node, "9223372036854775808 1.25 1 0", "the node number is '9223372036854775808'", 8},
      {node, "1 1.25 1 0", "node 1 is defined twice", 8},
      {node, "5 1.25 1 0", "element 11 uses node 3, which $Nodes does not define", 15},
      {node, "3 1.25 1 1e-300", "the mesh is not planar", 8},
      {"$Nodes\n4\n", "$Nodes\n-4\n", "the number of nodes is -4", 5},
      {"$Nodes\n4\n", "$Nodes\nfour\n", "the number of nodes is 'four'", 5},
      {"$Nodes\n4\n", "$Nodes\n4 4\n", "expected 1 numbers for the number of nodes", 5},
      {"$Nodes\n4\n", "$Nodes\n3\n", "expected $EndNodes", 9},
      {"$Nodes\n4\n", "$Nodes\n5\n", "expected node 5 of 5", 10},
      {"$Nodes\n4\n", "$Nodes\n0\n", "expected $EndNodes", 6},
      {"$Nodes\n4\n", "$Nodes\n1000000000\n", "1000000000 nodes are announced", 5},
      {"$Nodes\n4\n", "$Nodes\n9223372036854775807\n", "9223372036854775807 nodes are announced", 5},
      {"$Nodes\n4\n", "$Nodes\n9223372036854775808\n", "the number of nodes is '9223372036854775808'", 5},
      {"$Nodes\n4\n", "$Nodes\n18446744073709551615\n", "the number of nodes is '18446744073709551615'", 5},
  };
  require_all(tiny_22a, cases);
  CHECK(cases.size() == 32);
}

TEST_CASE("elements of version 2.2 that are wrong are refused") {
  const std::string element = "11 2 2 7 7 1 2 3";
  const std::vector<Case> cases = {
      {element, "11 2 2 7 7 1 2", "element 11", 15},
      {element, "11 2 2 7 7 1 2 3 4", "element 11", 15},
      {element, "11 3 2 7 7 1 2 3", "element 11 of type 3 with 2 tags needs 4 nodes", 15},
      {element, "11 2 3 7 7 1 2 3", "with 3 tags", 15},
      {element, "11 2 -1 1 2 3", "the number of tags is -1", 15},
      {element, "11 2 4611686018427387904 7 7 1 2 3", "with 4611686018427387904 tags", 15},
      {element, "11 2 9223372036854775807 7 7 1 2 3", "with 9223372036854775807 tags", 15},
      {element, "11 2 18446744073709551615 7 7 1 2 3", "the number of tags is '18446744073709551615'", 15},
      {element, "11", "the element type is missing", 15},
      {element, "11 2", "the number of tags is missing", 15},
      {element, "11 2.0 2 7 7 1 2 3", "the element type is '2.0'", 15},
      {element, "-11 2 2 7 7 1 2 3", "the element number is -11", 15},
      {element, "11 2 2 7 7 1 2 -3", "the node number is -3", 15},
      {element, "11 2 2 7 7 1 2 x", "the node number is 'x'", 15},
      {element, "11 2 2 7 7 1 2 33", "element 11 uses node 33, which $Nodes does not define", 15},
      {element, "11 2 2 7 7 1 2 0", "element 11 uses node 0, which $Nodes does not define", 15},
      {element, "11 2 2 7 7 1 2 9223372036854775807", "uses node 9223372036854775807", 15},
      {element, "11 34 2 7 7 1 2 3", "element type 34 is not known", 15},
      {element, "11 35 2 7 7 1 2 3", "element type 35 is not known", 15},
      {element, "11 133 2 7 7 1 2 3", "element type 133 is not known", 15},
      {element, "11 999 2 7 7 1 2 3", "element type 999 is not known", 15},
      {element, "11 -1 2 7 7 1 2 3", "element type -1 is not known", 15},
      {element, "11 0 2 7 7 1 2 3", "element type 0 is not known", 15},
      {element, "11 4294967298 2 7 7 1 2 3", "element type 4294967298 is not known", 15},
      {element, "11 20 2 7 7 1 2 3", "9-node serendipity triangle", 15},
      {"$Elements\n4\n", "$Elements\n-1\n", "the number of elements is -1", 12},
      {"$Elements\n4\n", "$Elements\n3\n", "expected $EndElements", 16},
      {"$Elements\n4\n", "$Elements\n5\n", "expected element 5 of 5", 17},
      {"$Elements\n4\n", "$Elements\n2147483648\n", "2147483648 elements are announced", 12},
      {"$Elements\n4\n", "$Elements\n9223372036854775807\n", "9223372036854775807 elements are announced",
       12},
      {"$Elements\n4\n", "$Elements\n9223372036854775808\n", "'9223372036854775808'", 12},
      {"$Elements\n4\n", "$Elements\n18446744073709551615\n", "'18446744073709551615'", 12},
  };
  require_all(tiny_22a, cases);
  CHECK(cases.size() == 32);
}

TEST_CASE("sections of version 4.1 that are wrong are refused") {
  const std::vector<Case> cases = {
      {"2 4 1 4\n", "2 4 1\n", "expected 4 numbers for the header", 5},
      {"2 4 1 4\n", "-2 4 1 4\n", "the number of blocks is -2", 5},
      {"2 4 1 4\n", "2 -4 1 4\n", "the number of nodes is -4", 5},
      {"2 4 1 4\n", "2 5 1 4\n", "the blocks hold 1 nodes fewer than announced", 15},
      {"2 4 1 4\n", "2 9223372036854775807 1 4\n", "the blocks hold 9223372036854775803 nodes fewer", 15},
      {"2 4 1 4\n", "2 18446744073709551615 1 4\n", "the number of nodes is '18446744073709551615'", 5},
      {"2 4 1 4\n", "2 3 1 4\n", "a block announces 2 nodes, but only 1", 11},
      {"2 4 1 4\n", "1 2 1 4\n", "expected $EndNodes", 11},
      {"2 4 1 4\n", "1 4 1 4\n", "the blocks hold 2 nodes fewer than announced", 10},
      {"2 4 1 4\n", "3 4 1 4\n", "expected a block of nodes, found '$EndNodes'", 16},
      {"2 4 1 4\n", "9223372036854775807 4 1 4\n", "expected a block of nodes", 16},
      {"1 1 0 2\n", "1 1 0 -2\n", "the number of nodes in a block is -2", 6},
      {"1 1 0 2\n", "1 1 0 9223372036854775807\n", "a block announces 9223372036854775807 nodes", 6},
      {"1 1 0 2\n", "4 1 0 2\n", "the dimension of a block is 4", 6},
      {"1 1 0 2\n", "-1 1 0 2\n", "the dimension of a block is -1", 6},
      {"1 1 0 2\n", "1 1 0\n", "expected 4 numbers for a block of nodes", 6},
      {"1 1 0 2\n", "1 x 0 2\n", "the entity of a block is 'x'", 6},
      {"1 1 0 2\n", "1 1 1 2\n", "expected 4 numbers for the coordinates of node 1", 9},
      {"1 1 0 2\n1\n2\n", "1 1 0 2\n1\n2 3\n", "expected 1 numbers for a node tag", 8},
      {"1 1 0 2\n1\n2\n", "1 1 0 2\n1\n-2\n", "the node tag is -2", 8},
      {"0 0 0\n", "0 0\n", "expected 3 numbers for the coordinates of node 1", 9},
      {"0 0 0\n", "0 0 0 0\n", "expected 3 numbers for the coordinates of node 1", 9},
      {"0 0 0\n", "0 nan 0\n", "a coordinate of node 1 is 'nan'", 9},
      {"\n3\n4\n", "\n3\n3\n", "node 3 is defined twice", 15},
      {"1.25 1 0\n", "1.25 1 2\n", "the mesh is not planar", 14},
      {"3 4 1 12\n", "3 5 1 12\n", "the blocks hold 1 elements fewer than announced", 25},
      {"3 4 1 12\n", "3 3 1 12\n", "a block announces 2 elements, but only 1", 23},
      {"3 4 1 12\n", "3 9223372036854775807 1 12\n", "the blocks hold 9223372036854775803 elements fewer",
       25},
      {"3 4 1 12\n", "3 9223372036854775808 1 12\n", "the number of elements is '9223372036854775808'", 18},
      {"3 4 1 12\n", "4 4 1 12\n", "expected a block of elements, found '$EndElements'", 26},
      {"2 1 2 2\n", "2 1 2 1\n", "the blocks hold 1 elements fewer", 24},
      {"2 1 2 2\n", "2 1 3 2\n", "expected 5 numbers for an element of type 3", 24},
      {"2 1 2 2\n", "2 1 9 2\n", "expected 7 numbers for an element of type 9", 24},
      {"2 1 2 2\n", "2 1 16 2\n", "8-node serendipity quadrangle", 23},
      {"2 1 2 2\n", "2 1 140 2\n", "element type 140 is not known", 23},
      {"2 1 2 2\n", "2 1 -2 2\n", "element type -2 is not known", 23},
      {"11 1 2 3\n", "11 1 2\n", "expected 4 numbers for an element of type 2", 24},
      {"11 1 2 3\n", "11 1 2 3 4\n", "expected 4 numbers for an element of type 2", 24},
      {"11 1 2 3\n", "11 1 2 5\n", "element 11 uses node 5, which $Nodes does not define", 24},
      {"$EndElements\n", "", "expected $EndElements", 25},
  };
  require_all(tiny_41a, cases);
  CHECK(cases.size() == 40);
}

TEST_CASE("messages about text are one short printable line") {
  const std::string end = "\n$EndNodes\n";
  const std::vector<Case> cases = {
      {"1.25 1 0", "1.\x1b[31m25 1 0", "a coordinate of node 3 is", 8},
      {"1.25 1 0", "1.\x07\x0b 1 0", "a coordinate of node 3 is", 8},
      {"1.25 1 0", std::string("1.\0002 1 0", 8), "expected a finite", 8},
      {"2.2 0 8", "3.\x1b[31m 0 8", "expected 2.2 or 4.1", 2},
      {"2.2 0 8", "2.2 0 " + std::string(5000, '0') + "4", "expected 8", 2},
      {"11 2 2 7 7 1 2 3", "11 " + std::string(5000, '0') + "2 2 7 7 1 2", "element 11", 15},
      {"$EndNodes\n", "$EndNodes\n$\x1b[31mred\n", "has no", 18},
      {"$EndNodes\n", "$EndNodes\n$a\rb\n", "has no", 18},
      {"$EndNodes\n", std::string("$EndNodes\n$a\0b\n", 15), "has no", 18},
      {"$EndNodes\n", "$EndNodes\n$" + std::string(100000, 'a') + "\n", "has no", 18},
  };
  require_all(tiny_22a, cases);
  CHECK(cases.size() == 10);
  // Line ends of a Mac of the last century make the whole file one line.
  std::string old = tiny_22a;
  std::replace(old.begin(), old.end(), '\n', '\r');
  require_refused(old, "", 1);
}

}  // namespace bezcert::test
