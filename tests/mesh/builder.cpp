// Meshes made in memory: equal to those of a file, or refused in one clear line.
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>

using namespace bezcert;
using namespace bezcert::test;

namespace {

constexpr Shape linear = Shape::triangle(1);

// Two triangles of a unit square.
const std::vector<double> points = {0, 0, 1, 0, 1, 1, 0, 1};
const std::vector<double> x = {0, 1, 1, 0}, y = {0, 0, 1, 1};

void require_equal(const Mesh& a, const Mesh& b) {
  REQUIRE(a.dimension() == 2);
  REQUIRE(a.node_count() == b.node_count());
  for (std::size_t i = 0; i < a.node_count(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) REQUIRE(a.coordinates(k)[i] == b.coordinates(k)[i]);
    REQUIRE(a.weights().empty() == b.weights().empty());
    if (!a.weights().empty()) REQUIRE(a.weights()[i] == b.weights()[i]);
  }
  REQUIRE(a.connectivity() == b.connectivity());
  REQUIRE(a.elements().size() == b.elements().size());
  for (std::size_t i = 0; i < a.elements().size(); ++i) {
    REQUIRE(a.elements()[i].shape == b.elements()[i].shape);
    REQUIRE(a.elements()[i].basis == b.elements()[i].basis);
    REQUIRE(a.elements()[i].first_node == b.elements()[i].first_node);
    REQUIRE(a.rational(i) == b.rational(i));
  }
  REQUIRE(a.glued_by_nodes() == b.glued_by_nodes());
  REQUIRE(a.origin().basis_name == b.origin().basis_name);
}

void with_nodes(MeshBuilder& builder) { builder.add_nodes_interleaved(points); }

// What is said of what `fill` hands in; empty if it makes a mesh.
std::string refusal(const std::function<void(MeshBuilder&)>& fill) {
  MeshBuilder builder;
  try {
    fill(builder);
    std::move(builder).build();
    return "";
  } catch (const MeshError& error) {
    return error.what();
  }
}

template <class Index>
std::string refusal_of_indices(std::vector<Index> nodes) {
  return refusal([&](MeshBuilder& builder) {
    with_nodes(builder);
    builder.add_elements(linear, Basis::bernstein, nodes);
  });
}

}  // namespace

TEST_CASE("a mesh made in memory is the mesh of a file") {
  const Mesh gmsh = read_mesh("a.msh",
                              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                              "4 0 1 0\n$EndNodes\n$Elements\n2\n1 2 0 1 2 3\n2 2 0 1 3 4\n$EndElements\n");
  const std::vector<std::int64_t> nodes = {0, 1, 2, 0, 2, 3};
  MeshBuilder interleaved;
  interleaved.add_elements(linear, Basis::lagrange, nodes);  // before its nodes
  CHECK(interleaved.add_nodes_interleaved(points) == 0);
  require_equal(std::move(interleaved).build(), gmsh);
  MeshBuilder separate;
  separate.add_nodes_separate({x, y});
  CHECK(separate.add_elements(linear, Basis::lagrange, std::vector<std::uint32_t>{0, 1, 2}) == 0);
  CHECK(separate.add_elements(linear, Basis::lagrange, std::vector<int>{0, 2, 3}) == 1);
  require_equal(std::move(separate).build(), gmsh);
  MeshBuilder single;
  for (const std::size_t i : {0, 1, 2, 3}) CHECK(single.add_node({x[i], y[i]}) == i);
  single.add_element(linear, Basis::lagrange, {0, 1, 2});
  single.add_element(linear, Basis::lagrange, {0, 2, 3});
  require_equal(std::move(single).build(), gmsh);
}

TEST_CASE("weights, bases, shapes and rational numbers are those of a file") {
  const Mesh json = read_mesh("a.bez.json", R"({"bezcert": 1, "points": [[0, 0], [1, 0], ["1/3", 1], [0, 1]],
    "weights": [1, 2, 1, 1], "elements": [
    {"kind": "triangle", "degree": 1, "nodes": [0, 1, 2], "name": "first"},
    {"kind": "quadrilateral", "degree": [1, 1], "basis": "lagrange", "nodes": [0, 1, 3, 2]}]})");
  MeshBuilder builder;
  builder.add_node({0, 0});
  builder.add_node({1, 0}, 2);
  builder.add_node({Rational(1, 3), 1});
  builder.add_node({0, 1});
  builder.add_element({Domain::triangle, 1, 7}, Basis::bernstein, {0, 1, 2});  // q means nothing here
  builder.add_element(Shape::square(1, 1), Basis::lagrange, {0, 1, 3, 2});
  builder.origin().element_names = {"first", ""};
  const Mesh mesh = std::move(builder).build();
  require_equal(mesh, json);
  CHECK(mesh.origin().name(0) == json.origin().name(0));
  CHECK(mesh.origin().number(1) == 2);
  CHECK(mesh.origin().line(1) == 0);
  CHECK(mesh.origin().node_number(3) == 3);
  // After build a builder is empty.
  CHECK_THROWS_AS(std::move(builder).build(), MeshError);
}

TEST_CASE("nodes that are no nodes are refused") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  CHECK(refusal([&](MeshBuilder& b) {
          b.add_node({0.0, nan});
        }) == "node 0: coordinate 1 is nan, expected a finite number");
  CHECK(refusal([&](MeshBuilder& b) {
          with_nodes(b), b.add_nodes_interleaved(std::vector{0.0, 1.0, -infinity, 0.0});
        }) == "node 5: coordinate 0 is -inf, expected a finite number");
  CHECK(refusal([&](MeshBuilder& b) {
          with_nodes(b);
          (*b.append_nodes(1))[1][0] = infinity;
          b.add_element(linear, Basis::bernstein, {0, 1, 2});
        }) == "node 4: coordinate 1 is inf, expected a finite number");
  for (const auto& [weight, text] : {std::pair{0.0, "0"}, {-1.0, "-1"}, {nan, "nan"}, {infinity, "inf"}}) {
    const double w = weight;
    const std::string expected =
        "node 1: its weight is " + std::string(text) + ", expected a positive finite number";
    CHECK(refusal([&](MeshBuilder& b) { b.add_node({0, 0}), b.add_node({1, 0}, w); }) == expected);
    CHECK(refusal([&](MeshBuilder& b) {
            b.add_nodes_separate({x, y}, std::vector{1.0, w, 1.0, 1.0});
          }) == expected);
  }
  CHECK(refusal([&](MeshBuilder& b) {
          b.add_node({Rational(0), Rational(0)}, Rational(-1, 2));
        }) == "node 0: its weight is -0.5, expected a positive finite number");
  CHECK(refusal([](MeshBuilder& b) { b.add_node({0, 0, 0}); }) == "node 0: 3 coordinates, expected 2");
  CHECK(refusal([](MeshBuilder& b) {
          b.add_nodes_interleaved(std::vector{1.0, 2.0, 3.0});
        }) == "3 coordinates of nodes in turn, expected a multiple of 2");
  CHECK(refusal([](MeshBuilder& b) { b.add_nodes_separate({x}); }) == "1 arrays of coordinates, expected 2");
  CHECK(refusal([](MeshBuilder& b) {
          b.add_nodes_separate({x, std::span(y).first(3)});
        }) == "array 1 of coordinates has 3 numbers, expected 4 as in the first");
  CHECK(refusal([](MeshBuilder& b) { b.add_nodes_interleaved(points, x); }) ==
        "node 0: its weight is 0, expected a positive finite number");
  CHECK(refusal([](MeshBuilder& b) { b.add_nodes_interleaved(points, std::vector{1.0}); }) ==
        "1 weights for 4 nodes, expected one a node, or none");
}

TEST_CASE("elements that are no elements are refused") {
  const auto of_shape = [](Shape shape, Basis basis = Basis::bernstein) {
    return refusal([&](MeshBuilder& b) { with_nodes(b), b.add_element(shape, basis, {0, 1, 2}); });
  };
  CHECK(of_shape(linear).empty());
  CHECK(of_shape(Shape::segment(2)) ==
        "element 0: its domain is none of an element, expected a triangle or a square");
  CHECK(of_shape(Shape(Domain(2, 1), 1, 1)) ==
        "element 0: its domain is none of an element, expected a triangle or a square");
  CHECK_THROWS_AS(Domain(4), std::invalid_argument);
  CHECK_THROWS_AS(Domain(std::numeric_limits<int>::max(), 1), std::invalid_argument);
  CHECK(of_shape(Shape::triangle(0)) == "element 0: its degree is 0, expected 1 to 64");
  CHECK(of_shape(Shape::triangle(65)) == "element 0: its degree is 65, expected 1 to 64");
  CHECK(of_shape(Shape::square(1, -3)) == "element 0: its degree is -3, expected 1 to 64");
  CHECK(of_shape(Shape::triangle(100)) == "element 0: its degree is 100, expected 1 to 64");
  CHECK_THROWS_AS(Shape::square(std::numeric_limits<int>::max(), 1), std::invalid_argument);
  CHECK(of_shape(linear, static_cast<Basis>(5)) ==
        "element 0: its basis is not known, expected bernstein or lagrange");
  CHECK(of_shape(Shape::triangle(2)) == "element 0: 3 nodes, expected 6 of a triangle of degree 2");
  CHECK(of_shape(Shape::square(1, 2)) ==
        "element 0: 3 nodes, expected 6 of a quadrilateral of degrees 1 and 2");
  CHECK(refusal_of_indices<int>({0, 1, 2, 0, 2}) ==
        "element 1: 2 nodes are left, expected 3 of a triangle of degree 1");
  CHECK(refusal_of_indices<int>({0, 1, 2, 0, 2, 4}) ==
        "element 1: its node 2 is 4, expected an index below 4, the number of nodes");
  const std::string expected = ", expected the index of a node, from 0 to below 2^32 - 1";
  CHECK(refusal_of_indices<int>({0, 1, 2, 0, -1, 2}) == "element 1: its node 1 is -1" + expected);
  CHECK(refusal_of_indices<std::int64_t>({0, 1, 2, std::numeric_limits<std::int64_t>::min(), 1, 2}) ==
        "element 1: its node 0 is -9223372036854775808" + expected);
  CHECK(refusal_of_indices<std::uint64_t>({0, 1, 1ULL << 32}) ==
        "element 0: its node 2 is 4294967296" + expected);
  CHECK(refusal([](MeshBuilder& b) {
          b.add_element(linear, Basis::bernstein, {0, 1, 2});
        }) == "there are no nodes, expected those of the elements");
  CHECK(refusal(with_nodes) == "there are no elements, expected at least one");
  CHECK(refusal([](MeshBuilder& b) { b.append_elements(linear, Basis::bernstein, std::size_t{1} << 62); }) ==
        "element 4611686018427387904: expected fewer than 2^32 - 1 edges of elements");
  CHECK(refusal([](MeshBuilder& b) { b.append_nodes(~std::size_t{0} >> 1); }) ==
        "node 9223372036854775807: expected fewer than 2^32 - 1 nodes");
  CHECK(refusal([](MeshBuilder& b) { b.drop_nodes(1); }) == "fewer nodes than are to be dropped");
  CHECK(refusal([](MeshBuilder& b) { b.drop_elements(1); }) == "fewer elements than are to be dropped");
}

TEST_CASE("places that were not filled with numbers are refused, whatever is added after them") {
  MeshBuilder builder;
  const auto places = builder.append_nodes(1);
  (*places)[0][0] = std::nan("");
  CHECK_THROWS_AS(builder.add_node({Rational(1, 3), Rational(0)}), std::invalid_argument);
}

TEST_CASE("lists of the origin have one entry an element") {
  CHECK(refusal([](MeshBuilder& b) {
          with_nodes(b);
          b.add_element(linear, Basis::bernstein, {0, 1, 2});
          b.origin().element_names = {"a", "b"};
        }) == "the origin has 2 names of elements, expected 1 or none");
}

// Weights (1, w, 1) of a quadratic segment that interpolates belong to control weights (1, 2 w - 1, 1):
// positive from w > 1/2 on.
TEST_CASE("rational elements in the Lagrange basis are refused if their control weights are not positive") {
  const auto with_weight = [](double w) {
    return refusal([w](MeshBuilder& b) {
      for (const double v : {0.0, 1.0}) {
        for (const double u : {0.0, 0.5, 1.0}) b.add_node({u, v}, u == 0.5 ? w : 1);
      }
      b.add_element(Shape::square(2, 1), Basis::lagrange, {0, 1, 2, 3, 4, 5});
    });
  };
  CHECK(with_weight(0.75).empty());
  CHECK(with_weight(0.5) ==
        "element 0: the weight of control point 2 is not positive after conversion from the lagrange basis; "
        "expected an element with a positive control net (degree elevation may give one)");
}

TEST_CASE("whatever is handed in makes a mesh whose elements can all be made, or is refused") {
  const std::uint64_t seed = seed_or(20261127);
  Random random(seed);
  const auto wild = [&]() -> double {
    if (random.integer(1, 200) > 1) return random.any_double(-3, 3);
    return random.chance(50) ? std::nan("") : -std::numeric_limits<double>::infinity();
  };
  const auto degree = [&] {
    return static_cast<int>(random.chance(97) ? random.integer(1, 3) : 70 * random.integer(-1, 1));
  };
  int valid = 0, refused = 0;
  for (int n = 0; n < 20000; ++n) {
    MeshBuilder builder;
    try {
      for (long step = random.integer(0, 6); step >= 0; --step) {
        if (random.chance(30))
          builder.add_node({wild(), wild()},
                           random.chance(20) ? std::optional(std::fabs(wild())) : std::nullopt);
        std::vector<double> some(static_cast<std::size_t>(random.integer(0, 12)) *
                                 (random.chance(95) ? 2 : 1));
        for (double& one : some) one = wild();
        builder.add_nodes_interleaved(some);
        if (random.chance(20)) builder.append_nodes(static_cast<std::size_t>(random.integer(0, 3)));
        // Of no element are the last three: a segment, a tetrahedron, a prism.
        const Domain domains[] = {Domain::triangle, Domain::square, Domain::segment, Domain(3), Domain(2, 1)};
        const Shape shape{domains[random.integer(0, random.chance(97) ? 1 : 4)], degree(), degree()};
        bool moderate = true;
        for (int f = 0; f < shape.factor_count(); ++f) {
          moderate = moderate && shape.degree(f) > 0 && shape.degree(f) < 9;
        }
        const std::size_t each = moderate ? coefficient_count(shape) : 3;
        std::vector<std::int64_t> nodes(each * static_cast<std::size_t>(random.integer(0, 2)) +
                                        (random.chance(97) ? 0 : 1));
        for (std::int64_t& node : nodes)
          node = random.chance(99) ? random.integer(0, 9) : random.integer(-5, 1L << 40);
        builder.add_elements(shape, random.chance(50) ? Basis::lagrange : Basis::bernstein, nodes);
        if (random.chance(10)) builder.drop_elements(static_cast<std::size_t>(random.integer(0, 2)));
        if (random.chance(5)) builder.drop_nodes(static_cast<std::size_t>(random.integer(0, 4)));
        if (random.chance(2))
          builder.origin().element_tags.resize(static_cast<std::size_t>(random.integer(0, 3)));
      }
      const Mesh mesh = std::move(builder).build();
      for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
        const Element element = mesh.element(i);
        REQUIRE(element.shape() == mesh.elements()[i].shape);
      }
      REQUIRE(!mesh.elements().empty());
      ++valid;
    } catch (const MeshError& error) {
      const std::string text = error.what();
      REQUIRE(!text.empty());
      REQUIRE(text.find('\n') == std::string::npos);
      ++refused;
    }
  }
  INFO("seed " << seed << ": " << valid << " valid, " << refused << " refused");
  CHECK(valid > 2000);
  CHECK(refused > 2000);
}
