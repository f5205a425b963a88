// Sections of .msh version 4.1.
#include "bezcert/io/mesh/gmsh_content.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
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

// Nodes or elements of a binary file that a thread takes in one go.
constexpr std::size_t part = std::size_t{1} << 12;

// Lines that are read again one by one if one of them is not plain.
constexpr std::size_t round_size = std::size_t{1} << 19;

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

// The tags of a block's nodes, a line each: numbers that follow each other, nearly always.
NodeTags read_tags(GmshSource& source, Executor* executor, std::size_t count) {
  NodeTags tags;
  PlainLine peek = source.plain();
  std::uint64_t first = 0;
  const auto follows = [&](PlainLine& line, std::size_t i) {
    std::uint64_t tag = 0;
    return line.natural(tag) && tag == first + i;
  };
  if (peek.natural(first) && source.read_plainly(count, executor, follows)) {
    tags.append_consecutive(first, count);
    return tags;
  }
  std::vector<std::uint64_t> list(count);
  const auto read_round = [&](std::size_t begin, std::size_t size) {
    return source.read_plainly(size, executor,
                               [&](PlainLine& line, std::size_t i) { return line.natural(list[begin + i]); });
  };
  read_rounds(count, round_size, read_round, [&](std::size_t i) { list[i] = read_tag(source); });
  for (const std::uint64_t tag : list) tags.push_back(tag);
  return tags;
}

void read_text_nodes(GmshSource& source, GmshContent& content, std::size_t count, std::size_t extra) {
  const NodeTags tags = read_tags(source, content.executor(), count);
  const auto read_points = [&](std::size_t first, std::size_t size) {
    if (extra != 0) return false;
    PlainLine peek = source.plain();
    double x = 0, y = 0, z = 0;
    if (!peek.number(x) || !peek.number(y) || !peek.number(z)) return false;
    const auto places = content.begin_nodes(size, z);
    if (!places) return false;
    const std::size_t line_before = source.line();
    const bool read = source.read_plainly(size, content.executor(), [&](PlainLine& line, std::size_t i) {
      double height = 0;
      return line.number(places->x[i]) && line.number(places->y[i]) && line.number(height) &&
             height == places->z;
    });
    if (read) {
      content.keep_nodes(tags, first, size, line_before + 1, z);
    } else {
      content.drop_nodes(size);
    }
    return read;
  };
  read_rounds(count, round_size, read_points,
              [&](std::size_t i) { read_coordinates(source, content, tags[i], extra); });
}

void read_binary_nodes(GmshSource& source, GmshContent& content, std::size_t count, std::size_t extra) {
  if (count == 0) return;
  const std::size_t width = 8 * (3 + extra);  // coordinates and parameters
  const char* const tag_bytes = source.take_bytes(8 * count);
  const char* const bytes = source.next_bytes();
  const auto tag = [&](std::size_t i) { return source.number_at<std::uint64_t>(tag_bytes + 8 * i); };
  const auto number = [&](std::size_t i, std::size_t k) {
    return source.number_at<double>(bytes + i * width + 8 * k);
  };
  const auto places = content.begin_nodes(count, number(0, 2));
  std::atomic<bool> plain = places.has_value(), consecutive = true;
  run_ranges(content.executor(), places ? count : 0, part, [&](std::size_t begin, std::size_t end) {
    bool all = true, follow = true;
    for (std::size_t i = begin; i < end; ++i) {
      follow &= tag(i) == tag(0) + i;
      places->x[i] = number(i, 0);
      places->y[i] = number(i, 1);
      all &= std::isfinite(places->x[i]) && std::isfinite(places->y[i]) && number(i, 2) == places->z;
    }
    if (!all) plain = false;
    if (!follow) consecutive = false;
  });
  if (plain) {
    source.take_bytes(width * count);
    NodeTags tags;
    if (consecutive) {
      tags.append_consecutive(tag(0), count);
    } else {
      for (std::size_t i = 0; i < count; ++i) tags.push_back(tag(i));
    }
    return content.keep_nodes(tags, 0, count, 0, places->z);
  }
  if (places) content.drop_nodes(count);
  for (std::size_t i = 0; i < count; ++i) {
    source.take_bytes(width);
    content.add_node(tag(i), number(i, 0), number(i, 1), number(i, 2));
  }
}

void read_node_block(GmshSource& source, GmshContent& content, const Block& block) {
  const auto extra = static_cast<std::size_t>(block.third != 0 ? block.dimension : 0);
  content.check_count(block.count, source.binary ? 8 + 8 * (3 + extra) : 8, "nodes");
  (source.binary ? read_binary_nodes : read_text_nodes)(source, content, block.count, extra);
}

void read_text_elements(GmshSource& source, GmshContent& content, const GmshType& type, const Block& block) {
  std::vector<std::uint64_t> numbers(1 + static_cast<std::size_t>(type.nodes));  // the tag and the nodes
  const auto read_round = [&](std::size_t, std::size_t size) {
    const auto places = content.begin_elements(type, size);
    if (!places) return false;
    const std::size_t line_before = source.line();
    const bool read = source.read_plainly(size, content.executor(), [&](PlainLine& line, std::size_t i) {
      std::uint64_t tag = 0;
      if (!line.natural(tag)) return false;
      places->set(i, tag, line_before + 1 + i);
      return places->read_nodes(line, i);
    });
    if (!read) content.drop_elements(size);
    return read;
  };
  read_rounds(block.count, round_size, read_round,
              [&](std::size_t i) { read_element_line(source, content, type, block, i, numbers); });
}

void read_binary_elements(GmshSource& source, GmshContent& content, const GmshType& type, std::size_t count) {
  const auto nodes = static_cast<std::size_t>(type.nodes);
  const std::size_t width = 8 * (1 + nodes);  // the tag and the nodes
  const char* const bytes = source.take_bytes(width * count);
  const auto number = [&](std::size_t i, std::size_t k) {
    return source.number_at<std::uint64_t>(bytes + i * width + 8 * k);
  };
  if (const auto places = content.begin_elements(type, count)) {
    std::atomic<bool> plain = true;
    run_ranges(content.executor(), count, part, [&](std::size_t begin, std::size_t end) {
      bool all = true;
      for (std::size_t i = begin; i < end; ++i) {
        places->set(i, number(i, 0), 0);
        for (std::size_t k = 0; k < nodes; ++k) all &= places->set_node(i, k, number(i, 1 + k));
      }
      if (!all) plain = false;
    });
    if (plain) return;
    content.drop_elements(count);
  }
  std::vector<std::uint64_t> numbers(nodes);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < nodes; ++k) numbers[k] = number(i, 1 + k);
    content.add_element(type, number(i, 0), numbers);
  }
}

void read_element_block(GmshSource& source, GmshContent& content, const Block& block) {
  const GmshType type = content.element_type(block.third);
  const auto nodes = static_cast<std::size_t>(type.nodes);
  content.check_count(block.count, source.binary ? 8 * (1 + nodes) : 2 * (1 + nodes), "elements");
  content.reserve_elements(type, block.count);
  if (source.binary) {
    read_binary_elements(source, content, type, block.count);
  } else {
    read_text_elements(source, content, type, block);
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
