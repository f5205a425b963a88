// What benchmarks share of gmsh: the meshes, its check; and a clock.
#pragma once

#include <gmsh.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

/// Starts gmsh, quiet and with one thread.
inline void start_gmsh() {
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.HighOrderOptimize", 0);
}

/// A square of side 10, as the current gmsh model, with straight triangles of that side.
inline void mesh_square(double side, bool with_holes) {
  gmsh::model::add(with_holes ? "plate" : "square");
  const int plate = gmsh::model::occ::addRectangle(0, 0, 0, 10, 10);
  if (with_holes) {
    std::vector<std::pair<int, int>> holes;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const double radius = 0.6 + 0.1 * i;
        holes.emplace_back(2, gmsh::model::occ::addDisk(2 + 3 * i, 2 + 3 * j, 0, radius, radius));
      }
    }
    std::vector<std::pair<int, int>> cut;
    std::vector<std::vector<std::pair<int, int>>> origin;
    gmsh::model::occ::cut({{2, plate}}, holes, cut, origin);
  }
  gmsh::model::occ::synchronize();
  gmsh::option::setNumber("Mesh.MeshSizeMin", side);
  gmsh::option::setNumber("Mesh.MeshSizeMax", side);
  gmsh::model::mesh::generate(2);
}

/// A square plate of side 10 with 3 x 3 round holes, with about so many triangles.
inline void make_plate(double triangles) {
  // The plate without holes has area about 82; an equilateral triangle of side h has area 0.433 h^2.
  mesh_square(std::sqrt(82 / (0.433 * triangles)), true);
}

/// gmsh's own check of the current model's surface elements: signs of their Jacobian determinants, in
/// floating point.
inline void analyse_mesh_quality() {
  // Plugins keep what they computed for a view: a new run computes again.
  gmsh::plugin::setNumber("AnalyseMeshQuality", "JacobianDeterminant", 1);
  gmsh::plugin::setNumber("AnalyseMeshQuality", "IGEMeasure", 0);
  gmsh::plugin::setNumber("AnalyseMeshQuality", "ICNMeasure", 0);
  gmsh::plugin::setNumber("AnalyseMeshQuality", "DimensionOfElements", 2);
  gmsh::plugin::setNumber("AnalyseMeshQuality", "Recompute", 1);
  gmsh::plugin::run("AnalyseMeshQuality");
}

/// Wall-clock time of a piece of work.
inline double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
