// Elements per second of the exact decision against gmsh's plugin AnalyseMeshQuality (JacobianDeterminant
// only, floating point, no guarantee), in one process, one thread and one run.
//
//   check_vs_gmsh [TARGET_TRIANGLES]     default 80,000
//
// The mesh is made on the spot by gmsh: a plate with 9 holes, triangles of order 2, 3 and 4. What is timed:
//   gmsh      Plugin(AnalyseMeshQuality), all elements of dimension 2, mesh in memory; its own checks stored
//   decide    mesh in memory -> exact decisions (the verdict `injective` or a witness)
//   check     the same with the statuses of all criteria
//   load      reading the ASCII .msh 4.1 into memory: gmsh::merge, and read_file + read_mesh
// Each is the best of three. Ratios are ours / gmsh's in elements a second: above 1 we are faster.
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/check/mesh_decider.hpp"
#include "bezcert/check/cross_check.hpp"
#include "gmsh_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>

using namespace bezcert;

namespace {

double best_of_three(const std::function<void()>& work) {
  double best = 1e300;
  for (int k = 0; k < 3; ++k) best = std::min(best, seconds(work));
  return best;
}

struct Outcome {
  std::size_t injective = 0;
  std::size_t other = 0;
  std::size_t exact = 0;  // elements that needed exact arithmetic
};

Outcome decide_all(const Mesh& mesh) {
  Outcome outcome;
  const DecisionCounts counts =
      MeshDecider(mesh).decide_range(0, mesh.elements().size(), [&](std::size_t, const Decision& decision) {
        ++(decision.verdict == ElementVerdict::injective ? outcome.injective : outcome.other);
      });
  outcome.exact = counts.exact;
  return outcome;
}

void check_all(const Mesh& mesh, const std::vector<const Criterion*>& all) {
  constexpr std::size_t block = 256;
  for (std::size_t i = 0; i < mesh.elements().size(); i += block) {
    cross_check_elements(mesh, i, std::min(i + block, mesh.elements().size()), all, {}, Filter::on,
                         [](std::size_t, const CheckedElement&) {});
  }
}

void run_order(int order, const std::string& path) {
  gmsh::model::mesh::setOrder(order);
  gmsh::write(path);
  const double gmsh_check = best_of_three(analyse_mesh_quality);

  Mesh mesh = read_mesh(path, read_file(path));
  const double our_load = best_of_three([&] { mesh = read_mesh(path, read_file(path)); });
  Outcome outcome;
  const double our_decide = best_of_three([&] { outcome = decide_all(mesh); });
  std::vector<const Criterion*> all;
  for (const Criterion& criterion : criteria()) all.push_back(&criterion);
  const double our_check = best_of_three([&] { check_all(mesh, all); });

  std::string current;
  gmsh::model::getCurrent(current);
  const double gmsh_load = best_of_three([&] {
    gmsh::model::add("copy");
    gmsh::merge(path);
    gmsh::model::remove();
  });
  gmsh::model::setCurrent(current);

  const auto count = static_cast<double>(mesh.elements().size());
  std::printf("order %d, %zu triangles (%zu injective, %zu other, %zu needed exact arithmetic)\n", order,
              mesh.elements().size(), outcome.injective, outcome.other, outcome.exact);
  std::printf("  gmsh AnalyseMeshQuality %10.0f elements/s\n", count / gmsh_check);
  std::printf("  decide                  %10.0f elements/s   ratio %.2f\n", count / our_decide,
              gmsh_check / our_decide);
  std::printf("  check, all criteria     %10.0f elements/s   ratio %.2f\n", count / our_check,
              gmsh_check / our_check);
  std::printf("  load: gmsh %.2f s, ours %.2f s                ratio %.2f\n", gmsh_load, our_load,
              gmsh_load / our_load);
  std::printf("  load + decide / gmsh's load + check           ratio %.2f\n",
              (gmsh_load + gmsh_check) / (our_load + our_decide));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 80000;
  if (!(target >= 100)) {
    std::cerr << "check_vs_gmsh [TARGET_TRIANGLES]: at least 100\n";
    return 2;
  }
  start_gmsh();
  make_plate(target);
  const std::string path = (std::filesystem::temp_directory_path() / "bezcert_check_vs_gmsh.msh").string();
  for (const int order : {2, 3, 4}) run_order(order, path);
  std::filesystem::remove(path);
  gmsh::finalize();
  return 0;
}
