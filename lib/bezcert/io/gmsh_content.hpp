// What the sections of a .msh file say, collected, and the mesh made of it.
#pragma once

#include "bezcert/io/gmsh_source.hpp"
#include "bezcert/io/gmsh_types.hpp"
#include "bezcert/io/read.hpp"

#include <map>

namespace bezcert {

class GmshContent {
 public:
  GmshContent(GmshSource& source, const ReadOptions& options) : source_(source), options_(options) {}

  /// A coordinate from text: its meaning is the option's.
  void add_node(std::uint64_t tag, std::string_view x, std::string_view y, std::string_view z);
  void add_node(std::uint64_t tag, double x, double y, double z);

  /// Fails if `count` items of at least `bytes` bytes cannot be in the rest of the file.
  void check_count(std::uint64_t count, std::size_t bytes, std::string_view what) const;

  /// The type of a number in the file; fails if it is refused.
  GmshType element_type(std::int64_t number) const;

  /// Starts an element of a type; then `nodes` node tags in gmsh's order are to be given. Cells that are
  /// ignored are counted here and their nodes need not be given.
  void begin_element(const GmshType& type, std::uint64_t tag);
  void add_element_node(std::uint64_t tag) { element_nodes_.push_back(tag); }
  void end_element();

  bool has_nodes = false;
  bool has_elements = false;

  /// The mesh; checks that nodes exist and that the mesh is planar.
  Mesh finish();

 private:
  struct NodeIndex;

  const std::vector<std::size_t>& node_order(Shape shape);
  void check_finite(double value, std::uint64_t tag) const;
  void add_coordinate(ExactVector& to, std::string_view text, std::uint64_t tag);

  GmshSource& source_;
  ReadOptions options_;
  Mesh mesh_;
  ExactVector z_;
  std::vector<std::uint64_t> node_tags_;
  std::vector<std::size_t> node_lines_;
  std::vector<std::uint64_t> element_nodes_;  // tags of the element being read, gmsh's order
  std::vector<std::uint64_t> connectivity_;   // tags, our order
  MeshElement current_;
  std::map<Shape, std::vector<std::size_t>> orders_;
};

/// The sections of the two versions.
void read_gmsh2_nodes(GmshSource& source, GmshContent& content, bool parametric);
void read_gmsh2_elements(GmshSource& source, GmshContent& content);
void read_gmsh4_nodes(GmshSource& source, GmshContent& content);
void read_gmsh4_elements(GmshSource& source, GmshContent& content);

}  // namespace bezcert
