// How long the exact decision takes where det J touches zero or nearly does: the whole corpus of single
// elements, one thread.
//
// Prints the slowest elements, the slowest of each degree, and the time of all relative to the same decision
// without algebra (subdivision to its full budget, which leaves many of them open).
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

using namespace bezcert;

namespace {

struct Row {
  std::string name;
  int degree = 0;
  std::string kind;
  std::string_view verdict, without;
  double seconds = 0, seconds_without = 0;
};

// Best of three.
template <class Work>
double seconds_of(Work work) {
  double best = 1e300;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void print(const Row& row) {
  std::printf("  %9.2f ms  degree %2d  %-22s %-12s %s\n", row.seconds * 1e3, row.degree, row.kind.c_str(),
              std::string(row.verdict).c_str(), row.name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : BEZCERT_SOURCE_DIR "/corpus/elements";
  std::vector<Row> rows;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Budget no_algebra;
  no_algebra.algebra_bits = no_algebra.contact.algebra_bits = 0;
  for (const auto& file : files) {
    const Mesh mesh = read_mesh(file.string(), read_file(file.string()));
    for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
      const Element element = mesh.element(i);
      Row row;
      row.name = file.stem().stem().string();
      row.degree = element.degree();
      row.kind = std::string(element.rational() ? "rational " : "") + kind_name(element);
      row.seconds = seconds_of([&] { row.verdict = name(decide(element).verdict); });
      row.seconds_without =
          seconds_of([&] { row.without = name(decide(Forms(element), no_algebra).verdict); });
      rows.push_back(std::move(row));
    }
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.seconds > b.seconds; });
  std::printf("the slowest of %zu elements\n", rows.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 12); ++i) print(rows[i]);
  std::printf("the slowest of each degree\n");
  std::map<int, Row> worst;
  double all = 0, all_without = 0;
  std::size_t open = 0, open_without = 0;
  for (const Row& row : rows) {
    worst.try_emplace(row.degree, row);
    all += row.seconds;
    all_without += row.seconds_without;
    const auto is_open = [](std::string_view verdict) {
      return verdict == "undecided" || verdict == "regular";
    };
    open += is_open(row.verdict);
    open_without += is_open(row.without);
  }
  for (const auto& [degree, row] : worst) print(row);
  std::printf("all: %.3f s, %zu open; without algebra: %.3f s, %zu open; ratio %.2f\n", all, open,
              all_without, open_without, all_without / all);
}
