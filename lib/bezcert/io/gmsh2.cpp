// Sections of .msh version 2.x.
#include "bezcert/io/gmsh_content.hpp"
#include "bezcert/io/printable.hpp"

namespace bezcert {
namespace {

std::uint64_t read_announced(GmshSource& source, std::string_view what) {
  source.read_tokens("the number of " + std::string(what));
  source.expect_tokens(1, "the number of " + std::string(what));
  return source.natural(0, "number of " + std::string(what));
}

// Binary integers of version 2 are 32-bit and never negative.
std::uint64_t read_natural(GmshSource& source, std::string_view what) {
  const std::int32_t value = source.read_int32(what);
  if (value < 0) source.fail("the " + std::string(what) + " is negative");
  return static_cast<std::uint64_t>(value);
}

void read_element_line(GmshSource& source, GmshContent& content, std::vector<std::uint64_t>& numbers) {
  const std::uint64_t tag = source.natural(0, "element number");
  const GmshType type = content.element_type(source.integer(1, "element type"));
  const std::uint64_t tags = source.natural(2, "number of tags");
  const auto nodes = static_cast<std::size_t>(type.nodes);
  const std::size_t found = source.tokens().size();
  if (tags > found || found != 3 + tags + nodes) {
    source.fail("element " + std::to_string(tag) + " of type " + printable(source.tokens()[1]) + " with " +
                std::to_string(tags) + " tags needs " + std::to_string(nodes) + " nodes: expected " +
                std::to_string(3 + tags + nodes) + " numbers on the line, found " + std::to_string(found));
  }
  numbers.assign(nodes, 0);
  for (std::size_t k = 0; k < nodes && type.type_class == GmshClass::surface; ++k)
    numbers[k] = source.natural(3 + tags + k, "node number");
  content.add_element(type, tag, numbers);
}

// The same for a line that is written plainly; false if it is not, or if anything is wrong with it.
bool read_plain_element(GmshSource& source, GmshContent& content, std::vector<std::uint64_t>& numbers) {
  PlainLine line = source.plain();
  std::uint64_t tag = 0, number = 0, tags = 0, ignored = 0;
  if (!line.natural(tag) || !line.natural(number) || !line.natural(tags) || number > 1000) return false;
  const GmshType type = gmsh_type(static_cast<long>(number));
  if (type.type_class != GmshClass::surface) return false;
  for (std::uint64_t k = 0; k < tags; ++k) {
    if (!line.natural(ignored)) return false;
  }
  numbers.assign(static_cast<std::size_t>(type.nodes), 0);
  for (std::uint64_t& node : numbers) {
    if (!line.natural(node)) return false;
  }
  if (!line.ends()) return false;
  source.take_line(line);
  content.add_element(type, tag, numbers);
  return true;
}

}  // namespace

void read_gmsh2_nodes(GmshSource& source, GmshContent& content, bool parametric) {
  const std::uint64_t count = read_announced(source, "nodes");
  content.reserve_nodes(count);
  if (source.binary) {
    if (parametric) source.fail("binary $ParametricNodes of version 2 are not read: expected $Nodes");
    content.check_count(count, 28, "nodes");
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t tag = read_natural(source, "node number");
      const double x = source.read_double("node coordinate");
      const double y = source.read_double("node coordinate");
      const double z = source.read_double("node coordinate");
      content.add_node(tag, x, y, z);
    }
    return;
  }
  content.check_count(count, 8, "nodes");  // "1 0 0 0\n"
  for (std::uint64_t i = 0; i < count; ++i) {
    PlainLine line = source.plain();
    std::uint64_t tag = 0;
    double x = 0, y = 0, z = 0;
    if (content.binary64() && line.natural(tag) && line.number(x) && line.number(y) && line.number(z) &&
        line.ends()) {
      source.take_line(line);
      content.add_node(tag, x, y, z);
      continue;
    }
    source.read_tokens("node " + std::to_string(i + 1) + " of " + std::to_string(count));
    const auto& tokens = source.tokens();
    if (!parametric || tokens.size() < 6) source.expect_tokens(4, "a node: number, x, y, z");
    content.add_node(source.natural(0, "node number"), tokens[1], tokens[2], tokens[3]);
  }
}

void read_gmsh2_elements(GmshSource& source, GmshContent& content) {
  const std::uint64_t count = read_announced(source, "elements");
  if (!source.binary) {
    content.check_count(count, 6, "elements");
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (read_plain_element(source, content, numbers)) continue;
      source.read_tokens("element " + std::to_string(i + 1) + " of " + std::to_string(count));
      read_element_line(source, content, numbers);
    }
    return;
  }
  content.check_count(count, 8, "elements");
  for (std::uint64_t done = 0; done < count;) {
    const GmshType type = content.element_type(source.read_int32("element type"));
    const std::uint64_t in_block = read_natural(source, "number of elements in a block");
    const std::uint64_t tags = read_natural(source, "number of tags");
    if (in_block == 0 || in_block > count - done) {
      source.fail("a block announces " + std::to_string(in_block) + " elements, expected 1 to " +
                  std::to_string(count - done));
    }
    content.check_count(in_block, 4 * (1 + tags + static_cast<std::size_t>(type.nodes)), "elements");
    content.reserve_elements(type, in_block);
    std::vector<std::uint64_t> numbers(static_cast<std::size_t>(type.nodes));
    for (std::uint64_t i = 0; i < in_block; ++i, ++done) {
      const std::uint64_t tag = read_natural(source, "element number");
      for (std::uint64_t k = 0; k < tags; ++k) source.read_int32("element tag");
      for (std::uint64_t& node : numbers) node = read_natural(source, "node number");
      content.add_element(type, tag, numbers);
    }
  }
}

}  // namespace bezcert
