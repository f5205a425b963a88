#include "bezcert/io/mesh/bez_json.hpp"

#include "bezcert/io/bez_json_values.hpp"
#include "bezcert/io/curve/bez_json.hpp"
#include "bezcert/number/parse.hpp"

#include <optional>

namespace bezcert {
namespace {

using Kind = JsonValue::Kind;

class Reader {
 public:
  Reader(const std::string& file, const JsonValue& root) : values_(file, root), root_(root) {}

  MeshBuilder read() {
    read_shared_nodes();
    const JsonValue* curves = root_.find("curves");
    if (curves != nullptr) {
      bez_json_curves(values_, *curves);
      if (root_.find("elements") == nullptr) {
        values_.fail(
            root_,
            "the file has no \"elements\", only curves: expected a mesh here, and curves after --domain");
      }
    }
    const JsonValue& elements = values_.required(root_, "elements", "the file");
    values_.expect(elements, Kind::array, "\"elements\"");
    if (elements.items.empty()) values_.fail(elements, "there are no elements");
    for (const JsonValue& element : elements.items) add(element);
    builder_.origin().numbers = Numbers::decimal;
    builder_.set_glued_by_nodes(all_by_nodes_);
    return std::move(builder_);
  }

 private:
  // Appends the points of an array of pairs, and their weights, if there are any; returns how many.
  std::size_t add_nodes(const JsonValue& points, const JsonValue* weights) {
    values_.expect(points, Kind::array, "\"points\"");
    const std::size_t count = points.items.size();
    std::vector<std::array<Rational, 2>> numbers;
    for (const JsonValue& point : points.items) {
      values_.expect_point(point);
      numbers.push_back(
          {values_.number(point.items[0], "x of a point"), values_.number(point.items[1], "y of a point")});
    }
    if (weights != nullptr) {
      values_.expect(*weights, Kind::array, "\"weights\"");
      if (weights->items.size() != count) {
        values_.fail(*weights, "there are " + std::to_string(weights->items.size()) + " weights for " +
                                   std::to_string(count) + " points");
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::optional<Rational> weight;
      if (weights != nullptr) weight = positive(weights->items[i]);
      builder_.add_node({numbers[i][0], numbers[i][1]}, weight);
    }
    return count;
  }

  Rational positive(const JsonValue& weight) const {
    Rational value = values_.number(weight, "a weight");
    if (value.sign() <= 0) values_.fail(weight, "the weight " + to_string(value) + " is not positive");
    return value;
  }

  void read_shared_nodes() {
    const JsonValue* points = root_.find("points");
    const JsonValue* weights = root_.find("weights");
    if (points != nullptr) {
      shared_ = add_nodes(*points, weights);
    } else if (weights != nullptr) {
      values_.fail(*weights, "\"weights\" of the file go with \"points\" of the file");
    }
  }

  Shape shape_of(const JsonValue& element) const {
    const JsonValue& kind = values_.required(element, "kind", "an element");
    const JsonValue& value = values_.required(element, "degree", "an element");
    if (kind.kind == Kind::string && kind.text == "triangle") return Shape::triangle(values_.degree(value));
    if (kind.kind != Kind::string || kind.text != "quadrilateral") {
      values_.fail(kind, "\"kind\" must be \"triangle\" or \"quadrilateral\"");
    }
    if (value.kind != Kind::array || value.items.size() != 2) {
      values_.fail(value, "the degree of a quadrilateral must be [p, q]");
    }
    return Shape::square(values_.degree(value.items[0]), values_.degree(value.items[1]));
  }

  Basis basis_of(const JsonValue& element) const {
    const JsonValue* basis = element.find("basis");
    if (basis == nullptr) return Basis::bernstein;
    if (basis->kind != Kind::string || (basis->text != "bernstein" && basis->text != "lagrange")) {
      values_.fail(*basis, "\"basis\" must be \"bernstein\" or \"lagrange\"");
    }
    return basis->text == "bernstein" ? Basis::bernstein : Basis::lagrange;
  }

  void add(const JsonValue& element) {
    values_.expect(element, Kind::object, "an element");
    values_.check_keys(element,
                       {"kind", "degree", "basis", "points", "weights", "nodes", "name", "expect", "source"});
    const Shape shape = shape_of(element);
    const Basis basis = basis_of(element);
    const std::size_t count = coefficient_count(shape);
    const JsonValue* points = element.find("points");
    const JsonValue* nodes = element.find("nodes");
    if ((points == nullptr) == (nodes == nullptr))
      values_.fail(element, "an element must have either \"points\" or \"nodes\"");
    const JsonValue& list = points != nullptr ? *points : *nodes;
    values_.expect(list, Kind::array, points != nullptr ? "\"points\"" : "\"nodes\"");
    if (list.items.size() != count) {
      values_.fail(list, "an element of this kind and degree has " + std::to_string(count) + " points, not " +
                             std::to_string(list.items.size()));
    }
    const JsonValue* weights = element.find("weights");
    all_by_nodes_ = all_by_nodes_ && nodes != nullptr;
    std::vector<std::size_t> indices;
    if (points != nullptr) {
      for (std::size_t i = 0; i < count; ++i) indices.push_back(builder_.node_count() + i);
      add_nodes(*points, weights);
    } else {
      if (weights != nullptr) {
        values_.fail(*weights, "an element with \"nodes\" takes the weights of the file");
      }
      for (const JsonValue& node : nodes->items) indices.push_back(shared_node(node));
    }
    builder_.add_elements(shape, basis, indices);
    MeshOrigin& origin = builder_.origin();
    origin.element_lines.push_back(static_cast<std::uint32_t>(element.line));
    origin.element_names.push_back(values_.optional_text(element, "name"));
    origin.element_expected.push_back(values_.optional_text(element, "expect"));
    values_.optional_text(element, "source");
  }

  std::size_t shared_node(const JsonValue& node) const {
    const auto index = node.kind == Kind::number ? parse_decimal(node.text) : std::nullopt;
    if (!index || denominator(*index) != 1 || *index < 0 || *index >= shared_) {
      values_.fail(node, "a node must be an index into \"points\" of the file, from 0 to below " +
                             std::to_string(shared_));
    }
    return numerator(*index).convert_to<std::size_t>();
  }

  const BezJsonValues values_;
  const JsonValue& root_;
  MeshBuilder builder_;
  bool all_by_nodes_ = true;  // no element lists its own points
  std::size_t shared_ = 0;
};

}  // namespace

MeshBuilder read_bez_json(const std::string& file, std::string_view bytes, const ReadOptions&) {
  const JsonValue root = parse_json(file, bytes);
  return Reader(file, root).read();
}

}  // namespace bezcert
