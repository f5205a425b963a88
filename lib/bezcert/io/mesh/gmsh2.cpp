// Sections of .msh version 2.x.
#include "bezcert/io/mesh/gmsh_content.hpp"
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

// What a plain line of an element says before its nodes: number, type, and tags, which are skipped.
struct ElementStart {
  std::uint64_t tag = 0, type = 0;

  bool read(PlainLine& line) {
    std::uint64_t tags = 0, ignored = 0;
    if (!line.natural(tag) || !line.natural(type) || !line.natural(tags)) return false;
    for (std::uint64_t k = 0; k < tags; ++k) {
      if (!line.natural(ignored)) return false;
    }
    return type <= 1000;
  }
  GmshType gmsh() const { return gmsh_type(static_cast<long>(type)); }
};

// A line that is written plainly; false if it is not, or if anything is wrong with it.
bool read_plain_element(GmshSource& source, GmshContent& content, std::vector<std::uint64_t>& numbers) {
  PlainLine line = source.plain();
  ElementStart start;
  if (!start.read(line)) return false;
  const GmshType type = start.gmsh();
  if (type.type_class != GmshClass::surface) return false;
  numbers.assign(static_cast<std::size_t>(type.nodes), 0);
  for (std::uint64_t& node : numbers) {
    if (!line.natural(node)) return false;
  }
  if (!line.ends()) return false;
  source.take_line(line);
  content.add_element(type, start.tag, numbers);
  return true;
}

struct NodeLine {
  std::uint64_t tag = 0;
  double x = 0, y = 0, z = 0;

  bool read(PlainLine& line) {
    return line.natural(tag) && line.number(x) && line.number(y) && line.number(z);
  }
};

// Nodes in one plane, written plainly; false if they are not, and nothing has been read.
bool read_plain_nodes(GmshSource& source, GmshContent& content, std::size_t count) {
  PlainLine peek = source.plain();
  NodeLine first;
  if (!first.read(peek)) return false;
  const auto places = content.begin_nodes(count, first.z);
  if (!places) return false;
  std::vector<std::uint64_t> list(count);
  const std::size_t line_before = source.line();
  const bool read = source.read_plainly(count, content.executor(), [&](PlainLine& line, std::size_t i) {
    NodeLine node;
    if (!node.read(line) || node.z != first.z) return false;
    list[i] = node.tag;
    places->x[i] = node.x;
    places->y[i] = node.y;
    return true;
  });
  if (read) {
    NodeTags tags;
    for (const std::uint64_t tag : list) tags.push_back(tag);
    content.keep_nodes(tags, 0, count, line_before + 1, first.z);
  } else {
    content.drop_nodes(count);
  }
  return read;
}

void read_text_nodes(GmshSource& source, GmshContent& content, std::size_t count, bool parametric) {
  constexpr std::size_t round = std::size_t{1} << 19;
  const auto read_round = [&](std::size_t, std::size_t size) {
    return read_plain_nodes(source, content, size);
  };
  read_rounds(count, round, read_round, [&](std::size_t i) {
    PlainLine line = source.plain();
    NodeLine node;
    if (content.binary64() && node.read(line) && line.ends()) {
      source.take_line(line);
      return content.add_node(node.tag, node.x, node.y, node.z);
    }
    source.read_tokens("node " + std::to_string(i + 1) + " of " + std::to_string(count));
    const auto& tokens = source.tokens();
    if (!parametric || tokens.size() < 6) source.expect_tokens(4, "a node: number, x, y, z");
    content.add_node(source.natural(0, "node number"), tokens[1], tokens[2], tokens[3]);
  });
}

// Elements of one type, written plainly; false if they are not, and nothing has been read.
bool read_plain_elements(GmshSource& source, GmshContent& content, std::size_t count) {
  PlainLine peek = source.plain();
  ElementStart first;
  if (!first.read(peek)) return false;
  const GmshType type = first.gmsh();
  content.reserve_elements(type, count);
  const auto places = content.begin_elements(type, count);
  if (!places) return false;
  const std::size_t line_before = source.line();
  const bool read = source.read_plainly(count, content.executor(), [&](PlainLine& line, std::size_t i) {
    ElementStart start;
    if (!start.read(line) || start.type != first.type) return false;
    places->set(i, start.tag, line_before + 1 + i);
    return places->read_nodes(line, i);
  });
  if (!read) content.drop_elements(count);
  return read;
}

void read_text_elements(GmshSource& source, GmshContent& content, std::size_t count) {
  // Where types change lines are read one by one: that is to be few.
  constexpr std::size_t round = std::size_t{1} << 13;
  const auto read_round = [&](std::size_t, std::size_t size) {
    return read_plain_elements(source, content, size);
  };
  std::vector<std::uint64_t> numbers;
  read_rounds(count, round, read_round, [&](std::size_t i) {
    if (read_plain_element(source, content, numbers)) return;
    source.read_tokens("element " + std::to_string(i + 1) + " of " + std::to_string(count));
    read_element_line(source, content, numbers);
  });
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
  read_text_nodes(source, content, count, parametric);
}

void read_gmsh2_elements(GmshSource& source, GmshContent& content) {
  const std::uint64_t count = read_announced(source, "elements");
  if (!source.binary) {
    content.check_count(count, 6, "elements");
    return read_text_elements(source, content, count);
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
