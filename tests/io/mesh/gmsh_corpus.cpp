// Real gmsh meshes: what is read against counts of an independent reader (corpus/mesh_oracle.py), one mesh
// in several forms, byte order.
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

const std::string meshes = BEZCERT_SOURCE_DIR "/corpus/meshes/";

Mesh read_corpus(const std::string& name, const ReadOptions& options = {}) {
  return read_mesh(name, bytes_of(meshes + name), options);
}

// Same elements with the same nodes: tags, shapes, coordinates and which nodes are shared.
void require_same(const Mesh& a, const Mesh& b) {
  REQUIRE(a.elements().size() == b.elements().size());
  REQUIRE(a.connectivity() == b.connectivity());
  REQUIRE(a.node_count() == b.node_count());
  for (std::size_t i = 0; i < a.node_count(); ++i) {
    INFO("node in place " << i);
    REQUIRE(a.coordinates(0)[i] == b.coordinates(0)[i]);
    REQUIRE(a.coordinates(1)[i] == b.coordinates(1)[i]);
  }
  for (std::size_t i = 0; i < a.elements().size(); ++i) {
    INFO("element in place " << i);
    REQUIRE(a.origin().number(i) == b.origin().number(i));
    REQUIRE(a.elements()[i].shape == b.elements()[i].shape);
    REQUIRE(a.elements()[i].basis == b.elements()[i].basis);
    REQUIRE(a.elements()[i].first_node == b.elements()[i].first_node);
  }
  REQUIRE(a.origin().ignored.points == b.origin().ignored.points);
  REQUIRE(a.origin().ignored.lines == b.origin().ignored.lines);
  REQUIRE(a.origin().ignored.volumes == b.origin().ignored.volumes);
}

}  // namespace

TEST_CASE("gmsh meshes have the elements and ignored cells that the oracle counts") {
  std::set<std::string> listed;
  std::size_t elements = 0;
  for (const auto& row : table_of(meshes + "expected.tsv", 11)) {
    INFO(row[0]);
    listed.insert(row[0]);
    const Mesh mesh = read_corpus(row[0]);
    std::size_t triangles = 0;
    for (const MeshElement& element : mesh.elements()) triangles += element.shape.domain == Domain::triangle;
    CHECK(mesh.elements().size() == std::stoul(row[1]));
    CHECK(triangles == std::stoul(row[2]));
    CHECK(mesh.elements().size() - triangles == std::stoul(row[3]));
    CHECK(mesh.origin().ignored.points == std::stoul(row[8]));
    CHECK(mesh.origin().ignored.lines == std::stoul(row[9]));
    CHECK(mesh.origin().ignored.volumes == std::stoul(row[10]));
    CHECK(is_sound(mesh));
    CHECK(mesh.coordinates(0).binary64());
    elements += mesh.elements().size();
  }
  for (const auto& entry : std::filesystem::directory_iterator(meshes)) {
    if (entry.path().extension() == ".msh") CHECK(listed.count(entry.path().filename().string()) == 1);
  }
  // README.md: 45 files with 1093 elements.
  CHECK(listed.size() == 45);
  CHECK(elements == 1093);
}

TEST_CASE("one mesh in eight forms is one mesh") {
  const Mesh reference = read_corpus("crescent_p3_22a.msh");
  REQUIRE(reference.elements().size() == 14);
  REQUIRE(reference.elements().front().shape == Shape::triangle(3));
  // The first rows of the file as text: nodes 1 to 6.
  const std::vector<std::pair<double, double>> first = {{0, -1},  {1, 0}, {0, 1},
                                                        {0.9, 0}, {0, 0}, {-0.1055555555555555, 0}};
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(reference.coordinates(0)[i] == Rational(first[i].first));
    CHECK(reference.coordinates(1)[i] == Rational(first[i].second));
  }
  const std::vector<std::string> others = {"22b",         "41a",        "41b",     "no_entities_41a",
                                           "no_tags_22a", "extras_22a", "crlf_22a"};
  for (const std::string& other : others) {
    INFO(other);
    require_same(reference, read_corpus("crescent_p3_" + other + ".msh"));
  }
  CHECK(others.size() == 7);
}

TEST_CASE("lines of elements count from 1, blank lines and CR LF included") {
  // What the file itself says: the line that starts with the element's number.
  for (const std::string name : {"crescent_p3_22a.msh", "crescent_p3_crlf_22a.msh", "crescent_p3_41a.msh"}) {
    INFO(name);
    const std::string bytes = bytes_of(meshes + name);
    std::vector<std::string> lines = {""};
    for (const char c : bytes) {
      if (c == '\n') {
        lines.emplace_back();
      } else {
        lines.back() += c;
      }
    }
    const Mesh mesh = read_mesh(name, bytes);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
      const std::size_t number = mesh.origin().number(i), at = mesh.origin().line(i);
      REQUIRE(at > 0);
      REQUIRE(at <= lines.size());
      const std::string& line = lines[at - 1];
      CAPTURE(number, line);
      CHECK(line.starts_with(std::to_string(number) + " "));
      // A triangle of order 3: at least 10 nodes and its number.
      CHECK(std::count(line.begin(), line.end(), ' ') >= 10);
      ++seen;
    }
    CHECK(seen == 14);
  }
  const Mesh binary = read_corpus("crescent_p3_22b.msh");
  for (std::size_t i = 0; i < binary.elements().size(); ++i) CHECK(binary.origin().line(i) == 0);
}

TEST_CASE("the four forms of the tiny mesh, either byte order, are what was written") {
  std::size_t seen = 0;
  for (const std::string& bytes :
       {tiny_22a, tiny_41a, tiny_22b(), tiny_41b(), tiny_22b(true), tiny_41b(true)}) {
    INFO("form " << seen);
    const Mesh mesh = read_mesh("tiny", bytes);
    REQUIRE(mesh.elements().size() == 2);
    CHECK(mesh.origin().number(0) == 11);
    CHECK(mesh.origin().number(1) == 12);
    CHECK(mesh.origin().ignored.points == 1);
    CHECK(mesh.origin().ignored.lines == 1);
    CHECK(mesh.origin().ignored.volumes == 0);
    REQUIRE(mesh.node_count() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(mesh.coordinates(0)[k] == Rational(tiny_nodes[k][0]));
      CHECK(mesh.coordinates(1)[k] == Rational(tiny_nodes[k][1]));
    }
    // By rows a linear triangle's points are corners 0, 1 and 2.
    CHECK(mesh.connectivity() == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    ++seen;
  }
  CHECK(tiny_22b() != tiny_22b(true));
  CHECK(tiny_41b() != tiny_41b(true));
  CHECK(seen == 6);
}

TEST_CASE("the points of a .msh are nodes or control points as the caller says") {
  CHECK(read_mesh("tiny", tiny_22a).elements()[0].basis == Basis::lagrange);
  CHECK(read_mesh("tiny", tiny_22a).origin().basis_name == "lagrange");
  const Mesh mesh = read_mesh("tiny", tiny_41b(), {Basis::bernstein, Numbers::binary64});
  CHECK(mesh.elements()[0].basis == Basis::bernstein);
  CHECK(mesh.elements()[1].basis == Basis::bernstein);
  CHECK(mesh.origin().basis_name == "bernstein");
}

TEST_CASE("sparse tags, above 2^32 too, are no more than names") {
  const Mesh sparse = read_corpus("plate_p3_sparse_41a.msh");
  CHECK(sparse.elements().size() == 67);
  CHECK(is_sound(sparse));
  // 2^63 - 1 as a node's and as an element's number, in ASCII and, with 2^64 - 1, in binary.
  std::string text = tiny_41a;
  text = replaced(text, "\n3\n4\n", "\n9223372036854775807\n4\n");
  text = replaced(text, "11 1 2 3", "9223372036854775806 1 2 9223372036854775807");
  text = replaced(text, "12 1 3 4", "12 1 9223372036854775807 4");
  const Mesh mesh = read_mesh("large tags", text);
  CHECK(mesh.connectivity() == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  CHECK(mesh.origin().number(0) == 9223372036854775806U);

  ByteWriter w = binary_start("4.1");
  w.text("$Nodes\n").uint64(1).uint64(3).uint64(0).uint64(0);
  w.int32(2).int32(1).int32(0).uint64(3).uint64(~0ULL).uint64(0).uint64(1ULL << 40);
  for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) w.float64(value);
  w.text("\n$EndNodes\n$Elements\n").uint64(1).uint64(1).uint64(0).uint64(0);
  w.int32(2).int32(1).int32(2).uint64(1).uint64(~0ULL).uint64(~0ULL).uint64(0).uint64(1ULL << 40);
  w.text("\n$EndElements\n");
  const Mesh binary = read_mesh("large tags", w.str());
  CHECK(binary.connectivity() == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(binary.origin().number(0) == ~0ULL);
}

}  // namespace bezcert::test
