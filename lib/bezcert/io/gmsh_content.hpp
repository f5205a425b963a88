// What the sections of a .msh file say, collected, and the mesh made of it.
#pragma once

#include "bezcert/io/gmsh_source.hpp"
#include "bezcert/io/gmsh_types.hpp"
#include "bezcert/io/read.hpp"

#include <map>
#include <optional>
#include <span>

namespace bezcert {

class GmshContent {
 public:
  GmshContent(GmshSource& source, const ReadOptions& options) : source_(source), options_(options) {}

  /// A coordinate from text: its meaning is the option's.
  void add_node(std::uint64_t tag, std::string_view x, std::string_view y, std::string_view z);
  void add_node(std::uint64_t tag, double x, double y, double z);
  /// Whether text coordinates mean the nearest double.
  bool binary64() const { return options_.numbers == Numbers::binary64; }
  /// Threads that may help; empty: none.
  const Parallel& parallel() const { return options_.parallel; }
  /// Adds nodes that are in consecutive lines, of which the first was `line`.
  void add_nodes(std::span<const std::uint64_t> tags, std::span<const double> xyz, std::size_t line);
  /// Room for so many more, if the file can hold them at all: an announced count may be anything.
  void reserve_nodes(std::uint64_t count);
  void reserve_elements(const GmshType& type, std::uint64_t count);

  /// Fails if `count` items of at least `bytes` bytes cannot be in the rest of the file.
  void check_count(std::uint64_t count, std::size_t bytes, std::string_view what) const;

  /// The type of a number in the file; fails if it is refused.
  GmshType element_type(std::int64_t number) const;

  /// Adds an element of a type with its node tags in gmsh's order. Cells that are ignored are counted, and
  /// their nodes need not be given.
  void add_element(const GmshType& type, std::uint64_t tag, std::span<const std::uint64_t> nodes) {
    add_element(type, tag, nodes, source_.line());
  }
  void add_element(const GmshType& type, std::uint64_t tag, std::span<const std::uint64_t> nodes,
                   std::size_t line);

  bool has_nodes = false;
  bool has_elements = false;

  /// The mesh; checks that nodes exist and that the mesh is planar.
  Mesh finish();

 private:
  struct NodeIndex;

  // Node tags of elements, in our order: 32 bits each while they fit, and then the mesh's places in the same
  // memory.
  void append_tags(std::span<const std::uint64_t> nodes, const std::vector<std::size_t>& order);
  std::uint64_t tag_at(std::size_t i) const { return wide_.empty() ? mesh_.connectivity[i] : wide_[i]; }

  const std::vector<std::size_t>& node_order(Shape shape);
  void check_finite(double value, std::uint64_t tag) const;
  void add_coordinate(ExactVector& to, std::string_view text, std::uint64_t tag);
  void add_tag(std::uint64_t tag, std::size_t line);
  void add_height(double z);
  bool same_height(std::uint32_t a, std::uint32_t b) const;
  std::size_t node_line(std::size_t node) const;

  GmshSource& source_;
  ReadOptions options_;
  Mesh mesh_;
  ExactVector z_;               // empty while all are flat_
  std::optional<double> flat_;  // the z of all nodes so far, if it is one double
  NodeTags node_tags_;
  struct LinesFrom {
    std::size_t node, line;
  };
  std::vector<LinesFrom> node_lines_;  // from this node on one line each; none in a binary file
  std::vector<std::uint64_t> wide_;    // instead of mesh_.connectivity, with tags of more than 32 bits
  std::map<Shape, std::vector<std::size_t>> orders_;
  const std::vector<std::size_t>* last_order_ = nullptr;
  Shape last_shape_;
};

/// The sections of the two versions.
void read_gmsh2_nodes(GmshSource& source, GmshContent& content, bool parametric);
void read_gmsh2_elements(GmshSource& source, GmshContent& content);
void read_gmsh4_nodes(GmshSource& source, GmshContent& content);
void read_gmsh4_elements(GmshSource& source, GmshContent& content);

}  // namespace bezcert
