// Near edges are a filter that is made early. No pair that meets may be missing: all pairs of boundary edges
// are compared exactly. And obstacles are the same whether near edges are known before or found late.
#include "bezcert/surface/boundary_contacts.hpp"
#include "mesh_sketch.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace bezcert::test {
namespace {

// Squares, each two triangles, at random places of a square with `size` times their side: some apart, some
// not. Half of them have a curved side, bent in or out, or so that it turns back beside its neighbour.
MeshSketch scattered(Random& random, int squares, long size) {
  MeshSketch builder;
  // Multiples of 3, and sides of 12: all control points are doubles.
  const auto quarter = [&](long low, long high) { return 12 * random.rational(low, high, 4); };
  for (int i = 0; i < squares; ++i) {
    const Rational x = quarter(0, size), y = quarter(0, size);
    const auto a = builder.node(x, y), b = builder.node(x + 12, y);
    const auto c = builder.node(x + 12, y + 12), d = builder.node(x, y + 12);
    if (random.chance(50)) {
      const auto bent = [&] { return builder.node(x + quarter(-1, 2), y + quarter(-1, 2) / 2); };
      const auto first = bent(), second = bent();
      builder.curve(a, b, {first, second});
      builder.triangle(a, b, c, 3);
    } else {
      builder.triangle(a, b, c);
    }
    builder.triangle(a, c, d);
  }
  return builder;
}

std::vector<std::string> messages(const Mesh& mesh, const ObstacleList& list) {
  std::vector<std::string> result;
  for (const MeshObstacle& one : list.all()) result.push_back(message(mesh, one));
  return result;
}

}  // namespace

TEST_CASE("near edges hold all contacts, and obstacles do not depend on when they are found") {
  const std::uint64_t seed = seed_or(531);
  Random random(seed);
  int clear = 0, met = 0, contacts = 0, only_near = 0, apart = 0, near_joints = 0, parted_joints = 0;
  for (int i = 0; i < 300; ++i) {
    INFO("seed " << seed << " case " << i);
    const long size = random.chance(30) ? 40 : random.integer(1, 6);
    const Mesh mesh = scattered(random, 6, size).build();
    REQUIRE(mesh.coordinates(0).binary64());
    ObstacleList gluing_obstacles;
    const Surface surface(mesh, gluing_obstacles);
    const auto all = find_near_edges(surface, std::nullopt, 100000);
    REQUIRE(all);
    for (HalfEdge p = 0; p < surface.count(); ++p) {
      for (HalfEdge q = p + 1; q < surface.count(); ++q) {
        if (!surface.is_boundary(p) || !surface.is_boundary(q) || surface.element(p) == surface.element(q))
          continue;
        if (surface.begin(p) == surface.begin(q) || surface.end(p) == surface.end(q)) continue;
        const Joints joints{surface.end(p) == surface.begin(q), surface.begin(p) == surface.end(q)};
        DyadicCurve a = surface.curve(p), b = surface.curve(q);
        const bool meet = find_contact(a, b, joints).status == ContactStatus::contact;
        const bool near = std::find(all->begin(), all->end(), NearEdges{p, q}) != all->end();
        if (meet) REQUIRE(near);
        ++(meet ? contacts : near ? only_near : apart);
        if (joints.end_to_begin || joints.begin_to_end) ++(near ? near_joints : parted_joints);
      }
    }
    for (const std::uint32_t element : {0U, 5U}) {
      std::vector<NearEdges> expected;
      for (const auto& [p, q] : *all) {
        if (surface.element(p) == element || surface.element(q) == element) expected.emplace_back(p, q);
      }
      CHECK(find_near_edges(surface, element, 100000) == expected);
    }
    ObstacleList known, found;
    check_boundary(surface, all, {}, known);
    check_boundary(surface, std::nullopt, {}, found);
    CHECK(messages(mesh, known) == messages(mesh, found));
    ++(known.empty() ? clear : met);
  }
  CHECK(clear > 20);
  CHECK(met > 100);
  CHECK(contacts > 100);
  CHECK(only_near > 100);
  CHECK(apart > 10000);
  CHECK(near_joints > 50);
  CHECK(parted_joints > 1000);
}

TEST_CASE("near edges are given up where too many boxes overlap") {
  Random random(7);
  const Mesh mesh = scattered(random, 6, 1).build();
  ObstacleList none;
  const Surface surface(mesh, none);
  CHECK(find_near_edges(surface, std::nullopt, 100000));
  CHECK_FALSE(find_near_edges(surface, std::nullopt, 20));
}

}  // namespace bezcert::test
