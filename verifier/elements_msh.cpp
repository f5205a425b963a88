// Reader of ASCII Gmsh .msh 2.x and 4.1: one record a line, every count and node number checked.
#include "elements.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace verifier {

namespace {

// Types of complete elements of orders 1 to 10, and the ranges of types that are ignored: points, lines,
// volume cells.
constexpr std::size_t triangles[] = {2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
constexpr std::size_t quadrilaterals[] = {3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
constexpr std::size_t ignored[][2] = {{15, 15}, {1, 1},   {8, 8},   {26, 28}, {62, 66}, {4, 7},
                                      {11, 14}, {17, 19}, {29, 33}, {71, 75}, {79, 83}, {90, 131}};

/// Element's place of Gmsh's k-th node. Gmsh: corners, edges, then the same for the ring inside.
std::vector<std::size_t> node_order(bool triangle, std::size_t n) {
  std::vector<std::size_t> places;
  const std::size_t sides = triangle ? 3 : 4;
  for (std::size_t ring = 0; places.size() < point_count(triangle, n, n); ++ring) {
    const std::size_t m =
        n - ring * (triangle ? 3 : 2);  // the ring's degree; its first corner is (ring, ring)
    const auto add = [&](std::size_t side, std::size_t k) {
      const auto [u, v] = along_edge(triangle, m, m, side, k);
      places.push_back(point_place(triangle, n, ring + u, ring + v));
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
    throw MalformedElements{{std::to_string(line) + ": " + why}};
  }
  bool next() {
    if (at >= file.size()) return false;
    rest = file.substr(at, file.find('\n', at) - at);
    at += rest.size() + 1;
    ++line;
    if (rest.ends_with('\r')) rest.remove_suffix(1);
    return true;
  }
  void record() {
    if (!next()) fail("the file ends too early");
  }
  /// The next field; empty if there is none.
  std::string_view field() {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const std::string_view found = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(found.size());
    return found;
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

std::size_t order_of(std::uint64_t type, const std::size_t (&types)[10]) {
  const auto found = std::find(std::begin(types), std::end(types), type);
  return found == std::end(types) ? 0 : static_cast<std::size_t>(found - types) + 1;
}

}  // namespace

void Elements::read_msh(bool lagrange) {
  Lines in{bytes_};
  bool version4 = false;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> tags;  // of nodes, with their places; sorted
  std::vector<std::string_view> z;
  std::string_view first_z;  // of a surface element
  std::map<std::uint64_t, std::vector<std::size_t>> orders;

  /// Announced sizes of sections and blocks; 2.x has one block.
  const auto begin_section = [&](std::uint64_t& blocks) {
    in.record();
    blocks = version4 ? in.number() : 1;
    const std::uint64_t count = in.number();
    in.skip(version4 ? 2 : 0), in.end();
    return count;
  };
  const auto read_nodes = [&] {
    std::uint64_t blocks, parameters = 0;
    const std::uint64_t count = begin_section(blocks);
    const std::size_t likely = std::min<std::size_t>(count, bytes_.size() / 8);
    for (auto* texts : {&x_, &y_, &z}) texts->reserve(likely);
    tags.reserve(likely);
    const auto tag = [&] { tags.emplace_back(in.number(), static_cast<std::uint32_t>(tags.size())); };
    while (blocks-- > 0) {
      std::uint64_t size = count;
      if (version4) {
        in.record();
        parameters = std::min<std::uint64_t>(in.number(), 3);
        in.skip(1);
        if (in.number() == 0) parameters = 0;
        size = in.number(), in.end();
        for (std::uint64_t i = 0; i < size; ++i) in.record(), tag(), in.end();
      }
      for (std::uint64_t i = 0; i < size; ++i) {
        in.record();
        if (!version4) tag();
        for (auto* texts : {&x_, &y_, &z}) texts->push_back(in.text());
        in.skip(parameters), in.end();
      }
    }
    if (tags.size() != count) in.fail("number of nodes is not what was announced");
    std::sort(tags.begin(), tags.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    if (std::adjacent_find(tags.begin(), tags.end(), same) != tags.end()) in.fail("a node tag occurs twice");
  };
  const auto place_of = [&](std::uint64_t tag) {
    const std::uint64_t guess = tags.empty() ? 0 : tag - tags[0].first;  // right if tags are consecutive
    if (guess < tags.size() && tags[guess].first == tag) return tags[guess].second;
    const auto found = std::lower_bound(tags.begin(), tags.end(), std::pair{tag, std::uint32_t{0}});
    if (found == tags.end() || found->first != tag) in.fail("no such node: " + std::to_string(tag));
    return found->second;
  };
  const auto check_z = [&](std::string_view text) {
    const auto value = [&](std::string_view t) {
      return binary64_ ? mpq_class(nearest_double(t)) : exact_number(t, false);
    };
    if (text == first_z) return;
    if (first_z.empty()) first_z = text;
    if (value(text) != value(first_z)) in.fail("surface nodes of different z");
  };
  const auto read_element = [&](std::uint64_t type) {
    const std::size_t triangle = order_of(type, triangles),
                      n = triangle ? triangle : order_of(type, quadrilaterals);
    const auto in_range = [&](const std::size_t(&range)[2]) { return range[0] <= type && type <= range[1]; };
    if (n == 0 && std::any_of(std::begin(ignored), std::end(ignored), in_range)) return;
    if (n == 0) in.fail("element type " + std::to_string(type) + " is serendipity or unknown");
    std::vector<std::size_t>& order = orders[type];
    if (order.empty()) order = node_order(triangle, n);
    const auto degree = static_cast<std::uint16_t>(n);
    shapes_.push_back({triangle != 0, lagrange, degree, degree, nodes_.size()});
    nodes_.resize(nodes_.size() + order.size());
    for (const std::size_t k : order) check_z(z[nodes_[shapes_.back().first + k] = place_of(in.number())]);
    in.end();
  };
  const auto read_elements = [&] {
    std::uint64_t blocks, seen = 0, type = 0;
    const std::uint64_t count = begin_section(blocks);
    while (blocks-- > 0) {
      std::uint64_t size = count;
      if (version4) in.record(), in.skip(2), type = in.number(), size = in.number(), in.end();
      for (std::uint64_t i = 0; i < size; ++i, ++seen) {
        in.record(), in.skip(1);
        if (!version4) type = in.number(), in.skip(in.number());
        read_element(type);
      }
    }
    if (seen != count) in.fail("number of elements is not what was announced");
  };
  const auto read_format = [&] {
    in.record();
    const std::string_view version = in.text();
    version4 = version == "4.1";
    if (!version4 && version != "2" && !version.starts_with("2.")) in.fail("version is not 2.x or 4.1");
    if (in.number() != 0) in.fail("binary: write an elements file with certify check --elements");
    in.skip(1), in.end();
  };

  try {
    const std::string_view sections[] = {"$MeshFormat", "$Nodes", "$Elements"};  // in this order, once each
    std::size_t have = 0;
    while (in.next()) {
      const std::string_view name = in.field();
      if (name.empty()) continue;
      if (name[0] != '$') in.fail("expected the begin of a section");
      in.end();
      const auto known = static_cast<std::size_t>(std::find(sections, sections + 3, name) - sections);
      if (known < 3 && known != have++) in.fail("section repeated or out of order");
      if (known == 0) read_format();
      if (known == 1) read_nodes();
      if (known == 2) read_elements();
      for (bool ended = false; !ended; in.end()) {
        in.record();
        ended = in.field() == "$End" + std::string(name.substr(1));
        if (!ended && known < 3) in.fail("expected the end of " + std::string(name));
        if (!ended) in.rest = {};
      }
    }
  } catch (const MalformedElements&) {
    throw;
  } catch (const Malformed& error) {
    in.fail(error.why);
  }
}

}  // namespace verifier
