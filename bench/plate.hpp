// The mesh that benchmarks share, and a clock.
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

/// A square plate of side 10 with 3 x 3 round holes, as the current gmsh model, with about so many straight
/// triangles.
inline void make_plate(double triangles) {
  gmsh::model::add("plate");
  const int plate = gmsh::model::occ::addRectangle(0, 0, 0, 10, 10);
  std::vector<std::pair<int, int>> holes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      holes.emplace_back(2, gmsh::model::occ::addDisk(2 + 3 * i, 2 + 3 * j, 0, 0.6 + 0.1 * i, 0.6 + 0.1 * i));
    }
  }
  std::vector<std::pair<int, int>> cut;
  std::vector<std::vector<std::pair<int, int>>> origin;
  gmsh::model::occ::cut({{2, plate}}, holes, cut, origin);
  gmsh::model::occ::synchronize();
  // The plate without holes has area about 82; an equilateral triangle of side h has area 0.433 h^2.
  const double size = std::sqrt(82 / (0.433 * triangles));
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::model::mesh::generate(2);
}

/// Wall-clock time of a piece of work.
inline double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
