// What the mesh's verdict takes from doubles directly: signs of tangents, and areas. Against exact
// arithmetic.
#include "bezcert/surface/loop_area.hpp"
#include "bezcert/surface/polynomial_area.hpp"
#include "random_input.hpp"
#include "mesh_parts.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// One element with nodes of its own: near a corner of an even grid, or anywhere.
Mesh random_mesh(Random& random) {
  MeshParts mesh;
  const bool triangle = random.chance(70);
  const int p = static_cast<int>(random.integer(1, 7));
  const Shape shape{triangle ? Domain::triangle : Domain::square, p,
                    triangle ? 0 : static_cast<int>(random.integer(1, 4))};
  const bool bent = random.chance(50);
  const bool level =
      random.chance(40);  // tangents nearly along an axis: straight, or as differences of larger terms
  const double origin = random.chance(30) ? random.any_double(0, 30) : 0;
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      double x = origin + c / 3.0, y = origin + r / 3.0;
      if (!level) {
        x += random.any_double(-4, 0);
        y += random.any_double(-4, 0);
      } else {
        if (bent) {
          x += 0.1 * r * r / (p * p);
          y += 0.1 * c * c / (p * p);
        }
        if (random.chance(50)) y = std::nextafter(y, random.chance(50) ? 1e300 : -1e300);
      }
      mesh.coordinates(0).push_back(x);
      mesh.coordinates(1).push_back(y);
      mesh.connectivity().push_back(static_cast<std::uint32_t>(mesh.connectivity().size()));
    }
  }
  mesh.elements().push_back({shape, random.chance(60) ? Basis::lagrange : Basis::bernstein, 0});
  return mesh.build();
}

// The area beside an edge from its exact control points: the sum of all products with their integrals.
Rational area_beside(const CurveNet<Integer>& net) {
  const auto n = static_cast<int>(net.size()) - 1;
  const auto binomial = [](int a, int b) {
    Rational result = 1;
    for (int k = 1; k <= b; ++k) result = result * (a - b + k) / k;
    return result;
  };
  // The integral of B_i^n B_j^(n-1) is C(n,i) C(n-1,j) / C(2n-1,i+j) / (2n).
  Rational sum = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Integer cross = net.x[a] * (net.y[b + 1] - net.y[b]) - net.y[a] * (net.x[b + 1] - net.x[b]);
      sum += Rational(cross) * n * binomial(n, i) * binomial(n - 1, j) / binomial(2 * n - 1, i + j) / (2 * n);
    }
  }
  return sum / Rational(Integer(2 * net.w[0] * net.w[0]));
}

void attack_tangents(std::uint64_t seed, int elements) {
  Random random(seed);
  std::map<int, int> known;
  int unknown = 0;
  for (int i = 0; i < elements; ++i) {
    const Mesh mesh = random_mesh(random);
    const HalfEdges edges(mesh);
    INFO("seed " << seed << " case " << i);
    for (HalfEdge h = 0; h < edges.count(); ++h) {
      for (const End end : {End::begin, End::end}) {
        const Vector2<Integer> exact = edges.exact_tangent(h, end);
        for (const int coordinate : {0, 1}) {
          const auto found = edges.double_tangent(h, end, coordinate);
          const std::optional<int> sign =
              found ? certain_sign(std::get<0>(found->operands), found->error) : std::nullopt;
          if (sign) REQUIRE(*sign == (coordinate == 0 ? exact.x : exact.y).sign());
          ++(sign ? known[*sign] : unknown);
        }
      }
    }
  }
  INFO("seed " << seed << ": unknown " << unknown << ", zero " << known[0]);
  CHECK(unknown > elements / 8);
  CHECK(known[0] > elements / 8);
  CHECK(known[1] > elements * 5 / 2);
  CHECK(known[-1] > elements * 5 / 2);
}

}  // namespace

// 12 signs a triangle, 16 a quadrilateral.
TEST_CASE("signs of tangents from doubles are exact: 200,000 cases") { attack_tangents(seed_or(511), 16000); }

TEST_CASE("signs of tangents from doubles are exact: 10 million cases", "[.nightly]") {
  attack_tangents(seed_or(513), 800000);
}

TEST_CASE("areas from doubles are exact") {
  const std::uint64_t seed = seed_or(512);
  Random random(seed);
  for (int i = 0; i < 600; ++i) {
    const Mesh mesh = random_mesh(random);
    const HalfEdges edges(mesh);
    BoundaryLoop loop;
    Rational expected = 0;
    for (HalfEdge h = 0; h < edges.count(); ++h) {
      loop.edges.push_back(h);
      REQUIRE(has_plain_area(edges, h));
      expected += area_beside(edges.exact(h));
    }
    INFO("seed " << seed << " case " << i);
    REQUIRE(plain_area(edges, loop.edges) == expected);
    REQUIRE(loop_area(edges, loop).bounds.lower == expected);
  }
}
