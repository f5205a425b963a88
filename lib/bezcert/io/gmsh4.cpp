// Sections of .msh version 4.1.
#include "bezcert/io/gmsh_content.hpp"

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

void read_node_block(GmshSource& source, GmshContent& content, const Block& block) {
  const auto extra = static_cast<std::size_t>(block.third != 0 ? block.dimension : 0);
  std::vector<std::uint64_t> tags;
  if (source.binary) {
    content.check_count(block.count, 8 + 8 * (3 + extra), "nodes");
    for (std::uint64_t i = 0; i < block.count; ++i) tags.push_back(source.read_uint64("node tag"));
    for (const std::uint64_t tag : tags) {
      const double x = source.read_double("node coordinate");
      const double y = source.read_double("node coordinate");
      const double z = source.read_double("node coordinate");
      for (std::size_t k = 0; k < extra; ++k) source.read_double("node parameter");
      content.add_node(tag, x, y, z);
    }
    return;
  }
  content.check_count(block.count, 8, "nodes");
  for (std::uint64_t i = 0; i < block.count; ++i) {
    source.read_tokens("a node tag");
    source.expect_tokens(1, "a node tag");
    tags.push_back(source.natural(0, "node tag"));
  }
  for (const std::uint64_t tag : tags) {
    source.read_tokens("the coordinates of node " + std::to_string(tag));
    source.expect_tokens(3 + extra, "the coordinates of node " + std::to_string(tag));
    content.add_node(tag, source.tokens()[0], source.tokens()[1], source.tokens()[2]);
  }
}

void read_element_block(GmshSource& source, GmshContent& content, const Block& block) {
  const GmshType type = content.element_type(block.third);
  const auto nodes = static_cast<std::size_t>(type.nodes);
  const std::size_t numbers = 1 + nodes;
  content.check_count(block.count, source.binary ? 8 * numbers : 2 * numbers, "elements");
  for (std::uint64_t i = 0; i < block.count; ++i) {
    if (source.binary) {
      content.begin_element(type, source.read_uint64("element tag"));
      for (std::size_t k = 0; k < nodes; ++k) content.add_element_node(source.read_uint64("node tag"));
    } else {
      source.read_tokens("element " + std::to_string(i + 1) + " of a block of " +
                         std::to_string(block.count));
      source.expect_tokens(numbers, "an element of type " + std::to_string(block.third) + ": tag and nodes");
      content.begin_element(type, source.natural(0, "element tag"));
      if (type.type_class != GmshClass::surface) continue;
      for (std::size_t k = 0; k < nodes; ++k) content.add_element_node(source.natural(1 + k, "node tag"));
    }
    if (type.type_class == GmshClass::surface) content.end_element();
  }
}

}  // namespace

void read_gmsh4_nodes(GmshSource& source, GmshContent& content) {
  const Header header = read_header(source, "nodes");
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
