// A planar mesh as read: nodes given exactly, elements of mixed kind and degree that refer to them.
#pragma once

#include "bezcert/element/element.hpp"
#include "bezcert/mesh/node_tags.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// What text coordinates mean: the nearest double, or their exact decimal value.
enum class Numbers { binary64, decimal };

std::string_view name(Numbers numbers);

/// Cells that are no triangles or quadrilaterals, by dimension: not looked at, but counted.
struct IgnoredCells {
  std::size_t points = 0;
  std::size_t lines = 0;
  std::size_t volumes = 0;
};

struct MeshElement {
  Shape shape;
  Basis basis = Basis::bernstein;
  std::uint64_t tag = 0;       ///< the number the file gives it; else its place, counted from 1
  std::uint32_t line = 0;      ///< line of the file, 0 if it has none (binary)
  std::size_t first_node = 0;  ///< its nodes are connectivity[first_node ...], in the order of shape.hpp
};

class Mesh {
 public:
  ExactVector x;
  ExactVector y;
  /// Weights of the nodes; empty if the file has none.
  ExactVector weights;
  std::vector<std::uint32_t> connectivity;
  std::vector<MeshElement> elements;
  /// Names and expected verdicts of elements (.bez.json); empty, or one an element.
  std::vector<std::string> names;
  std::vector<std::string> expected;
  /// Whether elements are neighbours by common nodes (.msh); otherwise by edges that are exactly equal, and
  /// corners are one vertex if they are one point (.bez.json with elements that list their own points).
  bool glued_by_nodes = true;
  /// The numbers that the file gives its nodes; empty if it has none (then they are their places, from 0).
  NodeTags node_tags;
  IgnoredCells ignored;
  /// What was assumed when reading: for reports.
  std::string basis_name;
  Numbers numbers = Numbers::binary64;

  /// The i-th element with its own copy of its points. Throws std::invalid_argument as Element does.
  Element element(std::size_t i) const;

  /// Whether the i-th element has different weights: it is not polynomial.
  bool rational(std::size_t i) const;

  /// What the file calls a node.
  std::uint64_t node_number(std::uint32_t node) const { return node_tags.empty() ? node : node_tags[node]; }
};

}  // namespace bezcert
