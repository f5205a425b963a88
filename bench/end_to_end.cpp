// The whole way of a mesh file to its report, against gmsh's loading and checking of the same file.
//
//   end_to_end [TARGET_TRIANGLES [LARGEST]]     default 80,000 and 1,000,000
//
// gmsh      gmsh::merge and Plugin(AnalyseMeshQuality), JacobianDeterminant only, in this process
// certify   the program itself, started anew: check --format=jsonl -o FILE, with --criteria=none or all
// Wall seconds, the best of three (gmsh) or seven runs; "cpu" is user + system time of the same run, which
// other work on the machine disturbs less. Ratios are ours / gmsh's: below 1 we are faster. Memory is the
// largest resident size that getrusage reports for the child. Then curved triangles of order 3 in growing
// numbers: time against size, with the fitted exponent.
#include "gmsh_mesh.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Cost {
  double wall = 1e300, cpu = 1e300;
  double megabytes = 0;
};

Cost best(const Cost& a, const Cost& b) {
  return {std::min(a.wall, b.wall), std::min(a.cpu, b.cpu), std::max(a.megabytes, b.megabytes)};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Cost run_certify(const fs::path& mesh, const fs::path& report, const std::string& criteria, int jobs) {
  const std::string command =
      std::string(MEASURED_RUN) + " " + CERTIFY + " check --format=jsonl --criteria=" + criteria +
      " --jobs=" + std::to_string(jobs) + " -o " + report.string() + " " + mesh.string();
  fs::remove(report);  // replacing the last run's would be counted
  std::FILE* output = ::popen(command.c_str(), "r");
  Cost cost;
  double kilobytes = 0;
  const bool read =
      output != nullptr && std::fscanf(output, "%lf %lf %lf", &cost.wall, &cost.cpu, &kilobytes) == 3;
  if (!read || ::pclose(output) != 0) {
    std::fprintf(stderr, "end_to_end: certify failed on %s\n", mesh.c_str());
    std::exit(1);
  }
  cost.megabytes = kilobytes / 1024;
  return cost;
}

template <class Work>
Cost timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  work();
  return {seconds_since(start), static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, 0};
}

struct GmshCost {
  Cost load, check;
};

GmshCost run_gmsh(const fs::path& mesh) {
  GmshCost result;
  for (int k = 0; k < 3; ++k) {
    gmsh::model::add("copy");
    const Cost load = timed([&] { gmsh::merge(mesh); });
    const Cost check = timed(analyse_mesh_quality);
    gmsh::model::remove();
    result.load = best(result.load, load);
    result.check = best(result.check, check);
  }
  return result;
}

// What two threads gain on this machine where nothing is shared: multiplications in registers.
void machine_scaling() {
  const auto work = [] {
    volatile double sink = 0;
    double x = 1;
    for (int i = 0; i < 100000000; ++i) x = x * 1.0000001;
    sink = x;
    (void)sink;
  };
  double one = 1e300, two = 1e300;
  for (int k = 0; k < 3; ++k) {
    one = std::min(one, timed(work).wall);
    two = std::min(two, timed([&] {
                          std::thread other(work);
                          work();
                          other.join();
                        }).wall);
  }
  std::printf("this machine: two threads of plain arithmetic do %.2f times the work of one\n", 2 * one / two);
}

// A square grid of k x k cells, each two triangles of order 3, bent by smooth waves: .msh 4.1, ASCII.
std::size_t write_waves(const fs::path& path, int k) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) std::exit(1);
  const int side = 3 * k + 1;
  const std::size_t nodes = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  const std::size_t elements = 2 * static_cast<std::size_t>(k) * static_cast<std::size_t>(k);
  std::fprintf(file, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 %zu 1 %zu\n2 1 0 %zu\n", nodes, nodes,
               nodes);
  for (std::size_t i = 1; i <= nodes; ++i) std::fprintf(file, "%zu\n", i);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double u = static_cast<double>(i) / (side - 1), v = static_cast<double>(j) / (side - 1);
      std::fprintf(file, "%.16g %.16g 0\n", 10 * u + 0.3 * std::sin(9 * v + u),
                   10 * v + 0.3 * std::sin(8 * u - v));
    }
  }
  std::fprintf(file, "$EndNodes\n$Elements\n1 %zu 1 %zu\n2 1 21 %zu\n", elements, elements, elements);
  std::size_t tag = 0;
  for (int j = 0; j < k; ++j) {
    for (int i = 0; i < k; ++i) {
      for (const int turn : {1, -1}) {
        // From a corner of the cell, steps along u and v; the second triangle from the opposite corner.
        const int i0 = 3 * i + (turn > 0 ? 0 : 3), j0 = 3 * j + (turn > 0 ? 0 : 3);
        const int steps[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0},
                                  {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
        std::fprintf(file, "%zu", ++tag);
        for (const auto& step : steps) {
          std::fprintf(file, " %d", (j0 + turn * step[1]) * side + i0 + turn * step[0] + 1);
        }
        std::fputc('\n', file);
      }
    }
  }
  std::fprintf(file, "$EndElements\n");
  std::fclose(file);
  return elements;
}

// The report but for the seconds of its summary.
std::string without_seconds(const fs::path& report) {
  std::ifstream stream(report, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.substr(0, text.rfind("\"seconds\":"));
}

double megabytes(const fs::path& path) { return static_cast<double>(fs::file_size(path)) / (1 << 20); }

// One thread and two in turn, the best of each: a machine whose speed drifts is the same for both.
struct OneAndTwo {
  Cost one, two;
  bool identical = true;

  double gain() const { return one.wall / two.wall; }
  double megabytes() const { return std::max(one.megabytes, two.megabytes); }
};

OneAndTwo one_and_two(const fs::path& mesh, const fs::path& report, const char* criteria) {
  constexpr int runs = 7;
  OneAndTwo result;
  for (int k = 0; k < runs; ++k) {
    result.one = best(result.one, run_certify(mesh, report, criteria, 1));
    const std::string alone = without_seconds(report);
    result.two = best(result.two, run_certify(mesh, report, criteria, 2));
    result.identical = result.identical && alone == without_seconds(report);
  }
  return result;
}

// What every run begins and ends with: a process, its libraries, its threads.
void start_cost(const fs::path& mesh, const fs::path& report) {
  write_waves(mesh, 1);
  const OneAndTwo cost = one_and_two(mesh, report, "none");
  std::printf("a mesh of two triangles: %.4f s, with two threads %.4f s\n", cost.one.wall, cost.two.wall);
}

void plate_row(int order, const char* form, const fs::path& mesh, const fs::path& report) {
  const GmshCost gmsh = run_gmsh(mesh);
  const double wall = gmsh.load.wall + gmsh.check.wall, cpu = gmsh.load.cpu + gmsh.check.cpu;
  std::printf("order %d, %s, %.1f MB: gmsh load %.3f + check %.3f s (cpu %.3f)\n", order, form,
              megabytes(mesh), gmsh.load.wall, gmsh.check.wall, cpu);
  for (const char* criteria : {"none", "all"}) {
    const OneAndTwo ours = one_and_two(mesh, report, criteria);
    std::printf(
        "  criteria %-5s %.3f s (cpu %.3f)  ratio %.2f (cpu %.2f)  two threads %.2f times one, reports %s  "
        "memory %.0f MB = %.2f of the file\n",
        criteria, ours.one.wall, ours.one.cpu, ours.one.wall / wall, ours.one.cpu / cpu, ours.gain(),
        ours.identical ? "identical" : "DIFFER", ours.megabytes(), ours.megabytes() / megabytes(mesh));
    std::fflush(stdout);
  }
}

void growth(double largest, const fs::path& mesh, const fs::path& report) {
  std::printf("curved triangles of order 3, one thread, no criteria; and what two threads gain\n");
  std::vector<std::pair<double, double>> points;  // logarithms of elements and cpu seconds
  for (double n = 1000; n <= largest * 1.01; n *= 10) {
    const auto elements =
        static_cast<double>(write_waves(mesh, static_cast<int>(std::lround(std::sqrt(n / 2)))));
    const OneAndTwo none = one_and_two(mesh, report, "none"), all = one_and_two(mesh, report, "all");
    const Cost& cost = none.one;
    std::printf(
        "  %8.0f elements  %8.3f s (cpu %.3f)  %6.2f us each  memory %5.0f MB = %.2f of the file  "
        "two threads %.2f times one, with all criteria %.2f\n",
        elements, cost.wall, cost.cpu, 1e6 * cost.cpu / elements, none.megabytes(),
        none.megabytes() / megabytes(mesh), none.gain(), all.gain());
    std::fflush(stdout);
    points.emplace_back(std::log(elements), std::log(cost.cpu));
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto count = static_cast<double>(points.size());
  for (const auto& [a, b] : points) {
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  std::printf("  fitted exponent of cpu time %.3f\n", (count * xy - x * y) / (count * xx - x * x));
}

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 80000;
  const double largest = argc > 2 ? std::atof(argv[2]) : 1000000;
  if (!(target >= 100)) {
    std::fprintf(stderr, "end_to_end [TARGET_TRIANGLES [LARGEST]]: at least 100\n");
    return 2;
  }
  const fs::path folder = fs::temp_directory_path() / ("bezcert_end_to_end." + std::to_string(::getpid()));
  fs::create_directory(folder);
  const fs::path mesh = folder / "mesh.msh", report = folder / "report.jsonl";
  machine_scaling();
  start_cost(mesh, report);
  start_gmsh();
  make_plate(target);
  for (const int order : {2, 3, 4}) {
    gmsh::model::setCurrent("plate");
    gmsh::model::mesh::setOrder(order);
    for (const bool binary : {false, true}) {
      gmsh::model::setCurrent("plate");
      gmsh::option::setNumber("Mesh.Binary", binary ? 1 : 0);
      gmsh::write(mesh);
      plate_row(order, binary ? "binary" : "ASCII", mesh, report);
    }
  }
  gmsh::finalize();
  growth(largest, mesh, report);
  fs::remove_all(folder);
  return 0;
}
