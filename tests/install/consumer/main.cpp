// The smallest useful program with the installed library: a mesh from arrays, checked with one call.
#include <bezcert/bezcert.hpp>

#include <iostream>

#ifdef CGAL_INTERVAL_NT_H
#error "users see interval code"
#endif

namespace {

// The unit square as two quadratic triangles, the middle node of their diagonal at (x, x).
bezcert::Mesh square(double x) {
  using namespace bezcert;
  const double points[] = {0, 0, .5, 0, 1, 0, 0, .5, x, x, 1, .5, 0, 1, .5, 1, 1, 1};
  const int nodes[] = {0, 1, 2, 3, 4, 6, 8, 7, 6, 5, 4, 2};
  MeshBuilder builder;
  builder.add_nodes_interleaved(points);
  builder.add_elements(Shape::triangle(2), Basis::lagrange, nodes);
  return std::move(builder).build();
}

void show(const bezcert::MeshReport& report) {
  using namespace bezcert;
  std::cout << name(report.mesh.verdict) << '\n';
  for (const BadElement& bad : report.elements.bad) {
    std::cout << "element " << bad.element << ": " << describe(bad.decision) << '\n';
  }
}

}  // namespace

int main() {
  show(bezcert::check_mesh(square(.5)));
  // At corner 1 of element 0, with its corners P_0, P_1, P_2 and middle nodes P_01, P_12: det J there is
  // (P_0 + 3 P_1 - 4 P_01) x (P_0 - P_2 - 4 P_01 + 4 P_12) = (1, 0) x (4 x - 2, 4 x - 1) = 4 x - 1.
  show(bezcert::check_mesh(square(.125)));
  return 0;
}
