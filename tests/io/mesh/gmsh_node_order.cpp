// Gmsh's node orders and element types against tables that gmsh itself gave.
#include "bezcert/io/mesh/gmsh_types.hpp"
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

struct GridPoint {
  int i = 0;
  int j = 0;
};

// type -> the grid points of its nodes, in gmsh's order.
std::map<int, std::vector<GridPoint>> node_order_table() {
  std::map<int, std::vector<GridPoint>> table;
  for (const auto& row : table_of(BEZCERT_SOURCE_DIR "/corpus/meshes/node_order.tsv", 4)) {
    auto& nodes = table[std::stoi(row[0])];
    REQUIRE(std::stoul(row[1]) == nodes.size());
    nodes.push_back({std::stoi(row[2]), std::stoi(row[3])});
  }
  return table;
}

Shape shape_of_type(int type) {
  const std::vector<int> triangles = {2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
  const std::vector<int> quadrangles = {3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
  for (int p = 1; p <= 10; ++p) {
    if (triangles[static_cast<std::size_t>(p) - 1] == type) return Shape::triangle(p);
    if (quadrangles[static_cast<std::size_t>(p) - 1] == type) return Shape::square(p, p);
  }
  FAIL("type " << type << " is in neither list");
  return {};
}

// One element of a type, the node of grid point (i, j) at (i, j); tags count down, so that order is not
// place.
std::string grid_mesh(int type, const std::vector<GridPoint>& nodes) {
  const std::size_t count = nodes.size();
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(count) + "\n";
  std::string element = "1 " + std::to_string(type) + " 0";
  for (std::size_t k = 0; k < count; ++k) {
    const std::string tag = std::to_string(count - k);
    text += tag + " " + std::to_string(nodes[k].i) + " " + std::to_string(nodes[k].j) + " 0\n";
    element += " " + tag;
  }
  return text + "$EndNodes\n$Elements\n1\n" + element + "\n$EndElements\n";
}

}  // namespace

TEST_CASE("gmsh_node_order is gmsh's order, orders 1 to 10") {
  std::size_t seen = 0;
  const auto table = node_order_table();
  REQUIRE(table.size() == 20);
  for (const auto& [type, nodes] : table) {
    const Shape shape = shape_of_type(type);
    const std::vector<std::size_t> order = gmsh_node_order(shape);
    INFO("type " << type);
    REQUIRE(order.size() == nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k, ++seen) {
      INFO("node " << k << " at (" << nodes[k].i << ", " << nodes[k].j << ")");
      REQUIRE(order[k] == coefficient_index(shape, nodes[k].j, nodes[k].i));
    }
  }
  // (p+1)(p+2)/2 and (p+1)^2 nodes for p = 1..10: 285 and 505.
  CHECK(seen == 790);
}

TEST_CASE("the reader puts every node in its row and column, orders 1 to 10") {
  std::size_t seen = 0;
  for (const auto& [type, nodes] : node_order_table()) {
    INFO("type " << type);
    const Shape shape = shape_of_type(type);
    const Mesh mesh = read_mesh("grid", grid_mesh(type, nodes));
    REQUIRE(mesh.elements().size() == 1);
    REQUIRE(mesh.elements()[0].shape == shape);
    const auto points = points_of(mesh, 0);
    REQUIRE(points.size() == nodes.size());
    for (int row = 0; row < row_count(shape); ++row) {
      for (int column = 0; column < column_count(shape, row); ++column, ++seen) {
        const auto& [x, y] = points[coefficient_index(shape, row, column)];
        INFO("row " << row << ", column " << column);
        REQUIRE(x == column);
        REQUIRE(y == row);
      }
    }
  }
  CHECK(seen == 790);
}

TEST_CASE("every type that gmsh has is read, ignored or refused by its name") {
  std::map<std::string, std::size_t> outcomes;
  std::set<std::string> messages;
  for (const auto& row : table_of(BEZCERT_SOURCE_DIR "/tests/io/mesh/gmsh_types.tsv", 5)) {
    const int type = std::stoi(row[0]);
    const int dimension = std::stoi(row[1]);
    const int order = std::stoi(row[2]);
    const int nodes = std::stoi(row[3]);
    INFO("type " << type << ", " << row[4]);
    const bool triangle = row[4].starts_with("Triangle");
    const int complete = triangle ? (order + 1) * (order + 2) / 2 : (order + 1) * (order + 1);
    // One cell of the type, then the two triangles: a wrong number of nodes would shift what follows.
    ByteWriter w = binary_start("2.2");
    write_nodes_22b(w);
    w.text("$Elements\n3\n").int32(type).int32(1).int32(0).int32(1);
    for (int k = 0; k < nodes; ++k) w.int32(k % 4 + 1);
    w.int32(2).int32(2).int32(0).int32(11).int32(1).int32(2).int32(3).int32(12).int32(1).int32(3).int32(4);
    w.text("\n$EndElements\n");
    const auto refused = refusal(w.str());
    if (refused) {
      CAPTURE(refused->what);
      REQUIRE(dimension == 2);
      REQUIRE((order == 0 || nodes != complete));
      if (order > 0) {
        // "9-node serendipity triangle": the count and the shape are the name.
        REQUIRE(refused->what.find(std::to_string(nodes) + "-node serendipity " +
                                   (triangle ? "triangle" : "quadrangle")) != std::string::npos);
        REQUIRE(refused->what.find("type " + std::to_string(type) + " ") != std::string::npos);
      }
      REQUIRE(messages.insert(refused->what).second);
      ++outcomes[order > 0 ? "serendipity" : "order 0"];
      continue;
    }
    const Mesh mesh = read_mesh("types", w.str());
    REQUIRE(mesh.elements().size() == (dimension == 2 ? 3 : 2));
    REQUIRE(mesh.origin().number(mesh.elements().size() - 1) == 12);
    REQUIRE(mesh.origin().ignored.points == (dimension == 0 ? 1 : 0));
    REQUIRE(mesh.origin().ignored.lines == (dimension == 1 ? 1 : 0));
    REQUIRE(mesh.origin().ignored.volumes == (dimension == 3 ? 1 : 0));
    REQUIRE((dimension != 2 || nodes == complete));
    ++outcomes[dimension == 2 ? "read" : "ignored"];
  }
  CHECK(outcomes["read"] == 20);
  CHECK(outcomes["serendipity"] == 17);
  CHECK(outcomes["order 0"] == 2);
  // 1 point type, 11 of lines (orders 0 to 10), and volumes: 59 rows of dimension 3 in the table.
  CHECK(outcomes["ignored"] == 1 + 11 + 59);
}

}  // namespace bezcert::test
