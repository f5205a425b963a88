#include "bezcert/io/curve/bez_json.hpp"

namespace bezcert {
namespace {

using Kind = JsonValue::Kind;

InputCurve curve_of(const BezJsonValues& values, const JsonValue& curve) {
  values.expect(curve, Kind::object, "a curve");
  values.check_keys(curve, {"degree", "points", "weights", "name", "source"});
  InputCurve result;
  result.line = static_cast<std::uint32_t>(curve.line);
  result.name = values.optional_text(curve, "name");
  values.optional_text(curve, "source");
  const auto count = static_cast<std::size_t>(values.degree(values.required(curve, "degree", "a curve"))) + 1;
  const JsonValue& points = values.required(curve, "points", "a curve");
  values.expect(points, Kind::array, "\"points\"");
  if (points.items.size() != count) {
    values.fail(points, "a curve of this degree has " + std::to_string(count) + " points, not " +
                            std::to_string(points.items.size()));
  }
  for (const JsonValue& point : points.items) {
    values.expect_point(point);
    result.x.push_back(values.number(point.items[0], "a coordinate"));
    result.y.push_back(values.number(point.items[1], "a coordinate"));
  }
  if (const JsonValue* weights = curve.find("weights")) {
    values.expect(*weights, Kind::array, "\"weights\"");
    if (weights->items.size() != count) values.fail(*weights, "there must be one weight a point");
    for (const JsonValue& weight : weights->items) {
      result.weights.push_back(values.number(weight, "a weight"));
      if (result.weights[result.weights.size() - 1].sign() <= 0)
        values.fail(weight, "a weight is not positive");
    }
  }
  return result;
}

}  // namespace

std::vector<InputCurve> bez_json_curves(const BezJsonValues& values, const JsonValue& list) {
  values.expect(list, Kind::array, "\"curves\"");
  std::vector<InputCurve> result;
  for (const JsonValue& curve : list.items) result.push_back(curve_of(values, curve));
  return result;
}

std::vector<InputCurve> read_bez_json_curves(const std::string& file, std::string_view bytes) {
  const JsonValue root = parse_json(file, bytes);
  const BezJsonValues values(file, root);
  const JsonValue& list = values.required(root, "curves", "the file");
  std::vector<InputCurve> result = bez_json_curves(values, list);
  if (result.empty()) values.fail(list, "there are no curves");
  return result;
}

}  // namespace bezcert
