// What a file said of a mesh beside its geometry: nothing here changes a verdict, reports and messages show
// it.
#pragma once

#include "bezcert/mesh/node_tags.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// What text coordinates mean: the nearest double, or their exact decimal value.
enum class Numbers { binary64, decimal };

inline std::string_view name(Numbers numbers) {
  return numbers == Numbers::binary64 ? "binary64" : "decimal";
}

/// Cells that are no triangles or quadrilaterals, by dimension: not looked at, but counted.
struct IgnoredCells {
  std::size_t points = 0;
  std::size_t lines = 0;
  std::size_t volumes = 0;
};

/// Each list is empty (a mesh made in memory has none of them) or has one entry an element, or a node. The
/// functions take the place of an element or a node in the mesh, and know what stands for a missing list.
/// The names of groups (physical groups of .msh) belong here too: a list of names, and one number an element.
struct MeshOrigin {
  std::vector<std::uint64_t> element_tags;    ///< the numbers the file gives its elements
  std::vector<std::uint32_t> element_lines;   ///< lines of the file; none in a binary file
  std::vector<std::string> element_names;     ///< .bez.json; may be empty texts
  std::vector<std::string> element_expected;  ///< expected verdicts (.bez.json); may be empty texts
  NodeTags node_tags;                         ///< the numbers the file gives its nodes
  IgnoredCells ignored;
  /// What was assumed of the points: "lagrange", "bernstein" or "mixed". MeshBuilder::build sets it.
  std::string basis_name;
  Numbers numbers = Numbers::binary64;

  /// What the file calls an element; else its place, counted from 1.
  std::uint64_t number(std::size_t element) const {
    return element_tags.empty() ? element + 1 : element_tags[element];
  }
  /// The line of an element, 0 if it has none.
  std::uint32_t line(std::size_t element) const { return element_lines.empty() ? 0 : element_lines[element]; }
  /// The name of an element, and the verdict that the file expects of it; empty if it has none.
  std::string_view name(std::size_t element) const { return text(element_names, element); }
  std::string_view expected(std::size_t element) const { return text(element_expected, element); }
  /// What the file calls a node; else its place, counted from 0.
  std::uint64_t node_number(std::uint32_t node) const { return node_tags.empty() ? node : node_tags[node]; }

 private:
  static std::string_view text(const std::vector<std::string>& texts, std::size_t i) {
    return texts.empty() ? std::string_view() : texts[i];
  }
};

}  // namespace bezcert
