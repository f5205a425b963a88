// The exact decision against gmsh's AnalyseMeshQuality, elements a second, on meshes of several kinds.
//
//   decide_rate [TARGET_TRIANGLES [FIRST_ORDER LAST_ORDER]]
//
// "decide" are final verdicts with the bounds of det J that a report shows. Rates are the best of several
// runs, in one process, one thread, the mesh in memory. Also: how many elements blocks, intervals and
// integers decided; what an element costs that needs integers; rational triangles against polynomial ones;
// and time against the number of elements.
#include "bezcert/check/mesh_decider.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"

#include "gmsh_mesh.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <random>

using namespace bezcert;

namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The best of at least three runs, and of as many as half a second holds: other work on the machine then hits
// long and short runs alike.
double best_of_runs(const std::function<void()>& work) {
  double best = 1e300, total = 0;
  for (int k = 0; k < 3 || (total < 0.5 && k < 200); ++k) {
    const double time = seconds(work);
    total += time;
    best = std::min(best, time);
  }
  return best;
}

struct Outcome {
  DecisionCounts counts;
  std::size_t injective = 0;
  std::size_t valid_above = 0;        // elements that are injective with min/max det J above 1e-6
  std::size_t valid_above_exact = 0;  // ... of which needed integers
};

Outcome decide_all(const Mesh& mesh) {
  Outcome outcome;
  outcome.counts =
      MeshDecider(mesh).decide_range(0, mesh.elements().size(), [&](std::size_t, const Decision& decision) {
        outcome.injective += decision.verdict == ElementVerdict::injective;
      });
  return outcome;
}

double to_double(const Dyadic& d) {
  return std::ldexp(static_cast<double>(d.mantissa), static_cast<int>(d.exponent));
}

// The filter's failure rate, element by element.
void count_failures(const Mesh& mesh, Outcome& outcome) {
  const MeshDecider decider(mesh);
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    bool above = false;
    const DecisionCounts counts = decider.decide_range(i, i + 1, [&](std::size_t, const Decision& decision) {
      above = decision.verdict == ElementVerdict::injective &&
              to_double(decision.bounds.min_lower) > 1e-6 * to_double(decision.bounds.max_upper);
    });
    outcome.valid_above += above;
    outcome.valid_above_exact += above && counts.exact > 0;
  }
}

double gmsh_check() { return best_of_runs(analyse_mesh_quality); }

using Move = std::function<void(std::size_t, double&, double&)>;

void move_nodes(const Move& move) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    double x = coordinates[3 * i], y = coordinates[3 * i + 1];
    move(i, x, y);
    gmsh::model::mesh::setNode(tags[i], {x, y, 0}, {});
  }
}

// The square bent to three quarters of an annulus between two wavy curves: every element is curved.
void bend(std::size_t, double& x, double& y) {
  const double angle = -1.5 * M_PI * x / 10;
  const double inner = 3 + 0.2 * std::sin(7 * angle), outer = 8 + 0.4 * std::sin(5 * angle + 1);
  const double radius = inner + (outer - inner) * y / 10;
  x = radius * std::cos(angle);
  y = radius * std::sin(angle);
}

// A random smooth displacement as of an elastic body: eight waves, 4 to 12 elements long, each with a strain
// of 6%. The displaced map keeps det J > 0: the strains add up to less than one half in each entry.
Move elastic(std::mt19937_64& random, double side) {
  struct Wave {
    double kx, ky, phase, dx, dy;
  };
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Wave> waves;
  for (int i = 0; i < 8; ++i) {
    const double k = 2 * M_PI / (side * (4 + 8 * any(random)));
    const double along = 2 * M_PI * any(random), towards = 2 * M_PI * any(random);
    const double size = 0.06 / k;
    waves.push_back({k * std::cos(along), k * std::sin(along), 2 * M_PI * any(random),
                     size * std::cos(towards), size * std::sin(towards)});
  }
  return [waves](std::size_t, double& x, double& y) {
    const double x0 = x, y0 = y;
    for (const Wave& w : waves) {
      const double s = std::sin(w.kx * x0 + w.ky * y0 + w.phase);
      x += w.dx * s;
      y += w.dy * s;
    }
  };
}

Mesh written_and_read(const std::string& path) {
  gmsh::write(path);
  return read_mesh(path, read_file(path));
}

void report(const char* kind, int order, const Mesh& mesh, double gmsh_seconds) {
  Outcome outcome;
  const double ours = best_of_runs([&] { outcome = decide_all(mesh); });
  count_failures(mesh, outcome);
  const auto count = static_cast<double>(mesh.elements().size());
  std::printf("%-10s %5d %8zu %8zu %9.0fk %9.0fk %6.2f  %8zu %7zu %6zu   %zu of %zu\n", kind, order,
              mesh.elements().size(), mesh.elements().size() - outcome.injective, count / gmsh_seconds / 1e3,
              count / ours / 1e3, gmsh_seconds / ours, outcome.counts.batch, outcome.counts.interval,
              outcome.counts.exact, outcome.valid_above_exact, outcome.valid_above);
  std::fflush(stdout);
}

void against_gmsh(double target, int first_order, int last_order, const std::string& path) {
  std::printf(
      "mesh       order elements  invalid      gmsh     decide  ratio   (blocks interval exact)  integers "
      "needed, min/max det J > 1e-6\n");
  make_plate(target);
  for (int order = first_order; order <= last_order; ++order) {
    gmsh::model::mesh::setOrder(order);
    report("plate", order, written_and_read(path), gmsh_check());
  }
  gmsh::model::remove();
  const double side = std::sqrt(100 / (0.433 * target));
  for (int order = first_order; order <= last_order; ++order) {
    mesh_square(side, false);
    gmsh::model::mesh::setOrder(order);
    move_nodes(bend);
    report("annulus", order, written_and_read(path), gmsh_check());
    std::mt19937_64 random(5);
    move_nodes(elastic(random, side));
    report("perturbed", order, written_and_read(path), gmsh_check());
    // So many nodes far away that about 1% of the elements fold.
    // A mesh has order^2 / 2 nodes a triangle, and most nodes lie in two or one.
    std::uniform_int_distribution<int> die(1, 80 * order * order);
    move_nodes([&](std::size_t, double& x, double&) {
      if (die(random) == 1) x += 1.2 * side / order;
    });
    report("1% folded", order, written_and_read(path), gmsh_check());
    gmsh::model::remove();
  }
}

// Triangles on a grid of the unit square, mapped by a smooth map; control points in the Bernstein basis.
Mesh grid_mesh(int degree, std::size_t triangles, bool rational) {
  MeshBuilder mesh;
  const auto cells = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(triangles) / 2)));
  const int n = cells * degree;
  const double h = 1.0 / n;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double u = i * h, v = j * h;
      // Corners have weight 1, the points between them weights as of circular arcs, from 0.75 on.
      const bool corner = i % degree == 0 && j % degree == 0;
      std::optional<double> weight;
      if (rational) weight = corner ? 1 : 0.875 + 0.125 * std::sin(3 * u + 40 * v);
      mesh.add_node({u + 0.1 * v * v + 0.02 * std::sin(6 * v), v + 0.1 * u * u}, weight);
    }
  }
  const auto node = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int J = 0; J < cells; ++J) {
    for (int I = 0; I < cells; ++I) {
      for (const int sign : {1, -1}) {
        std::vector<std::uint32_t> nodes;
        const int i0 = (sign > 0 ? I : I + 1) * degree, j0 = (sign > 0 ? J : J + 1) * degree;
        for (int r = 0; r <= degree; ++r) {
          for (int c = 0; c <= degree - r; ++c) nodes.push_back(node(i0 + sign * c, j0 + sign * r));
        }
        mesh.add_elements(Shape::triangle(degree), Basis::bernstein, nodes);
        if (mesh.elements().size() == triangles) return std::move(mesh).build();
      }
    }
  }
  return std::move(mesh).build();
}

void rational_against_polynomial() {
  std::printf("\nrational triangles: elements a second, against polynomial ones of the same degree\n");
  for (int degree = 2; degree <= 4; ++degree) {
    const Mesh polynomial = grid_mesh(degree, 50000, false), rational = grid_mesh(degree, 50000, true);
    Outcome p, r;
    const double one = best_of_runs([&] { p = decide_all(polynomial); });
    const double two = best_of_runs([&] { r = decide_all(rational); });
    std::printf("  degree %d: %.0fk and %.0fk, ratio %.2f (blocks: %zu, %zu; injective %zu, %zu)\n", degree,
                50000 / two / 1e3, 50000 / one / 1e3, one / two, r.counts.batch, p.counts.batch, r.injective,
                p.injective);
  }
}

void cost_of_exact() {
  std::printf("\none element: microseconds by blocks, by intervals (no block), by integers alone\n");
  for (int degree = 1; degree <= 8; ++degree) {
    const Mesh mesh = grid_mesh(degree, 2000, false);
    const double blocks = best_of_runs([&] { decide_all(mesh); });
    const auto one_by_one = [&](Filter filter) {
      return best_of_runs([&] {
        for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
          const Element element = mesh.element(i);
          decide(Forms(element, filter));
        }
      });
    };
    const double intervals = one_by_one(Filter::on), integers = one_by_one(Filter::off);
    std::printf("  degree %d: %8.3f %8.2f %8.1f\n", degree, blocks * 1e6 / 2000, intervals * 1e6 / 2000,
                integers * 1e6 / 2000);
  }
}

void linearity() {
  std::printf("\ntime against the number of elements, degree 3\n");
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  int points = 0;
  for (const std::size_t count : {1000, 10000, 100000, 1000000}) {
    const Mesh mesh = grid_mesh(3, count, false);
    const double time = best_of_runs([&] { decide_all(mesh); });
    std::printf("  %8zu elements: %.6f s, %.0f ns each\n", count, time,
                time * 1e9 / static_cast<double>(count));
    const double x = std::log(static_cast<double>(count)), y = std::log(time);
    sx += x, sy += y, sxx += x * x, sxy += x * y, ++points;
  }
  std::printf("  fitted exponent %.3f\n", (points * sxy - sx * sy) / (points * sxx - sx * sx));
}

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 80000;
  const int first = argc > 2 ? std::atoi(argv[2]) : 2, last = argc > 3 ? std::atoi(argv[3]) : 6;
  if (!(target >= 100) || first < 1 || last > 10) {
    std::cerr << "decide_rate [TARGET_TRIANGLES [FIRST_ORDER LAST_ORDER]]: at least 100, orders 1 to 10\n";
    return 2;
  }
  rational_against_polynomial();
  cost_of_exact();
  linearity();
  start_gmsh();
  std::printf("\n");
  against_gmsh(target, first, last,
               (std::filesystem::temp_directory_path() / "bezcert_decide_rate.msh").string());
  std::filesystem::remove(std::filesystem::temp_directory_path() / "bezcert_decide_rate.msh");
  gmsh::finalize();
  return 0;
}
