// Reader of ASCII Gmsh .msh 2.x and 4.1: one record a line, every count and node number checked.
#include "elements.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace verifier {

namespace {

// Types of complete elements of orders 1 to 10.
constexpr std::uint64_t triangles[] = {2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
constexpr std::uint64_t quadrilaterals[] = {3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
// Ranges of types that are ignored: points, lines, volume cells.
constexpr std::uint64_t ignored[][2] = {{1, 1},   {4, 8},   {11, 15}, {17, 19}, {26, 33},
                                        {62, 66}, {71, 75}, {79, 83}, {90, 131}};

/// Element's place of Gmsh's k-th node. Gmsh: corners, edges, then the same for the ring inside.
std::vector<std::size_t> node_order(bool triangle, std::size_t n) {
  std::vector<std::size_t> places;
  const std::size_t sides = triangle ? 3 : 4;
  for (std::size_t ring = 0; places.size() < point_count(triangle, n, n); ++ring) {
    const std::size_t m = n - ring * (triangle ? 3 : 2);  // the ring's degree
    const auto add = [&](std::size_t side, std::size_t k) {
      places.push_back(edge_place(triangle, n, n, side, k, ring));
    };
    for (std::size_t side = 0; side < (m == 0 ? 1 : sides); ++side) add(side, 0);
    for (std::size_t side = 0; side < sides; ++side)
      for (std::size_t k = 1; k < m; ++k) add(side, k);
  }
  return places;
}

/// The lines of a file, and the fields of the current one.
struct Lines {
  std::string_view file;
  std::string_view rest{};  ///< of the current line
  std::size_t at = 0, line = 0;

  [[noreturn]] void fail(const std::string& why) const {
    throw Malformed{"elements file, line " + std::to_string(line) + ": " + why};
  }
  bool at_end() const { return at >= file.size(); }
  void record() {
    if (at_end()) fail("the file ends too early");
    rest = file.substr(at, file.find('\n', at) - at);
    at += rest.size() + 1;
    ++line;
    if (rest.ends_with('\r')) rest.remove_suffix(1);
  }
  /// The next field; empty if there is none.
  std::string_view field() {
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto begin = std::find_if_not(rest.begin(), rest.end(), blank);
    const auto end = std::find_if(begin, rest.end(), blank);
    rest = {end, rest.end()};
    return {begin, end};
  }
  std::string_view text() {
    const std::string_view found = field();
    if (found.empty()) fail("too few numbers");
    return found;
  }
  std::uint64_t number() {
    const std::string_view digits = text();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) fail("expected digits only");
    return value;
  }
  void skip(std::uint64_t fields) {
    while (fields-- > 0) text();
  }
  void end() {
    if (!field().empty()) fail("too many numbers");
  }
};

}  // namespace

void Elements::read_msh(bool lagrange) {
  Lines in{bytes_};
  bool version4 = false;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> tags;  // of nodes, with their places; sorted
  std::vector<std::string_view> z;
  std::string_view plane;  // z of a surface element
  std::map<std::uint64_t, std::vector<std::size_t>> orders;

  const auto read_format = [&] {
    in.record();
    const std::string_view version = in.text();
    version4 = version == "4.1";
    if (!version4 && version != "2" && !version.starts_with("2.")) in.fail("version is not 2.x or 4.1");
    if (in.number() != 0) in.fail("binary: write an elements file with certify check --elements");
    in.skip(1), in.end();
  };
  // Blocks, as many entries as announced: read_block(dimension, type or whether there are parameters, size).
  // Version 2 has one block, without these words.
  const auto read_blocks = [&](const auto& read_block) {
    in.record();
    std::uint64_t blocks = version4 ? in.number() : 1, seen = 0;
    const std::uint64_t count = in.number();
    in.skip(version4 ? 2 : 0), in.end();
    while (blocks-- > 0) {
      std::uint64_t dimension = 0, kind = 0, size = count;
      if (version4) {
        in.record(), dimension = in.number(), in.skip(1);
        kind = in.number(), size = in.number(), in.end();
      }
      read_block(dimension, kind, size);
      seen += size;
    }
    if (seen != count) in.fail("not as many entries as announced");
  };
  const auto read_nodes = [&](std::uint64_t dimension, std::uint64_t parametric, std::uint64_t size) {
    const auto read_tag = [&] { tags.emplace_back(in.number(), static_cast<std::uint32_t>(tags.size())); };
    for (std::uint64_t i = 0; version4 && i < size; ++i) in.record(), read_tag(), in.end();
    for (std::uint64_t i = 0; i < size; ++i) {
      in.record();
      if (!version4) read_tag();
      for (Column* column : {&x_, &y_}) {
        const std::string_view text = in.text();
        binary64_ ? column->doubles.push_back(nearest_double(text)) : column->texts.push_back(text);
      }
      z.push_back(in.text());
      in.skip(parametric ? dimension : 0), in.end();
    }
  };
  const auto sort_nodes = [&] {
    std::sort(tags.begin(), tags.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    if (std::adjacent_find(tags.begin(), tags.end(), same) != tags.end()) in.fail("a node tag occurs twice");
  };
  const auto node_of = [&](std::uint64_t tag) {
    if (tag - 1 < tags.size() && tags[tag - 1].first == tag) return tags[tag - 1].second;  // mostly 1, 2, ...
    const auto node = std::lower_bound(tags.begin(), tags.end(), std::pair{tag, std::uint32_t{0}});
    if (node == tags.end() || node->first != tag) in.fail("no such node");
    return node->second;
  };
  const auto number = [&](std::string_view text) {
    return binary64_ ? mpq_class(nearest_double(text)) : exact_number(text, false);
  };
  const auto read_element = [&](std::uint64_t type) {
    const auto order_in = [&](const std::uint64_t(&types)[10]) {
      const auto found = std::find(types, types + 10, type);
      return found == types + 10 ? 0 : static_cast<std::size_t>(found - types) + 1;
    };
    const auto in_range = [&](const std::uint64_t(&range)[2]) {
      return range[0] <= type && type <= range[1];
    };
    if (std::any_of(std::begin(ignored), std::end(ignored), in_range)) return;
    const std::size_t triangle = order_in(triangles), n = triangle + order_in(quadrilaterals);
    if (n == 0) in.fail("element type " + std::to_string(type) + " is serendipity or unknown");
    const auto degree = static_cast<std::uint16_t>(n);
    shapes_.push_back({triangle != 0, lagrange, degree, degree, nodes_.size()});
    std::vector<std::size_t>& order = orders[type];
    if (order.empty()) order = node_order(triangle, n);
    nodes_.resize(nodes_.size() + order.size());
    for (const std::size_t k : order) {
      const std::uint32_t node = node_of(in.number());
      nodes_[shapes_.back().first + k] = node;
      const std::string_view height = z[node];
      if (plane.empty()) plane = height;
      if (height != plane && number(height) != number(plane)) in.fail("surface nodes of different z");
    }
    in.end();
  };
  const auto read_elements = [&](std::uint64_t, std::uint64_t type, std::uint64_t size) {
    for (std::uint64_t i = 0; i < size; ++i) {
      in.record(), in.skip(1);
      if (!version4) type = in.number(), in.skip(in.number());
      read_element(type);
    }
  };

  const std::string_view sections[] = {"$MeshFormat", "$Nodes", "$Elements"};  // in this order, once each
  for (std::size_t have = 0; !in.at_end();) {
    in.record();
    const std::string_view name = in.field();
    in.end();
    if (name.empty()) continue;
    const auto known = static_cast<std::size_t>(std::find(sections, sections + 3, name) - sections);
    if (name[0] != '$' || (known < 3 && known != have++))
      in.fail("section unknown, repeated or out of order");
    if (known == 0) read_format();
    if (known == 1) read_blocks(read_nodes), sort_nodes();
    if (known == 2) read_blocks(read_elements);
    const std::string end = "$End" + std::string(name.substr(1));
    while (in.record(), in.field() != end)
      if (known < 3) in.fail("expected " + end);
    in.end();
  }
}

}  // namespace verifier
