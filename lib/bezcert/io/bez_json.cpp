#include "bezcert/io/bez_json.hpp"

#include "bezcert/io/input_error.hpp"
#include "bezcert/io/json_document.hpp"
#include "bezcert/io/printable.hpp"
#include "bezcert/number/parse.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <unordered_map>

namespace bezcert {
namespace {

using Kind = JsonValue::Kind;

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Mesh read(const JsonValue& root) {
    check_file(root);
    read_shared_nodes(root);
    if (const JsonValue* curves = root.find("curves")) curves_of(*curves);
    if (root.find("curves") != nullptr && root.find("elements") == nullptr) {
      fail(root,
           "the file has no \"elements\", only curves: expected a mesh here, and curves after --domain");
    }
    const JsonValue& elements = required(root, "elements", "the file");
    expect(elements, Kind::array, "\"elements\"");
    if (elements.items.empty()) fail(elements, "there are no elements");
    for (const JsonValue& element : elements.items) add(element);
    mesh_.basis_name = basis_name_;
    mesh_.numbers = Numbers::decimal;
    mesh_.glued_by_nodes = all_by_nodes_;
    finish_weights();
    return std::move(mesh_);
  }

  std::vector<InputCurve> read_curves(const JsonValue& root) {
    check_file(root);
    const JsonValue& curves = required(root, "curves", "the file");
    std::vector<InputCurve> result = curves_of(curves);
    if (result.empty()) fail(curves, "there are no curves");
    return result;
  }

 private:
  void check_file(const JsonValue& root) const {
    expect(root, Kind::object, "the file");
    check_keys(root, {"bezcert", "elements", "curves", "points", "weights"});
    const JsonValue& version = required(root, "bezcert", "the file");
    if (version.kind != Kind::number || version.text != "1")
      fail(version, "\"bezcert\" must be 1, the format's version");
  }

  [[noreturn]] void fail(const JsonValue& where, const std::string& message) const {
    throw InputError(file_, where.line, message);
  }

  void expect(const JsonValue& value, Kind kind, const std::string& what) const {
    if (value.kind != kind) {
      fail(value, what + " must be " + std::string(name(kind)) + ", not " + std::string(name(value.kind)));
    }
  }

  void check_keys(const JsonValue& object, std::initializer_list<std::string_view> known) const {
    for (const auto& [key, value] : object.members) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      std::string list;
      for (const std::string_view k : known) list += (list.empty() ? "" : ", ") + std::string(k);
      fail(value, "the key \"" + printable(key) + "\" is not known: expected one of " + list);
    }
  }

  const JsonValue& required(const JsonValue& object, std::string_view key, const std::string& what) const {
    const JsonValue* value = object.find(key);
    if (value == nullptr) fail(object, what + " has no \"" + std::string(key) + "\"");
    return *value;
  }

  Rational number(const JsonValue& value, const std::string& what) const {
    if (value.kind == Kind::number || value.kind == Kind::string) {
      // A JSON number keeps its text, so both mean the exact value.
      if (const auto result =
              value.kind == Kind::number ? parse_decimal(value.text) : parse_rational(value.text)) {
        return *result;
      }
    }
    fail(value,
         what + " is " +
             (value.text.empty() ? std::string(name(value.kind)) : "\"" + printable(value.text) + "\"") +
             ": expected a finite decimal or \"p/q\", of at most 20000 characters and exponents up to 5000");
  }

  int degree(const JsonValue& value) const {
    const auto result = value.kind == Kind::number ? parse_decimal(value.text) : std::nullopt;
    if (!result || denominator(*result) != 1 || *result < 1 || *result > max_degree) {
      fail(value, "a degree must be an integer from 1 to " + std::to_string(max_degree));
    }
    return static_cast<int>(numerator(*result).convert_to<long>());
  }

  // Appends the points of an array of pairs; returns how many.
  std::size_t add_points(const JsonValue& points) {
    expect(points, Kind::array, "\"points\"");
    for (const JsonValue& point : points.items) {
      if (point.kind != Kind::array || point.items.size() != 2) fail(point, "a point must be [x, y]");
      mesh_.x.push_back(number(point.items[0], "x of a point"));
      mesh_.y.push_back(number(point.items[1], "y of a point"));
    }
    return points.items.size();
  }

  // Appends weights for the last `count` points.
  void add_weights(const JsonValue& weights, std::size_t count) {
    expect(weights, Kind::array, "\"weights\"");
    if (weights.items.size() != count) {
      fail(weights, "there are " + std::to_string(weights.items.size()) + " weights for " +
                        std::to_string(count) + " points");
    }
    for (const JsonValue& weight : weights.items) {
      const Rational value = number(weight, "a weight");
      if (value.sign() <= 0) fail(weight, "the weight " + to_string(value) + " is not positive");
      weights_.push_back(value);
    }
    has_weights_ = true;
  }

  void default_weights(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) weights_.push_back(Rational(1));
  }

  void read_shared_nodes(const JsonValue& root) {
    const JsonValue* points = root.find("points");
    const JsonValue* weights = root.find("weights");
    if (points == nullptr) {
      if (weights != nullptr) fail(*weights, "\"weights\" of the file go with \"points\" of the file");
      return;
    }
    shared_ = add_points(*points);
    if (weights != nullptr) {
      add_weights(*weights, shared_);
    } else {
      default_weights(shared_);
    }
  }

  Shape shape_of(const JsonValue& element) const {
    const JsonValue& kind = required(element, "kind", "an element");
    const JsonValue& value = required(element, "degree", "an element");
    if (kind.kind == Kind::string && kind.text == "triangle") return Shape::triangle(degree(value));
    if (kind.kind != Kind::string || kind.text != "quadrilateral") {
      fail(kind, "\"kind\" must be \"triangle\" or \"quadrilateral\"");
    }
    if (value.kind != Kind::array || value.items.size() != 2) {
      fail(value, "the degree of a quadrilateral must be [p, q]");
    }
    return Shape::square(degree(value.items[0]), degree(value.items[1]));
  }

  Basis basis_of(const JsonValue& element) {
    std::string text = "bernstein";
    if (const JsonValue* basis = element.find("basis")) {
      text = basis->text;
      if (basis->kind != Kind::string || (text != "bernstein" && text != "lagrange")) {
        fail(*basis, "\"basis\" must be \"bernstein\" or \"lagrange\"");
      }
    }
    basis_name_ = basis_name_.empty() || basis_name_ == text ? text : "mixed";
    return text == "bernstein" ? Basis::bernstein : Basis::lagrange;
  }

  std::string optional_text(const JsonValue& element, const char* key) const {
    const JsonValue* value = element.find(key);
    if (value == nullptr) return "";
    expect(*value, Kind::string, "\"" + std::string(key) + "\"");
    return value->text;
  }

  void add(const JsonValue& element) {
    expect(element, Kind::object, "an element");
    check_keys(element,
               {"kind", "degree", "basis", "points", "weights", "nodes", "name", "expect", "source"});
    MeshElement entry;
    entry.shape = shape_of(element);
    entry.basis = basis_of(element);
    entry.tag = mesh_.elements.size() + 1;
    entry.line = static_cast<std::uint32_t>(element.line);
    entry.first_node = mesh_.connectivity.size();
    const std::size_t count = coefficient_count(entry.shape);
    const JsonValue* points = element.find("points");
    const JsonValue* nodes = element.find("nodes");
    if ((points == nullptr) == (nodes == nullptr))
      fail(element, "an element must have either \"points\" or \"nodes\"");
    const JsonValue& list = points != nullptr ? *points : *nodes;
    expect(list, Kind::array, points != nullptr ? "\"points\"" : "\"nodes\"");
    if (list.items.size() != count) {
      fail(list, "an element of this kind and degree has " + std::to_string(count) + " points, not " +
                     std::to_string(list.items.size()));
    }
    const JsonValue* weights = element.find("weights");
    all_by_nodes_ = all_by_nodes_ && nodes != nullptr;
    if (points != nullptr) {
      const std::size_t first = mesh_.x.size();
      if (first + count > std::numeric_limits<std::uint32_t>::max()) fail(element, "too many points");
      add_points(*points);
      for (std::size_t i = 0; i < count; ++i)
        mesh_.connectivity.push_back(static_cast<std::uint32_t>(first + i));
      if (weights != nullptr) {
        add_weights(*weights, count);
      } else {
        default_weights(count);
      }
    } else {
      if (weights != nullptr) fail(*weights, "an element with \"nodes\" takes the weights of the file");
      add_nodes(*nodes);
    }
    mesh_.elements.push_back(entry);
    mesh_.names.push_back(optional_text(element, "name"));
    mesh_.expected.push_back(optional_text(element, "expect"));
    optional_text(element, "source");
  }

  void add_nodes(const JsonValue& nodes) {
    for (const JsonValue& node : nodes.items) {
      const auto index = node.kind == Kind::number ? parse_decimal(node.text) : std::nullopt;
      if (!index || denominator(*index) != 1 || *index < 0 || *index >= shared_) {
        fail(node, "a node must be an index into \"points\" of the file, from 0 to below " +
                       std::to_string(shared_));
      }
      mesh_.connectivity.push_back(static_cast<std::uint32_t>(numerator(*index).convert_to<unsigned long>()));
    }
  }

  std::vector<InputCurve> curves_of(const JsonValue& curves) const {
    expect(curves, Kind::array, "\"curves\"");
    std::vector<InputCurve> result;
    for (const JsonValue& curve : curves.items) result.push_back(curve_of(curve));
    return result;
  }

  InputCurve curve_of(const JsonValue& curve) const {
    expect(curve, Kind::object, "a curve");
    check_keys(curve, {"degree", "points", "weights", "name", "source"});
    InputCurve result;
    result.line = static_cast<std::uint32_t>(curve.line);
    result.name = optional_text(curve, "name");
    optional_text(curve, "source");
    const auto count = static_cast<std::size_t>(degree(required(curve, "degree", "a curve"))) + 1;
    const JsonValue& points = required(curve, "points", "a curve");
    expect(points, Kind::array, "\"points\"");
    if (points.items.size() != count) {
      fail(points, "a curve of this degree has " + std::to_string(count) + " points, not " +
                       std::to_string(points.items.size()));
    }
    for (const JsonValue& point : points.items) {
      if (point.kind != Kind::array || point.items.size() != 2) fail(point, "a point must be [x, y]");
      result.x.push_back(number(point.items[0], "a coordinate"));
      result.y.push_back(number(point.items[1], "a coordinate"));
    }
    if (const JsonValue* weights = curve.find("weights")) {
      expect(*weights, Kind::array, "\"weights\"");
      if (weights->items.size() != count) fail(*weights, "there must be one weight a point");
      for (const JsonValue& weight : weights->items) {
        result.weights.push_back(number(weight, "a weight"));
        if (result.weights[result.weights.size() - 1].sign() <= 0) fail(weight, "a weight is not positive");
      }
    }
    return result;
  }

  // Lagrange weights can be positive and convert to weights that are not: building the element tells.
  void finish_weights() {
    if (!has_weights_) return;
    mesh_.weights = std::move(weights_);
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
      if (mesh_.elements[i].basis != Basis::lagrange) continue;
      try {
        mesh_.element(i);
      } catch (const std::invalid_argument& error) {
        throw InputError(
            file_, mesh_.elements[i].line,
            "element " + std::to_string(mesh_.elements[i].tag) + ": " + error.what() +
                "; expected an element with a positive control net (degree elevation may give one)");
      }
    }
  }

  const std::string& file_;
  Mesh mesh_;
  ExactVector weights_;  // of all points; used only if some were given
  bool has_weights_ = false;
  bool all_by_nodes_ = true;  // no element lists its own points
  std::size_t shared_ = 0;
  std::string basis_name_;
};

}  // namespace

Mesh read_bez_json(const std::string& file, std::string_view bytes) {
  return Reader(file).read(parse_json(file, bytes));
}

std::vector<InputCurve> read_bez_json_curves(const std::string& file, std::string_view bytes) {
  return Reader(file).read_curves(parse_json(file, bytes));
}

}  // namespace bezcert
