#include "bezcert/report/mesh_json.hpp"

#include "bezcert/report/mesh_text.hpp"
#include "bezcert/report/obstacle_text.hpp"

namespace bezcert {
namespace {

Json point_array(const Point& point) { return Json::array({to_string(point.x), to_string(point.y)}); }

Json element_numbers(const Mesh& mesh, const std::vector<std::uint32_t>& elements) {
  Json result = Json::array();
  for (const std::uint32_t element : elements) result.push_back(mesh.origin().number(element));
  return result;
}

Json node_numbers(const Mesh& mesh, const std::vector<std::uint32_t>& nodes) {
  Json result = Json::array();
  for (const std::uint32_t node : nodes) result.push_back(mesh.origin().node_number(node));
  return result;
}

Json obstacle_object(const Mesh& mesh, const MeshObstacle& obstacle, const ObstacleList& all) {
  Json object;
  object["obstacle"] = name(obstacle.kind());
  // One object stands for all invalid elements.
  if (obstacle.kind() == MeshVerdict::invalid_element) object["count"] = all.count(obstacle.kind());
  object["elements"] = element_numbers(mesh, obstacle.elements);
  if (obstacle.kind() == MeshVerdict::invalid_element) return object;
  if (!obstacle.edges.empty()) {
    object["edges"] = Json::array();
    for (const ElementEdge& edge : obstacle.edges) {
      object["edges"].push_back({{"element", mesh.origin().number(edge.element)}, {"edge", edge.edge}});
    }
  }
  if (!obstacle.nodes.empty()) object["nodes"] = node_numbers(mesh, obstacle.nodes);
  if (!obstacle.points.empty()) {
    object["points"] = Json::array();
    for (const Point& point : obstacle.points) object["points"].push_back(point_array(point));
  }
  if (obstacle.distance) {
    object["distance"] = {{"lower", to_string(to_rational(obstacle.distance->lower))},
                          {"upper", to_string(to_rational(obstacle.distance->upper))}};
  }
  object["message"] = message(mesh, obstacle);
  if (const std::string cause = hint(obstacle); !cause.empty()) object["hint"] = cause;
  return object;
}

Json area_object(const AreaBounds& area) {
  if (area.is_exact()) return to_string(area.lower);
  return {{"lower", to_string(to_rational(round_down(area.lower, area_bits)))},
          {"upper", to_string(to_rational(round_up(area.upper, area_bits)))}};
}

}  // namespace

Json mesh_object(const Mesh& mesh, const MeshResult& result) {
  Json object;
  object["verdict"] = name(result.verdict);
  object["obstacles"] = Json::array();
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    object["obstacles"].push_back(obstacle_object(mesh, obstacle, result.obstacles));
  }
  object["components"] = result.components;
  object["loops"] = result.loops ? Json(*result.loops) : Json(nullptr);
  object["holes"] = result.holes ? Json(*result.holes) : Json(nullptr);
  object["area"] = result.area ? area_object(*result.area) : Json(nullptr);
  return object;
}

Json domain_object(const std::string& file, const Mesh& mesh, const DomainResult& domain) {
  Json object;
  object["file"] = file;
  object["verdict"] = domain.conforming() ? "conforming" : "not_conforming";
  object["curves"] = domain.curves;
  object["covered"] = domain.covered;
  object["failures"] = Json::array();
  for (const DomainFailure& failure : domain.failures) {
    Json one;
    one["curve"] = failure.curve + 1;
    if (!failure.curve_name.empty()) one["name"] = failure.curve_name;
    one["parameter"] = to_string(failure.parameter);
    one["point"] = point_array(failure.point);
    if (!failure.nodes.empty()) one["nodes"] = node_numbers(mesh, failure.nodes);
    one["elements"] = element_numbers(mesh, failure.elements);
    one["message"] = message(mesh, failure);
    object["failures"].push_back(one);
  }
  return object;
}

}  // namespace bezcert
