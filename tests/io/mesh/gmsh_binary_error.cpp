// Binary .msh files that are wrong. There are no lines: the message stands alone.
#include "memory_limit.hpp"
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

constexpr std::size_t megabytes = std::size_t{1} << 20;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Case {
  std::string bytes;
  std::string phrase;
};

// Version 2.2: what follows "$Elements\n".
Case elements_22(const std::string& count, const std::vector<std::int32_t>& numbers,
                 const std::string& phrase) {
  ByteWriter w = binary_start("2.2");
  write_nodes_22b(w);
  w.text("$Elements\n" + count + "\n");
  for (const std::int32_t number : numbers) w.int32(number);
  w.text("\n$EndElements\n");
  return {w.str(), phrase};
}

// Version 4.1: the header, then blocks (dimension, entity, type, count) and their numbers.
struct Block {
  std::int32_t dimension;
  std::int32_t type;
  std::uint64_t count;
  std::vector<std::uint64_t> numbers;
};

Case elements_41(std::uint64_t blocks, std::uint64_t count, const std::vector<Block>& list,
                 const std::string& phrase) {
  ByteWriter w = binary_start("4.1");
  write_nodes_41b(w);
  w.text("$Elements\n").uint64(blocks).uint64(count).uint64(1).uint64(12);
  for (const Block& block : list) {
    w.int32(block.dimension).int32(1).int32(block.type).uint64(block.count);
    for (const std::uint64_t number : block.numbers) w.uint64(number);
  }
  w.text("\n$EndElements\n");
  return {w.str(), phrase};
}

Case nodes_41(std::uint64_t blocks, std::uint64_t count, std::uint64_t in_block, const std::string& phrase) {
  ByteWriter w = binary_start("4.1");
  w.text("$Nodes\n").uint64(blocks).uint64(count).uint64(1).uint64(4);
  w.int32(2).int32(1).int32(0).uint64(in_block);
  for (std::uint64_t tag = 1; tag <= 4; ++tag) w.uint64(tag);
  for (const auto& [x, y] : tiny_nodes) w.float64(x).float64(y).float64(0);
  w.text("\n$EndNodes\n");
  return {w.str(), phrase};
}

void require_all(const std::vector<Case>& cases) {
  const MemoryLimit limit(1024 * megabytes);
  for (const Case& one : cases) require_refused(one.bytes, one.phrase, 0);
}

constexpr std::uint64_t two63 = std::uint64_t{1} << 63;

}  // namespace

TEST_CASE("binary coordinates that are not finite are refused") {
  std::size_t seen = 0;
  for (const double bad : {infinity, -infinity, not_a_number}) {
    for (std::size_t node = 0; node < 4; ++node) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        auto nodes = tiny_nodes;
        nodes[node][axis] = bad;
        for (const bool swapped : {false, true}) {
          ByteWriter two = binary_start("2.2", swapped);
          write_nodes_22b(two, nodes);
          ByteWriter four = binary_start("4.1", swapped);
          write_nodes_41b(four, nodes);
          const std::string phrase = "a coordinate of node " + std::to_string(node + 1) + " is not finite";
          require_refused(two.str(), phrase, 0);
          require_refused(four.str(), phrase, 0);
          seen += 2;
        }
      }
    }
  }
  CHECK(seen == 3 * 4 * 2 * 2 * 2);
  ByteWriter z = binary_start("2.2");
  z.text("$Nodes\n1\n").int32(1).float64(0).float64(0).float64(not_a_number).text("\n$EndNodes\n");
  require_refused(z.str(), "a coordinate of node 1 is not finite", 0);
}

TEST_CASE("binary version 2.2 that is wrong is refused") {
  const std::string triangles = "4294967296";
  std::vector<Case> cases = {
      elements_22("-1", {}, "the number of elements is -1"),
      elements_22("18446744073709551615", {2, 1, 0, 11, 1, 2, 3}, "'18446744073709551615'"),
      elements_22("9223372036854775808", {2, 1, 0, 11, 1, 2, 3}, "'9223372036854775808'"),
      elements_22("9223372036854775807", {2, 1, 0, 11, 1, 2, 3},
                  "9223372036854775807 elements are announced"),
      elements_22("2147483647", {2, 2147483647, 0, 11, 1, 2, 3}, "2147483647 elements are announced"),
      elements_22("5", {2, 5, 0, 11, 1, 2, 3}, "5 elements are announced"),
      elements_22("1", {2, 1, 2147483647, 11, 1, 2, 3}, "1 elements are announced"),
      elements_22("1", {2, 1, -1, 11, 1, 2, 3}, "the number of tags is negative"),
      elements_22("1", {2, 0, 0, 11, 1, 2, 3}, "a block announces 0 elements"),
      elements_22("1", {2, 2, 0, 11, 1, 2, 3, 12, 1, 3, 4}, "a block announces 2 elements, expected 1 to 1"),
      elements_22("1", {2, -1, 0, 11, 1, 2, 3}, "the number of elements in a block is negative"),
      elements_22("1", {2, 1, 0, -11, 1, 2, 3}, "the element number is negative"),
      elements_22("1", {2, 1, 0, 11, 1, -2, 3}, "the node number is negative"),
      elements_22("1", {2, 1, 0, 11, 1, 2, 5}, "element 11 uses node 5, which $Nodes does not define"),
      elements_22("1", {0, 1, 0, 11, 1, 2, 3}, "element type 0 is not known"),
      elements_22("1", {-1, 1, 0, 11, 1, 2, 3}, "element type -1 is not known"),
      elements_22("1", {999, 1, 0, 11, 1, 2, 3}, "element type 999 is not known"),
      elements_22("1", {16, 1, 0, 11, 1, 2, 3}, "8-node serendipity quadrangle"),
      elements_22("1", {1, 1, 0, 11, 1, 2}, "no triangles or quadrangles (ignored: 0 points, 1 lines"),
      elements_22("1", {2, 1, 0, 11, 1, 2, 3, 4}, "expected $EndElements"),
  };
  ByteWriter order = ByteWriter();
  order.text("$MeshFormat\n2.2 1 8\n").int32(2).text("\n$EndMeshFormat\n");
  cases.push_back({order.str(), "the integer that tells the byte order is 2"});
  ByteWriter no_order = ByteWriter();
  no_order.text("$MeshFormat\n2.2 1 8\n").text("\1");
  cases.push_back({no_order.str(), "the file ends early"});
  ByteWriter duplicate = binary_start("2.2");
  duplicate.text("$Nodes\n3\n");
  for (const int tag : {1, 2, 2}) duplicate.int32(tag).float64(tag).float64(0).float64(0);
  duplicate.text("\n$EndNodes\n$Elements\n1\n").int32(2).int32(1).int32(0);
  duplicate.int32(1).int32(1).int32(2).int32(2).text("\n$EndElements\n");
  cases.push_back({duplicate.str(), "node 2 is defined twice"});
  ByteWriter solid = binary_start("2.2");
  solid.text("$Nodes\n3\n");
  for (const int tag : {1, 2, 3}) solid.int32(tag).float64(tag).float64(0).float64(tag == 3 ? 0.5 : 0);
  solid.text("\n$EndNodes\n$Elements\n1\n").int32(2).int32(1).int32(0);
  solid.int32(1).int32(1).int32(2).int32(3).text("\n$EndElements\n");
  cases.push_back({solid.str(), "node 3 has z = 0.5"});
  for (const std::string count : {"2147483647", "9223372036854775807"}) {
    cases.push_back(
        {binary_start("2.2").text("$Nodes\n" + count + "\n").int32(1).str(), count + " nodes are announced"});
  }
  cases.push_back({binary_start("2.2").text("$Nodes\n-1\n").str(), "the number of nodes is -1"});
  require_all(cases);
  CHECK(cases.size() == 27);
}

TEST_CASE("binary version 4.1 that is wrong is refused") {
  const std::vector<std::uint64_t> one = {11, 1, 2, 3};
  const std::vector<std::uint64_t> two = {11, 1, 2, 3, 12, 1, 3, 4};
  const std::vector<Case> cases = {
      nodes_41(1, 4, 5, "a block announces 5 nodes, but only 4"),
      nodes_41(1, 5, 4, "the blocks hold 1 nodes fewer than announced"),
      nodes_41(1, two63, two63, "9223372036854775808 nodes are announced"),
      nodes_41(1, ~0ULL, ~0ULL, "18446744073709551615 nodes are announced"),
      nodes_41(1, ~0ULL, 4, "the blocks hold 18446744073709551611 nodes fewer"),
      nodes_41(1, 1ULL << 32, 1ULL << 32, "4294967296 nodes are announced"),
      nodes_41(1, 4, 3, "the blocks hold 1 nodes fewer than announced"),
      nodes_41(~0ULL, 4, 4, "block"),
      nodes_41(0, 0, 4, "expected $EndNodes"),
      elements_41(1, two63, {{2, 2, two63, two}}, "9223372036854775808 elements are announced"),
      elements_41(1, ~0ULL, {{2, 2, ~0ULL, two}}, "18446744073709551615 elements are announced"),
      elements_41(1, ~0ULL, {{2, 2, 2, two}}, "the blocks hold 18446744073709551613 elements fewer"),
      elements_41(1, 1ULL << 31, {{2, 2, 1ULL << 31, two}}, "2147483648 elements are announced"),
      elements_41(2, 3, {{2, 2, 1, one}, {2, 2, 3, two}}, "a block announces 3 elements, but only 2"),
      elements_41(2, 2, {{2, 2, 1, one}}, "the file ends early"),
      elements_41(1, 2, {{2, 2, 1, one}}, "the blocks hold 1 elements fewer"),
      elements_41(1, 1, {{2, 2, 1, two}}, "expected $EndElements"),
      elements_41(1, 1, {{2, 2, 1, {11, 1, 2, 5}}}, "element 11 uses node 5"),
      elements_41(1, 1, {{2, 2, 1, {11, 1, 2, ~0ULL}}}, "uses node 18446744073709551615"),
      elements_41(1, 1, {{4, 2, 1, one}}, "the dimension of a block is 4"),
      elements_41(1, 1, {{-1, 2, 1, one}}, "the dimension of a block is -1"),
      elements_41(1, 1, {{2, 35, 1, one}}, "element type 35 is not known"),
      elements_41(1, 1, {{2, 61, 1, one}}, "40-node serendipity quadrangle"),
      elements_41(1, 1, {{2, -2147483647, 1, one}}, "element type -2147483647 is not known"),
      elements_41(1, 1, {{3, 4, 1, {11, 1, 2, 3, 4}}}, "(ignored: 0 points, 0 lines, 1 volume cells)"),
      elements_41(0, 0, {}, "no triangles or quadrangles"),
  };
  require_all(cases);
  CHECK(cases.size() == 26);
}

}  // namespace bezcert::test
