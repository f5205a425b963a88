// Sections of .msh version 4.1.
#include "bezcert/io/gmsh_content.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace bezcert {
namespace {

struct Header {
  std::uint64_t blocks = 0;
  std::uint64_t items = 0;
};

// numEntityBlocks numItems minTag maxTag
Header read_header(GmshSource& source, const std::string& what) {
  if (source.binary) {
    const Header header{source.read_uint64("number of blocks"), source.read_uint64("number of " + what)};
    source.read_uint64("smallest tag");
    source.read_uint64("largest tag");
    return header;
  }
  source.read_tokens("the numbers of blocks and " + what);
  source.expect_tokens(4, "the header: blocks, " + what + ", smallest tag, largest tag");
  return {source.natural(0, "number of blocks"), source.natural(1, "number of " + what)};
}

struct Block {
  std::int64_t dimension = 0;
  std::int64_t third = 0;  // parametric flag of nodes, type of elements
  std::uint64_t count = 0;
};

Block read_block(GmshSource& source, const std::string& what, std::uint64_t left) {
  Block block;
  if (source.binary) {
    block.dimension = source.read_int32("dimension of a block");
    source.read_int32("entity of a block");
    block.third = source.read_int32("third number of a block");
    block.count = source.read_uint64("number of " + what + " in a block");
  } else {
    source.read_tokens("a block of " + what);
    source.expect_tokens(4, "a block of " + what);
    block.dimension = source.integer(0, "dimension of a block");
    source.integer(1, "entity of a block");
    block.third = source.integer(2, "third number of a block");
    block.count = source.natural(3, "number of " + what + " in a block");
  }
  if (block.dimension < 0 || block.dimension > 3) {
    source.fail("the dimension of a block is " + std::to_string(block.dimension) + ", expected 0 to 3");
  }
  if (block.count > left) {
    source.fail("a block announces " + std::to_string(block.count) + " " + what + ", but only " +
                std::to_string(left) + " of the section's are left");
  }
  return block;
}

void check_all_read(GmshSource& source, std::uint64_t left, const std::string& what) {
  if (left > 0) source.fail("the blocks hold " + std::to_string(left) + " " + what + " fewer than announced");
}

// Lines that threads read side by side, and keep the numbers of, at a time.
constexpr std::size_t round_size = 1 << 16;

// A line of as many natural numbers as there is room for.
bool read_plainly(PlainLine& line, std::span<std::uint64_t> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [&](std::uint64_t& n) { return line.natural(n); });
}

std::uint64_t read_tag(GmshSource& source) {
  PlainLine line = source.plain();
  std::uint64_t tag = 0;
  if (line.natural(tag) && line.ends()) {
    source.take_line(line);
    return tag;
  }
  source.read_tokens("a node tag");
  source.expect_tokens(1, "a node tag");
  return source.natural(0, "node tag");
}

void read_coordinates(GmshSource& source, GmshContent& content, std::uint64_t tag, std::size_t extra) {
  PlainLine line = source.plain();
  double x = 0, y = 0, z = 0;
  if (content.binary64() && extra == 0 && line.number(x) && line.number(y) && line.number(z) && line.ends()) {
    source.take_line(line);
    return content.add_node(tag, x, y, z);
  }
  source.read_tokens("the coordinates of node " + std::to_string(tag));
  source.expect_tokens(3 + extra, "the coordinates of node " + std::to_string(tag));
  content.add_node(tag, source.tokens()[0], source.tokens()[1], source.tokens()[2]);
}

void read_element_line(GmshSource& source, GmshContent& content, const GmshType& type, const Block& block,
                       std::uint64_t place, std::span<std::uint64_t> numbers) {
  PlainLine line = source.plain();
  if (read_plainly(line, numbers) && line.ends()) {
    source.take_line(line);
  } else {
    source.read_tokens("element " + std::to_string(place + 1) + " of a block of " +
                       std::to_string(block.count));
    source.expect_tokens(numbers.size(),
                         "an element of type " + std::to_string(block.third) + ": tag and nodes");
    const bool surface = type.type_class == GmshClass::surface;
    numbers[0] = source.natural(0, "element tag");
    for (std::size_t k = 1; k < numbers.size() && surface; ++k) numbers[k] = source.natural(k, "node tag");
  }
  content.add_element(type, numbers[0], numbers.subspan(1));
}

void read_node_block(GmshSource& source, GmshContent& content, const Block& block) {
  const auto extra = static_cast<std::size_t>(block.third != 0 ? block.dimension : 0);
  std::vector<std::uint64_t> tags;
  if (source.binary) {
    content.check_count(block.count, 8 + 8 * (3 + extra), "nodes");
    tags.resize(block.count);
    source.read_block(tags.size(), tags.data());
    std::array<double, 6> numbers{};  // coordinates and parameters
    for (const std::uint64_t tag : tags) {
      source.read_block(3 + extra, numbers.data());
      content.add_node(tag, numbers[0], numbers[1], numbers[2]);
    }
    return;
  }
  content.check_count(block.count, 8, "nodes");
  const std::size_t count = block.count;
  const Parallel& parallel = content.parallel();
  const auto for_rounds = [&](auto round, auto each) {
    for (std::size_t first = 0; first < count; first += round_size) {
      const std::size_t size = std::min(round_size, count - first);
      if (parallel && round(first, size)) continue;
      for (std::size_t i = first; i < first + size; ++i) each(i);
    }
  };
  tags.resize(count);
  for_rounds(
      [&](std::size_t first, std::size_t size) {
        return source.read_plainly(
            size, parallel, [&](PlainLine& line, std::size_t i) { return line.natural(tags[first + i]); });
      },
      [&](std::size_t i) { tags[i] = read_tag(source); });
  std::vector<double> xyz;
  for_rounds(
      [&](std::size_t first, std::size_t size) {
        if (!content.binary64() || extra != 0) return false;
        xyz.resize(3 * size);
        const std::size_t line_before = source.line();
        const bool read = source.read_plainly(size, parallel, [&](PlainLine& line, std::size_t i) {
          return line.number(xyz[3 * i]) && line.number(xyz[3 * i + 1]) && line.number(xyz[3 * i + 2]);
        });
        if (read) content.add_nodes(std::span(tags).subspan(first, size), xyz, line_before + 1);
        return read;
      },
      [&](std::size_t i) { read_coordinates(source, content, tags[i], extra); });
}

void read_element_block(GmshSource& source, GmshContent& content, const Block& block) {
  const GmshType type = content.element_type(block.third);
  const auto nodes = static_cast<std::size_t>(type.nodes);
  content.check_count(block.count, source.binary ? 8 * (1 + nodes) : 2 * (1 + nodes), "elements");
  content.reserve_elements(type, block.count);
  std::vector<std::uint64_t> numbers(1 + nodes);  // the tag and the nodes
  if (source.binary) {
    for (std::uint64_t i = 0; i < block.count; ++i) {
      source.read_block(numbers.size(), numbers.data());
      content.add_element(type, numbers[0], std::span(numbers).subspan(1));
    }
    return;
  }
  const std::size_t width = numbers.size(), at_once = std::max<std::size_t>(1, round_size / width);
  std::vector<std::uint64_t> many;
  for (std::uint64_t first = 0; first < block.count; first += at_once) {
    const std::size_t size = std::min<std::uint64_t>(at_once, block.count - first);
    if (content.parallel()) {
      many.resize(size * width);
      const auto row = [&](std::size_t i) { return std::span(many).subspan(i * width, width); };
      const std::size_t line_before = source.line();
      if (source.read_plainly(size, content.parallel(),
                              [&](PlainLine& line, std::size_t i) { return read_plainly(line, row(i)); })) {
        for (std::size_t i = 0; i < size; ++i) {
          content.add_element(type, row(i)[0], row(i).subspan(1), line_before + 1 + i);
        }
        continue;
      }
    }
    for (std::uint64_t i = first; i < first + size; ++i) {
      read_element_line(source, content, type, block, i, numbers);
    }
  }
}

}  // namespace

void read_gmsh4_nodes(GmshSource& source, GmshContent& content) {
  const Header header = read_header(source, "nodes");
  content.reserve_nodes(header.items);
  std::uint64_t left = header.items;
  for (std::uint64_t b = 0; b < header.blocks; ++b) {
    const Block block = read_block(source, "nodes", left);
    read_node_block(source, content, block);
    left -= block.count;
  }
  check_all_read(source, left, "nodes");
}

void read_gmsh4_elements(GmshSource& source, GmshContent& content) {
  const Header header = read_header(source, "elements");
  std::uint64_t left = header.items;
  for (std::uint64_t b = 0; b < header.blocks; ++b) {
    const Block block = read_block(source, "elements", left);
    read_element_block(source, content, block);
    left -= block.count;
  }
  check_all_read(source, left, "elements");
}

}  // namespace bezcert
