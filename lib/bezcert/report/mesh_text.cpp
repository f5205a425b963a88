#include "bezcert/report/mesh_text.hpp"

#include "bezcert/io/printable.hpp"
#include "bezcert/report/obstacle_text.hpp"

namespace bezcert {
namespace {

constexpr std::size_t longest_exact_text = 40;

std::string count_text(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string area_text(const AreaBounds& area) {
  if (!area.is_exact()) {
    return "area from " + to_decimal(to_rational(round_down(area.lower, area_bits))) + " to " +
           to_decimal(to_rational(round_up(area.upper, area_bits)));
  }
  const std::string decimal = to_decimal(area.lower), exact_text = to_string(area.lower);
  if (decimal == exact_text) return "area " + decimal;
  return "area " + decimal + (exact_text.size() <= longest_exact_text ? " (exactly " + exact_text + ")" : "");
}

}  // namespace

std::string describe(const Mesh& mesh, const MeshObstacle& obstacle) {
  const std::string cause = hint(obstacle);
  return message(mesh, obstacle) + (cause.empty() ? "" : "; " + cause);
}

std::vector<std::string> mesh_lines(const Mesh& mesh, const MeshResult& result) {
  std::vector<std::string> lines;
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    if (obstacle.kind() == MeshVerdict::invalid_element) continue;  // each has a line of its own already
    lines.push_back(std::string(name(obstacle.kind())) + ": " + describe(mesh, obstacle));
  }
  for (const MeshVerdict kind : {MeshVerdict::non_manifold, MeshVerdict::non_conforming,
                                 MeshVerdict::folded_vertex, MeshVerdict::overlapping_boundary}) {
    const std::size_t count = result.obstacles.count(kind);
    if (count > ObstacleList::kept) {
      lines.push_back(std::string(name(kind)) + ": " + std::to_string(count - ObstacleList::kept) + " more");
    }
  }
  std::string line =
      "mesh: " + std::string(name(result.verdict)) + ", " + count_text(result.components, "component");
  if (result.holes) line += ", " + count_text(*result.holes, "hole");
  if (result.loops) line += ", " + count_text(*result.loops, "boundary loop");
  if (result.area) line += ", " + area_text(*result.area);
  lines.push_back(line);
  return lines;
}

std::vector<std::string> domain_lines(const Mesh& mesh, const std::string& file, const DomainResult& domain) {
  std::vector<std::string> lines;
  const std::string title = "domain " + file + ": ";
  for (const DomainFailure& failure : domain.failures) {
    std::string line = title + "curve " + std::to_string(failure.curve + 1);
    if (!failure.curve_name.empty()) line += " \"" + printable(failure.curve_name, 80) + "\"";
    line += " is covered up to t = " + to_decimal(failure.parameter) + " only, at " + text_of(failure.point) +
            ": " + message(mesh, failure);
    lines.push_back(line);
  }
  lines.push_back(title + (domain.conforming() ? "conforming, " : "not_conforming, ") +
                  std::to_string(domain.covered) + " of " + count_text(domain.curves, "curve") + " covered");
  return lines;
}

}  // namespace bezcert
