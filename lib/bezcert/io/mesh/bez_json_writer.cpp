#include "bezcert/io/mesh/bez_json.hpp"

#include <nlohmann/json.hpp>

#include <ostream>

namespace bezcert {
namespace {

// A text as JSON. Names may hold any bytes: what is no UTF-8 is replaced, not thrown at.
std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// An exact number: an integer as it is (short enough for readers that use doubles), else a string.
std::string number_text(const Rational& value) {
  std::string text = to_string(value);
  const bool short_integer = text.size() < 16 && text.find('/') == std::string::npos;
  return short_integer ? text : '"' + text + '"';
}

std::string point_text(const ExactVector& x, const ExactVector& y, std::size_t i) {
  return '[' + number_text(x[i]) + ", " + number_text(y[i]) + ']';
}

// Items of a list, one after another.
template <class Text>
void write_list(std::ostream& stream, std::size_t count, const char* separator, Text text) {
  for (std::size_t i = 0; i < count; ++i) stream << (i > 0 ? separator : "") << text(i);
}

std::string shape_text(Shape shape, Basis basis) {
  const bool triangle = shape.domain == Domain::triangle;
  std::string text = triangle
                         ? "\"kind\": \"triangle\", \"degree\": " + std::to_string(shape.degree(0))
                         : "\"kind\": \"quadrilateral\", \"degree\": [" + std::to_string(shape.degree(0)) +
                               ", " + std::to_string(shape.degree(1)) + ']';
  return text + ", \"basis\": \"" + (basis == Basis::bernstein ? "bernstein" : "lagrange") + '"';
}

void write_own_points(std::ostream& stream, const Element& element) {
  stream << ", \"points\": [";
  write_list(stream, element.coordinates()[0].size(), ", ", [&](std::size_t i) {
    return point_text(element.coordinates()[0], element.coordinates()[1], i);
  });
  stream << ']';
  if (element.weights().empty()) return;
  stream << ", \"weights\": [";
  write_list(stream, element.weights().size(), ", ",
             [&](std::size_t i) { return number_text(element.weights()[i]); });
  stream << ']';
}

}  // namespace

void write_bez_json(std::ostream& stream, const Element& element, const std::string& name,
                    const std::string& source) {
  stream << "{\"bezcert\": 1, \"elements\": [\n {";
  if (!name.empty()) stream << "\"name\": " << json_text(name) << ", ";
  if (!source.empty()) stream << "\"source\": " << json_text(source) << ",\n  ";
  stream << shape_text(element.shape(), element.basis());
  write_own_points(stream, element);
  stream << "}\n]}\n";
}

void write_bez_json(std::ostream& stream, const Mesh& mesh) {
  stream << "{\"bezcert\": 1";
  if (mesh.glued_by_nodes()) {
    stream << ",\n\"points\": [\n";
    write_list(stream, mesh.node_count(), ",\n",
               [&](std::size_t i) { return point_text(mesh.coordinates(0), mesh.coordinates(1), i); });
    stream << "\n]";
    if (!mesh.weights().empty()) {
      stream << ",\n\"weights\": [";
      write_list(stream, mesh.weights().size(), ",\n",
                 [&](std::size_t i) { return number_text(mesh.weights()[i]); });
      stream << ']';
    }
  }
  stream << ",\n\"elements\": [\n";
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    const MeshElement& entry = mesh.elements()[i];
    stream << (i > 0 ? ",\n{" : "{");
    if (const std::string_view name = mesh.origin().name(i); !name.empty())
      stream << "\"name\": " << json_text(name) << ", ";
    stream << shape_text(entry.shape, entry.basis);
    if (mesh.glued_by_nodes()) {
      stream << ", \"nodes\": [";
      write_list(stream, coefficient_count(entry.shape), ", ",
                 [&](std::size_t k) { return std::to_string(mesh.connectivity()[entry.first_node + k]); });
      stream << ']';
    } else {
      write_own_points(stream, mesh.element(i));
    }
    stream << '}';
  }
  stream << "\n]}\n";
}

}  // namespace bezcert
