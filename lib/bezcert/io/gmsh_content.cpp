#include "bezcert/io/gmsh_content.hpp"

#include "bezcert/io/printable.hpp"
#include "bezcert/number/parse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace bezcert {

void GmshContent::check_finite(double value, std::uint64_t tag) const {
  if (!std::isfinite(value)) {
    source_.fail("a coordinate of node " + std::to_string(tag) + " is not finite, expected a finite number");
  }
}

void GmshContent::add_coordinate(ExactVector& to, std::string_view text, std::uint64_t tag) {
  if (options_.numbers == Numbers::binary64) {
    if (const auto value = parse_binary64(text)) return to.push_back(*value);
  } else {
    if (const auto value = parse_decimal(text)) return to.push_back(*value);
  }
  source_.fail(
      "a coordinate of node " + std::to_string(tag) + " is '" + printable(text) +
      (options_.numbers == Numbers::binary64
           ? "', expected a finite decimal number in the range of doubles"
           : "', expected a finite decimal number of at most 20000 characters and exponents up to 5000"));
}

void GmshContent::add_node(std::uint64_t tag, std::string_view x, std::string_view y, std::string_view z) {
  add_coordinate(mesh_.x, x, tag);
  add_coordinate(mesh_.y, y, tag);
  add_coordinate(z_, z, tag);
  node_tags_.push_back(tag);
  node_lines_.push_back(source_.line());
}

void GmshContent::add_node(std::uint64_t tag, double x, double y, double z) {
  for (const double value : {x, y, z}) check_finite(value, tag);
  mesh_.x.push_back(x);
  mesh_.y.push_back(y);
  z_.push_back(z);
  node_tags_.push_back(tag);
  node_lines_.push_back(0);
}

void GmshContent::check_count(std::uint64_t count, std::size_t bytes, std::string_view what) const {
  if (count > source_.remaining() / bytes) {
    source_.fail(std::to_string(count) + " " + std::string(what) + " are announced, but the file has only " +
                 std::to_string(source_.remaining()) + " bytes more");
  }
}

GmshType GmshContent::element_type(std::int64_t number) const {
  const GmshType type = gmsh_type(number);
  if (type.type_class == GmshClass::serendipity) {
    source_.fail("element type " + std::to_string(number) + " is a " + std::string(type.name) +
                 ": serendipity elements are not read, expected complete elements (in gmsh: "
                 "Mesh.SecondOrderIncomplete=0)");
  }
  if (type.type_class == GmshClass::unsupported) {
    source_.fail("element type " + std::to_string(number) +
                 (type.name.empty() ? std::string(" is not known") : " (" + std::string(type.name) + ")") +
                 ": expected triangles and quadrangles of order 1 to 10, or types to ignore");
  }
  return type;
}

const std::vector<std::size_t>& GmshContent::node_order(Shape shape) {
  auto& order = orders_[shape];
  if (order.empty()) order = gmsh_node_order(shape);
  return order;
}

void GmshContent::begin_element(const GmshType& type, std::uint64_t tag) {
  element_nodes_.clear();
  current_ = {type.shape, options_.basis, tag, static_cast<std::uint32_t>(source_.line()),
              connectivity_.size()};
  switch (type.type_class) {
    case GmshClass::point: ++mesh_.ignored.points; break;
    case GmshClass::line: ++mesh_.ignored.lines; break;
    case GmshClass::volume: ++mesh_.ignored.volumes; break;
    default: break;
  }
}

void GmshContent::end_element() {
  const std::vector<std::size_t>& order = node_order(current_.shape);
  connectivity_.resize(connectivity_.size() + order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    connectivity_[current_.first_node + order[k]] = element_nodes_[k];
  }
  mesh_.elements.push_back(current_);
}

// From node tag to place: a table where tags are dense, a hash where they are sparse.
struct GmshContent::NodeIndex {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> dense;
  std::unordered_map<std::uint64_t, std::uint32_t> sparse;

  // Returns false if the tag was there already.
  bool add(std::uint64_t tag, std::uint32_t place) {
    if (dense.empty()) return sparse.emplace(tag, place).second;
    if (dense[tag] != none) return false;
    dense[tag] = place;
    return true;
  }
  std::uint32_t find(std::uint64_t tag) const {
    if (!dense.empty()) return tag < dense.size() ? dense[tag] : none;
    const auto found = sparse.find(tag);
    return found == sparse.end() ? none : found->second;
  }
};

Mesh GmshContent::finish() {
  if (!has_nodes) source_.fail_at(0, "there is no $Nodes section");
  if (!has_elements) source_.fail_at(0, "there is no $Elements section");
  if (mesh_.elements.empty()) {
    source_.fail_at(
        0, "there are no triangles or quadrangles (ignored: " + std::to_string(mesh_.ignored.points) +
               " points, " + std::to_string(mesh_.ignored.lines) + " lines, " +
               std::to_string(mesh_.ignored.volumes) + " volume cells)");
  }
  if (node_tags_.size() >= NodeIndex::none) source_.fail_at(0, "more than 2^32 - 2 nodes are not supported");

  NodeIndex index;
  const std::uint64_t largest =
      node_tags_.empty() ? 0 : *std::max_element(node_tags_.begin(), node_tags_.end());
  if (largest < 4 * node_tags_.size() + 1024) index.dense.assign(largest + 1, NodeIndex::none);
  for (std::size_t i = 0; i < node_tags_.size(); ++i) {
    if (!index.add(node_tags_[i], static_cast<std::uint32_t>(i))) {
      source_.fail_at(node_lines_[i], "node " + std::to_string(node_tags_[i]) + " is defined twice");
    }
  }

  std::optional<std::uint32_t> first;
  mesh_.connectivity.reserve(connectivity_.size());
  for (const MeshElement& element : mesh_.elements) {
    for (std::size_t k = 0; k < coefficient_count(element.shape); ++k) {
      const std::uint64_t tag = connectivity_[element.first_node + k];
      const std::uint32_t node = index.find(tag);
      if (node == NodeIndex::none) {
        source_.fail_at(element.line, "element " + std::to_string(element.tag) + " uses node " +
                                          std::to_string(tag) + ", which $Nodes does not define");
      }
      if (!first) first = node;
      if (z_[node] != z_[*first]) {
        source_.fail_at(node_lines_[node], "the mesh is not planar: node " + std::to_string(tag) +
                                               " has z = " + to_decimal(z_[node]) + ", node " +
                                               std::to_string(node_tags_[*first]) +
                                               " has z = " + to_decimal(z_[*first]) +
                                               "; expected a mesh in a plane z = constant");
      }
      mesh_.connectivity.push_back(node);
    }
  }
  mesh_.basis_name = options_.basis == Basis::lagrange ? "lagrange" : "bernstein";
  mesh_.numbers = options_.numbers;
  mesh_.node_tags = std::move(node_tags_);
  return std::move(mesh_);
}

}  // namespace bezcert
