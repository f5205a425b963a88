// The one way to make a Mesh, for readers of files, for solvers and by hand: whatever is handed in either
// makes a valid mesh or throws MeshError, which names the node or the element.
//
//   MeshBuilder builder;
//   builder.add_nodes_interleaved(points);                                   // x0, y0, x1, y1, ...
//   builder.add_elements(Shape::triangle(2), Basis::lagrange, nodes);  // 6 indices an element
//   const Mesh mesh = std::move(builder).build();
//
// Nodes and elements are counted from 0 as they were added. Nodes of an element may be added after it.
#pragma once

#include "bezcert/mesh/mesh.hpp"

#include <array>
#include <concepts>
#include <initializer_list>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bezcert {

/// What is wrong with a mesh, in one line: "element 3: its node 2 is -1, expected ...".
class MeshError : public std::invalid_argument {
 public:
  explicit MeshError(const std::string& problem) : std::invalid_argument(problem), problem_(problem) {}
  MeshError(std::size_t element, const std::string& problem)
      : std::invalid_argument("element " + std::to_string(element) + ": " + problem),
        problem_(problem),
        element_(element) {}

  /// The element by its place, if one is to blame; and what is wrong, without it.
  std::optional<std::size_t> element() const { return element_; }
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
  std::optional<std::size_t> element_;
};

class MeshBuilder {
 public:
  /// Appends a node with its coordinates (x, y), exactly as given, and its weight; nodes without one have
  /// weight 1 as soon as another has one. Returns its index. Throws MeshError unless there are two finite
  /// coordinates and the weight is finite and positive.
  std::uint32_t add_node(std::initializer_list<double> point, std::optional<double> weight = {});
  std::uint32_t add_node(std::initializer_list<Rational> point, const std::optional<Rational>& weight = {});
  /// Appends nodes from one array x0, y0, x1, y1, ..., or from an array of each coordinate ({x, y}), with no
  /// weights or one a node. Returns the index of the first. Throws MeshError as above, or if counts do not
  /// fit.
  std::uint32_t add_nodes_interleaved(std::span<const double> points, std::span<const double> weights = {});
  std::uint32_t add_nodes_separate(std::initializer_list<std::span<const double>> coordinates,
                                   std::span<const double> weights = {});

  /// Appends an element with its nodes, by index, in the order of shape.hpp; its degrees are 1 to max_degree.
  /// Returns its place. Throws MeshError if there is no element of that shape, the count does not fit it, or
  /// an index is not from 0 to 2^32 - 1.
  std::size_t add_element(Shape shape, Basis basis, std::initializer_list<std::int64_t> nodes);
  /// Appends elements of one shape, their nodes one element after another, from an array of any integers.
  /// Returns the place of the first.
  template <std::ranges::contiguous_range Indices>
  requires std::ranges::sized_range<Indices> && std::integral<std::ranges::range_value_t<Indices>> std::size_t
  add_elements(Shape shape, Basis basis, const Indices& nodes);

  /// Whether elements are neighbours by common nodes (so it is if this is not called), see Mesh.
  void set_glued_by_nodes(bool glued_by_nodes) { mesh_.glued_by_nodes_ = glued_by_nodes; }
  /// What reports are to say of nodes and elements.
  MeshOrigin& origin() { return mesh_.origin_; }

  /// The mesh. Throws MeshError if there are no nodes or no elements, an index is no node's, a list of
  /// origin() has another size than there are elements or nodes, a coordinate that was written to a place
  /// (below) is not finite, or the weights of an element in the Lagrange basis, which are values, belong to a
  /// control net with weights that are not positive. The builder is empty then.
  Mesh build() &&;

  // For readers, which fill places from several threads. Places are good until the next call.

  std::size_t node_count() const { return mesh_.node_count(); }
  const std::vector<MeshElement>& elements() const { return mesh_.elements_; }
  void reserve_nodes(std::size_t more);
  void reserve_elements(std::size_t more, std::size_t nodes_of_each);
  /// Appends nodes at the origin, whose coordinates are to be written; nothing if a node so far is no double.
  std::optional<std::array<std::span<double>, 2>> append_nodes(std::size_t count);
  /// Appends elements whose nodes are to be written, one element after another.
  std::span<std::uint32_t> append_elements(Shape shape, Basis basis, std::size_t count);
  /// Takes back what was appended last. Throws MeshError if there are not so many.
  void drop_nodes(std::size_t count);
  void drop_elements(std::size_t count);
  /// The nodes of all elements so far, to be changed.
  std::span<std::uint32_t> node_indices() { return mesh_.connectivity_; }

 private:
  template <class Number>
  std::uint32_t add_point(std::span<const Number> point, const std::optional<Number>& weight);
  template <class Coordinate>
  std::uint32_t add_points(std::size_t count, std::span<const double> weights, Coordinate coordinate);
  std::size_t count_elements(Shape shape, Basis basis, std::size_t nodes) const;
  [[noreturn]] static void fail_index(std::size_t element, std::size_t place, const std::string& index,
                                      const std::string& expected);
  void check_sizes() const;
  void check_coordinates() const;
  void check_connectivity() const;
  void check_origin() const;
  void check_converted_weights() const;

  Mesh mesh_;  // so far
  std::size_t edges_ = 0;
  std::array<std::size_t, 2> in_basis_{};  // elements in each basis
};

template <std::ranges::contiguous_range Indices>
requires std::ranges::sized_range<Indices> && std::integral<std::ranges::range_value_t<Indices>> std::size_t
MeshBuilder::add_elements(Shape shape, Basis basis, const Indices& nodes) {
  const auto* const from = std::ranges::data(nodes);
  const std::size_t first = mesh_.elements_.size(),
                    count = count_elements(shape, basis, std::ranges::size(nodes));
  const std::span<std::uint32_t> to = append_elements(shape, basis, count);
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = static_cast<std::uint32_t>(from[i]);
    if (std::in_range<std::uint32_t>(from[i])) continue;
    const std::size_t each = to.size() / count;
    drop_elements(count);
    fail_index(first + i / each, i % each, std::to_string(from[i]),
               "the index of a node, from 0 to below 2^32 - 1");
  }
  return first;
}

}  // namespace bezcert
