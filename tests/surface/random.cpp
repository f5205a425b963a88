// Random embeddings stay embeddings under affine maps and relabelling; one moved point breaks them.
//
// A grid of cells of size 8, corner nodes moved by up to 1/2 and inner control points of edges by up to 3/8:
// control polygons of grid lines then climb by less than they advance, so that edges along different
// directions or lines meet in common nodes only, and the mesh is an embedding as soon as its elements are
// injective.
#include "mesh_sketch.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace bezcert::test {
namespace {

using Node = MeshSketch::Node;

struct Grid {
  MeshSketch builder;
  int wide = 0, high = 0, degree = 1;
  std::map<std::pair<int, int>, Node> at;
  std::map<std::pair<int, int>, std::vector<Node>>
      across;                                       // inner nodes of the edge from (i, j) to (i + 1, j)
  std::map<std::pair<int, int>, std::size_t> cell;  // the element (the lower of two triangles) of a cell
};

// Cells of column 1 above row 0 are left out if `slot`.
Grid random_grid(Random& random, bool slot) {
  Grid grid;
  grid.wide = 3;
  grid.high = static_cast<int>(random.integer(2, 3));
  grid.degree = static_cast<int>(random.integer(1, 3));
  MeshSketch& b = grid.builder;
  const bool rational = random.chance(30);
  const auto weight = [&] { return rational ? 1 + random.rational(0, 1, 4) / 2 : Rational(1); };
  const auto moved = [&](const Rational& x, int eighths) {
    return Rational(x + Rational(random.integer(-eighths, eighths), 8));
  };
  for (int j = 0; j <= grid.high; ++j) {
    for (int i = 0; i <= grid.wide; ++i) grid.at[{i, j}] = b.node(moved(8 * i, 4), moved(8 * j, 4), weight());
  }
  const auto bend = [&](Node from, Node to) {
    std::vector<Node> inner;
    for (int k = 1; k < grid.degree; ++k) {
      const Rational t(k, grid.degree);
      inner.push_back(b.node(moved((1 - t) * b.x(from) + t * b.x(to), 3),
                             moved((1 - t) * b.y(from) + t * b.y(to), 3), weight()));
    }
    b.curve(from, to, inner);
    return inner;
  };
  for (const auto& [place, node] : grid.at) {
    const auto [i, j] = place;
    if (i < grid.wide) grid.across[place] = bend(node, grid.at[{i + 1, j}]);
    if (j < grid.high) bend(node, grid.at[{i, j + 1}]);
  }
  for (int j = 0; j < grid.high; ++j) {
    for (int i = 0; i < grid.wide; ++i) {
      if (slot && i == 1 && j > 0) continue;
      const Node p = grid.at[{i, j}], q = grid.at[{i + 1, j}], r = grid.at[{i + 1, j + 1}],
                 s = grid.at[{i, j + 1}];
      if (random.chance(50)) {
        grid.cell[{i, j}] = b.triangle(p, q, r, grid.degree);
        b.triangle(p, r, s, grid.degree);
      } else {
        grid.cell[{i, j}] = b.quad(p, q, r, s, grid.degree, grid.degree);
      }
    }
  }
  return grid;
}

void transform(MeshSketch& builder, const std::array<Rational, 6>& m) {
  for (Node n = 0; n < builder.node_count(); ++n) {
    const Rational x = builder.x(n), y = builder.y(n);
    builder.x(n) = m[0] * x + m[1] * y + m[4];
    builder.y(n) = m[2] * x + m[3] * y + m[5];
  }
}

// The same mesh with its nodes and elements in another order.
Mesh relabelled(const MeshSketch& builder, Random& random) {
  std::vector<Node> to(builder.node_count());
  std::vector<std::size_t> order(builder.elements().size());
  for (Node n = 0; n < to.size(); ++n) to[n] = n;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto shuffle = [&](auto& values) {
    for (std::size_t i = values.size(); i-- > 1;) {
      std::swap(values[i], values[static_cast<std::size_t>(random.integer(0, static_cast<long>(i)))]);
    }
  };
  shuffle(to);
  shuffle(order);
  MeshParts mesh(builder.build(true, order));
  std::vector<Rational> x(to.size()), y(to.size()), w(to.size());
  for (Node n = 0; n < to.size(); ++n) {
    x[to[n]] = mesh.x[n];
    y[to[n]] = mesh.y[n];
    if (!mesh.weights.empty()) w[to[n]] = mesh.weights[n];
  }
  mesh.x = ExactVector(x);
  mesh.y = ExactVector(y);
  if (!mesh.weights.empty()) mesh.weights = ExactVector(w);
  for (Node& n : mesh.connectivity) n = to[n];
  return mesh.build();
}

bool has_invalid_elements(const Examined& result) {
  return result.obstacles.count(MeshVerdict::invalid_element) > 0;
}

}  // namespace

TEST_CASE("random embeddings stay so under affine maps and relabelling") {
  const std::uint64_t seed = seed_or(20260103);
  Random random(seed);
  int embeddings = 0, invalid = 0, rational = 0, mirrored = 0;
  for (int n = 0; n < 120; ++n) {
    Grid grid = random_grid(random, random.chance(50));
    const Mesh mesh = grid.builder.build();
    const Examined result = examine(mesh);
    INFO("seed " << seed << " case " << n << ": " << text_of(result));
    if (has_invalid_elements(result)) {
      ++invalid;
      continue;
    }
    REQUIRE(result.verdict == MeshVerdict::embedding);
    ++embeddings;
    rational += result.area->is_exact() ? 0 : 1;
    CHECK(result.holes == std::size_t{0});

    const Examined other = examine(relabelled(grid.builder, random));
    CHECK(other.verdict == MeshVerdict::embedding);
    CHECK(examine(grid.builder.build(false)).verdict == MeshVerdict::embedding);
    if (result.area->is_exact()) CHECK(other.area->lower == result.area->lower);

    std::array<Rational, 6> m;
    for (Rational& value : m) value = random.rational(-3, 3, 7);
    const Rational determinant = m[0] * m[3] - m[1] * m[2];
    if (determinant.sign() == 0) continue;
    transform(grid.builder, m);
    const Examined image = examine(grid.builder.build());
    if (determinant.sign() < 0) {
      ++mirrored;
      CHECK(image.verdict == MeshVerdict::invalid_element);
      continue;
    }
    CHECK(image.verdict == MeshVerdict::embedding);
    if (result.area->is_exact()) CHECK(image.area->lower == determinant * result.area->lower);
  }
  CAPTURE(embeddings, invalid, rational, mirrored);
  CHECK(embeddings > 70);
  CHECK(rational > 10);
  CHECK(mirrored > 20);
}

TEST_CASE("one control point moved on one side of an edge breaks an embedding") {
  const std::uint64_t seed = seed_or(20260104);
  Random random(seed);
  int broken = 0, invalid = 0;
  for (int n = 0; n < 80; ++n) {
    Grid grid = random_grid(random, false);
    if (grid.degree == 1 || has_invalid_elements(examine(grid.builder.build()))) continue;
    // The lower edge of a cell in row 1, as the cell sees it.
    const int column = static_cast<int>(random.integer(0, 2));
    const Node from = grid.across[{column, 1}].front();
    MeshSketch& b = grid.builder;
    const Rational step(1, Integer(1) << static_cast<unsigned>(random.integer(3, 60)));
    b.replace(grid.cell[{column, 1}], from, b.node(b.x(from) + step, b.y(from) - step, b.weight(from)));
    const Examined result = examine(b.build());
    INFO("seed " << seed << " case " << n << ": " << text_of(result));
    if (has_invalid_elements(result)) {
      ++invalid;
      continue;
    }
    CHECK(result.verdict == MeshVerdict::non_conforming);
    const MeshObstacle obstacle = first_obstacle(result);
    CHECK(obstacle.elements.size() == 2);
    REQUIRE(obstacle.distance);
    CHECK(sign(obstacle.distance->lower) > 0);
    CHECK(to_rational(obstacle.distance->lower) <= 2 * step);
    CHECK(result.obstacles.count(MeshVerdict::non_conforming) == 1);
    ++broken;
  }
  CAPTURE(broken, invalid);
  CHECK(broken > 20);
}

TEST_CASE("a boundary point moved across a slot and over an edge breaks an embedding") {
  const std::uint64_t seed = seed_or(20260105);
  Random random(seed);
  int overlapping = 0, invalid = 0;
  for (int n = 0; n < 60; ++n) {
    Grid grid = random_grid(random, true);
    if (has_invalid_elements(examine(grid.builder.build()))) continue;
    // The top right corner of column 0 goes 11 to the right, 3 beyond the edge on the other side of the slot;
    // inner points of the edges that end there stay.
    const Node corner = grid.at[{1, grid.high}];
    grid.builder.x(corner) += 11;
    const Examined result = examine(grid.builder.build());
    INFO("seed " << seed << " case " << n << ": " << text_of(result));
    if (has_invalid_elements(result)) {
      ++invalid;
      continue;
    }
    CHECK(result.verdict == MeshVerdict::overlapping_boundary);
    ++overlapping;
  }
  CAPTURE(overlapping, invalid);
  CHECK(overlapping > 15);
}

}  // namespace bezcert::test
