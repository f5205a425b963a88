#include "bezcert/io/mesh/gmsh_content.hpp"

#include "bezcert/io/printable.hpp"
#include "bezcert/number/parse.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_map>

namespace bezcert {
namespace {

// What a thread looks at in one go.
constexpr std::size_t part = std::size_t{1} << 15;

}  // namespace

void GmshContent::check_finite(double value, std::uint64_t tag) const {
  if (!std::isfinite(value)) {
    source_.fail("a coordinate of node " + std::to_string(tag) + " is not finite, expected a finite number");
  }
}

template <class Number>
Number GmshContent::coordinate(std::string_view text, std::uint64_t tag) const {
  constexpr bool nearest = std::is_same_v<Number, double>;
  const auto parse = [&] {
    if constexpr (nearest) {
      return parse_binary64(text);
    } else {
      return parse_decimal(text);
    }
  };
  if (const auto value = parse()) return *value;
  source_.fail(
      "a coordinate of node " + std::to_string(tag) + " is '" + printable(text) +
      (nearest ? "', expected a finite decimal number in the range of doubles"
               : "', expected a finite decimal number of at most 20000 characters and exponents up to 5000"));
}

// The line of the next node.
void GmshContent::add_line(std::size_t line) {
  const std::size_t node = node_tags_.size();
  if (line > 0 && (node_lines_.empty() || line - node_lines_.back().line != node - node_lines_.back().node)) {
    node_lines_.push_back({node, line});
  }
}

void GmshContent::add_tag(std::uint64_t tag, std::size_t line) {
  add_line(line);
  node_tags_.push_back(tag);
}

std::size_t GmshContent::node_line(std::size_t node) const {
  const auto after = std::upper_bound(node_lines_.begin(), node_lines_.end(), node,
                                      [](std::size_t n, const LinesFrom& run) { return n < run.node; });
  return after == node_lines_.begin() ? 0 : std::prev(after)->line + (node - std::prev(after)->node);
}

// A mesh is flat nearly always: one number stands for all heights until another comes.
void GmshContent::add_height(double z) {
  if (node_tags_.empty()) flat_ = z;
  if (flat_ && *flat_ == z) return;
  if (flat_) {
    for (std::size_t i = 0; i < node_tags_.size(); ++i) z_.push_back(*flat_);
    flat_.reset();
  }
  z_.push_back(z);
}

void GmshContent::check_height(std::uint32_t node, std::uint32_t first) const {
  if (flat_) return;
  const bool same = z_.binary64() ? z_.doubles()[node] == z_.doubles()[first]
                                  : z_.rationals()[node] == z_.rationals()[first];
  if (same) return;
  source_.fail_at(node_line(node),
                  "the mesh is not planar: node " + std::to_string(node_tags_[node]) +
                      " has z = " + to_decimal(z_[node]) + ", node " + std::to_string(node_tags_[first]) +
                      " has z = " + to_decimal(z_[first]) + "; expected a mesh in a plane z = constant");
}

void GmshContent::add_node(std::uint64_t tag, std::string_view x, std::string_view y, std::string_view z) {
  if (binary64()) {
    const auto x_value = coordinate<double>(x, tag), y_value = coordinate<double>(y, tag);
    return add_node(tag, x_value, y_value, coordinate<double>(z, tag));
  }
  const auto x_value = coordinate<Rational>(x, tag), y_value = coordinate<Rational>(y, tag);
  z_.push_back(coordinate<Rational>(z, tag));
  builder_.add_node({x_value, y_value});
  add_tag(tag, source_.line());
}

void GmshContent::add_node(std::uint64_t tag, double x, double y, double z) {
  for (const double value : {x, y, z}) check_finite(value, tag);
  builder_.add_node({x, y});
  add_height(z);
  add_tag(tag, source_.line());
}

std::optional<GmshContent::NodePlaces> GmshContent::begin_nodes(std::size_t count, double z) {
  if (!std::isfinite(z) || (!binary64() && !source_.binary)) return std::nullopt;
  if (!node_tags_.empty() && !(flat_ && *flat_ == z)) return std::nullopt;
  const auto places = builder_.append_nodes(count);
  if (!places) return std::nullopt;
  return NodePlaces{(*places)[0], (*places)[1], z};
}

void GmshContent::keep_nodes(const NodeTags& tags, std::size_t first, std::size_t count, std::size_t line,
                             double z) {
  if (count == 0) return;
  flat_ = z;
  add_line(line);
  if (tags.consecutive()) return node_tags_.append_consecutive(tags[first], count);
  for (std::size_t i = first; i < first + count; ++i) node_tags_.push_back(tags[i]);
}

void GmshContent::drop_nodes(std::size_t count) { builder_.drop_nodes(count); }

void GmshContent::reserve_nodes(std::uint64_t count) {
  if (count <= source_.remaining() / 8) builder_.reserve_nodes(count);
}

void GmshContent::reserve_elements(const GmshType& type, std::uint64_t count) {
  if (type.type_class == GmshClass::surface) {
    builder_.reserve_elements(count, static_cast<std::size_t>(type.nodes));
  }
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
  if (last_order_ && shape == last_shape_) return *last_order_;
  auto& order = orders_[shape];
  if (order.empty()) order = gmsh_node_order(shape);
  last_order_ = &order;
  last_shape_ = shape;
  return order;
}

void GmshContent::add_origin(ElementPlaces& places, std::size_t count) {
  const auto append = [count](auto& list) {
    list.resize(list.size() + count);
    return std::span(list).last(count);
  };
  places.tags = append(builder_.origin().element_tags);
  if (!source_.binary) places.lines = append(builder_.origin().element_lines);
}

std::optional<GmshContent::ElementPlaces> GmshContent::begin_elements(const GmshType& type,
                                                                      std::size_t count) {
  if (type.type_class != GmshClass::surface || !wide_.empty()) return std::nullopt;
  ElementPlaces places;
  places.order = node_order(type.shape);
  places.nodes = builder_.append_elements(type.shape, options_.basis, count);
  add_origin(places, count);
  return places;
}

void GmshContent::drop_elements(std::size_t count) {
  builder_.drop_elements(count);
  MeshOrigin& origin = builder_.origin();
  origin.element_tags.resize(origin.element_tags.size() - count);
  if (!source_.binary) origin.element_lines.resize(origin.element_lines.size() - count);
}

void GmshContent::add_element(const GmshType& type, std::uint64_t tag, std::span<const std::uint64_t> nodes) {
  IgnoredCells& ignored = builder_.origin().ignored;
  switch (type.type_class) {
    case GmshClass::point: ++ignored.points; return;
    case GmshClass::line: ++ignored.lines; return;
    case GmshClass::volume: ++ignored.volumes; return;
    case GmshClass::surface: break;
    default: return;
  }
  std::uint64_t all = 0;
  for (const std::uint64_t node : nodes) all |= node;
  if (wide_.empty() && all >> 32 != 0) {
    wide_.assign(builder_.node_indices().begin(), builder_.node_indices().end());
  }
  ElementPlaces places;
  places.order = node_order(type.shape);
  places.nodes = builder_.append_elements(type.shape, options_.basis, 1);
  add_origin(places, 1);
  places.set(0, tag, source_.line());
  for (std::size_t k = 0; k < nodes.size(); ++k) places.set_node(0, k, nodes[k]);
  if (all >> 32 == 0 && wide_.empty()) return;
  wide_.resize(wide_.size() + nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    wide_[wide_.size() - nodes.size() + places.order[k]] = nodes[k];
  }
}

// From node tag to place: nothing where tags are consecutive, a table where they are dense, a hash where they
// are sparse.
struct GmshContent::NodeIndex {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t first = 0, consecutive = 0;
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
    if (consecutive > 0) return tag - first < consecutive ? static_cast<std::uint32_t>(tag - first) : none;
    if (!dense.empty()) return tag < dense.size() ? dense[tag] : none;
    const auto found = sparse.find(tag);
    return found == sparse.end() ? none : found->second;
  }
};

// Tags that are one run and heights that are one number: places are differences, found side by side. False,
// and nothing has changed, if a tag is not a node's.
bool GmshContent::place_consecutive(std::uint64_t first_tag) {
  if (!wide_.empty() || !flat_) return false;
  const std::span<std::uint32_t> nodes = builder_.node_indices();
  const std::size_t count = node_tags_.size();
  std::atomic<bool> known = true;
  run_ranges(options_.executor, nodes.size(), part, [&](std::size_t begin, std::size_t end) {
    bool all = true;
    for (std::size_t i = begin; i < end; ++i) all &= nodes[i] - first_tag < count;
    if (!all) known = false;
  });
  if (!known || first_tag == 0) return known;
  run_ranges(options_.executor, nodes.size(), part, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nodes[i] -= static_cast<std::uint32_t>(first_tag);
  });
  return true;
}

void GmshContent::place_each(const NodeIndex& index) {
  std::optional<std::uint32_t> first;
  const std::span<std::uint32_t> nodes = builder_.node_indices();
  for (std::size_t i = 0; i < builder_.elements().size(); ++i) {
    const MeshElement& element = builder_.elements()[i];
    const std::size_t end = element.first_node + coefficient_count(element.shape);
    for (std::size_t k = element.first_node; k < end; ++k) {
      const std::uint64_t tag = wide_.empty() ? nodes[k] : wide_[k];
      const std::uint32_t node = index.find(tag);
      if (node == NodeIndex::none) {
        source_.fail_at(builder_.origin().line(i), "element " + std::to_string(builder_.origin().number(i)) +
                                                       " uses node " + std::to_string(tag) +
                                                       ", which $Nodes does not define");
      }
      if (!first) first = node;
      check_height(node, *first);
      nodes[k] = node;
    }
  }
}

MeshBuilder GmshContent::finish() {
  if (!has_nodes) source_.fail_at(0, "there is no $Nodes section");
  if (!has_elements) source_.fail_at(0, "there is no $Elements section");
  MeshOrigin& origin = builder_.origin();
  if (builder_.elements().empty()) {
    source_.fail_at(
        0, "there are no triangles or quadrangles (ignored: " + std::to_string(origin.ignored.points) +
               " points, " + std::to_string(origin.ignored.lines) + " lines, " +
               std::to_string(origin.ignored.volumes) + " volume cells)");
  }

  NodeIndex index;
  if (node_tags_.consecutive() && !node_tags_.empty()) {
    index.first = node_tags_[0];
    index.consecutive = node_tags_.size();
  } else {
    std::uint64_t largest = 0;
    for (std::size_t i = 0; i < node_tags_.size(); ++i) largest = std::max(largest, node_tags_[i]);
    if (largest < 4 * node_tags_.size() + 1024) index.dense.assign(largest + 1, NodeIndex::none);
    for (std::size_t i = 0; i < node_tags_.size(); ++i) {
      if (!index.add(node_tags_[i], static_cast<std::uint32_t>(i))) {
        source_.fail_at(node_line(i), "node " + std::to_string(node_tags_[i]) + " is defined twice");
      }
    }
  }

  if (index.consecutive == 0 || !place_consecutive(index.first)) place_each(index);
  origin.numbers = options_.numbers;
  origin.node_tags = std::move(node_tags_);
  return std::move(builder_);
}

}  // namespace bezcert
