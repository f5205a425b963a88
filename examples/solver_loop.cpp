// Checks a mesh that a solver holds in arrays, step after step, while its nodes move.
//
// A ring of quadratic triangles is sheared more and more, until some of them fold. Nothing is written to a
// file; the check reads the solver's own arrays.
#include <bezcert/bezcert.hpp>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

namespace {

// What a solver has: points x0, y0, x1, y1, ... and six node numbers a triangle, in the order that bezcert
// uses: corner 0, the middle of edge 0-1, corner 1, the middle of 0-2, the middle of 1-2, corner 2.
struct SolverMesh {
  std::vector<double> points;
  std::vector<std::int64_t> nodes;
};

// n by n squares on the unit square, each cut in two triangles.
SolverMesh unit_square(int n) {
  SolverMesh mesh;
  const int side = 2 * n + 1;
  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      mesh.points.push_back(c / (2.0 * n));
      mesh.points.push_back(r / (2.0 * n));
    }
  }
  const auto at = [&](int r, int c) { return static_cast<std::int64_t>(r) * side + c; };
  for (int r = 0; r < 2 * n; r += 2) {
    for (int c = 0; c < 2 * n; c += 2) {
      mesh.nodes.insert(mesh.nodes.end(),
                        {at(r, c), at(r, c + 1), at(r, c + 2), at(r + 1, c), at(r + 1, c + 1), at(r + 2, c)});
      mesh.nodes.insert(mesh.nodes.end(), {at(r + 2, c + 2), at(r + 2, c + 1), at(r + 2, c), at(r + 1, c + 2),
                                           at(r + 1, c + 1), at(r, c + 2)});
    }
  }
  return mesh;
}

// Moves every node to the right by a wave of its height.
std::vector<double> moved(const std::vector<double>& points, double amplitude) {
  std::vector<double> result = points;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    result[i] += amplitude * std::sin(9 * points[i + 1]) * std::sin(7 * points[i]);
  }
  return result;
}

}  // namespace

int main() {
  using namespace bezcert;
  const SolverMesh solver = unit_square(8);
  for (int step = 0; step <= 4; ++step) {
    MeshBuilder builder;
    builder.add_nodes_interleaved(moved(solver.points, 0.06 * step));
    builder.add_elements(Shape::triangle(2), Basis::lagrange, solver.nodes);
    const Mesh mesh = std::move(builder).build();  // throws MeshError if the arrays do not fit each other

    const MeshReport report = check_mesh(mesh);
    const ElementCounts& counts = report.elements.counts;
    std::cout << "step " << step << ": " << counts.count(ElementVerdict::injective) << " of "
              << counts.elements << " elements are injective, mesh: " << name(report.mesh.verdict) << '\n';
    if (report.outcome() == Outcome::certified) continue;

    // A solver would go back to half of the step. The witness says where.
    const BadElement& bad = report.elements.bad.front();
    std::cout << "  the first bad element is " << bad.element << ": " << describe(bad.decision) << '\n';
  }
  return 0;
}
