// What the sections of a .msh file say, collected, and the mesh made of it.
#pragma once

#include "bezcert/io/mesh/gmsh_source.hpp"
#include "bezcert/io/mesh/gmsh_types.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"

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
  Executor* executor() const { return options_.executor; }

  /// Places of nodes that come in one go, all with the height z: threads fill them with finite numbers, each
  /// its own. Then they are kept, or dropped.
  struct NodePlaces {
    std::span<double> x, y;
    double z = 0;
  };
  /// Nothing if nodes have to be added one by one: text means decimal numbers, heights differ,
  /// or z is not finite.
  std::optional<NodePlaces> begin_nodes(std::size_t count, double z);
  /// Their tags are tags[first] ...; they are in consecutive lines from `line` on, or in none (0).
  void keep_nodes(const NodeTags& tags, std::size_t first, std::size_t count, std::size_t line, double z);
  void drop_nodes(std::size_t count);

  /// The same for elements of one type, which are there once they are filled.
  struct ElementPlaces {
    std::span<std::uint64_t> tags;
    std::span<std::uint32_t> lines;  // none in a binary file
    std::span<std::uint32_t> nodes;
    std::span<const std::size_t> order;

    void set(std::size_t i, std::uint64_t tag, std::size_t line) const {
      tags[i] = tag;
      if (!lines.empty()) lines[i] = static_cast<std::uint32_t>(line);
    }
    /// The k-th node in gmsh's order. False, and the elements are to be dropped, if its tag is too large.
    bool set_node(std::size_t i, std::size_t k, std::uint64_t tag) const {
      nodes[i * order.size() + order[k]] = static_cast<std::uint32_t>(tag);
      return tag >> 32 == 0;
    }
    /// All nodes, from a line written plainly. False, and the elements are to be dropped, if it is not.
    bool read_nodes(PlainLine& line, std::size_t i) const {
      std::uint64_t tag = 0;
      for (std::size_t k = 0; k < order.size(); ++k) {
        if (!line.natural(tag) || !set_node(i, k, tag)) return false;
      }
      return true;
    }
  };
  /// Nothing if elements have to be added one by one: they are ignored, or there are large tags.
  std::optional<ElementPlaces> begin_elements(const GmshType& type, std::size_t count);
  void drop_elements(std::size_t count);

  /// Room for so many more, if the file can hold them at all: an announced count may be anything.
  void reserve_nodes(std::uint64_t count);
  void reserve_elements(const GmshType& type, std::uint64_t count);

  /// Fails if `count` items of at least `bytes` bytes cannot be in the rest of the file.
  void check_count(std::uint64_t count, std::size_t bytes, std::string_view what) const;

  /// The type of a number in the file; fails if it is refused.
  GmshType element_type(std::int64_t number) const;

  /// Adds an element of a type with its node tags in gmsh's order. Cells that are ignored are counted, and
  /// their nodes need not be given.
  void add_element(const GmshType& type, std::uint64_t tag, std::span<const std::uint64_t> nodes);

  bool has_nodes = false;
  bool has_elements = false;

  /// All of the mesh; checks that nodes exist and that the mesh is planar.
  MeshBuilder finish();

 private:
  struct NodeIndex;

  // Adds what the file says of the next `count` elements: tags and lines, to be written.
  void add_origin(ElementPlaces& places, std::size_t count);

  const std::vector<std::size_t>& node_order(Shape shape);
  void check_finite(double value, std::uint64_t tag) const;
  template <class Number>
  Number coordinate(std::string_view text, std::uint64_t tag) const;
  void add_tag(std::uint64_t tag, std::size_t line);
  void add_line(std::size_t line);
  void add_height(double z);
  // Node tags of elements become places of nodes.
  bool place_consecutive(std::uint64_t first_tag);
  void place_each(const NodeIndex& index);
  void check_height(std::uint32_t node, std::uint32_t first) const;
  std::size_t node_line(std::size_t node) const;

  GmshSource& source_;
  ReadOptions options_;
  // While nodes are not placed, elements have node tags for nodes: 32 bits each while they fit.
  MeshBuilder builder_;
  ExactVector z_;               // empty while all are flat_
  std::optional<double> flat_;  // the z of all nodes so far, if it is one double
  NodeTags node_tags_;
  struct LinesFrom {
    std::size_t node, line;
  };
  std::vector<LinesFrom> node_lines_;  // from this node on one line each; none in a binary file
  std::vector<std::uint64_t> wide_;    // tags of the nodes of elements, once one has more than 32 bits
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
