// What is said of a mesh as a whole, and what of one element it rests on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace bezcert {

/// Of a mesh: `embedding`, or the kind of its first obstacle in this order. `undecided`: a budget ran out
/// somewhere, and nothing else is wrong.
enum class MeshVerdict {
  embedding,
  invalid_element,
  non_manifold,
  non_conforming,
  folded_vertex,
  overlapping_boundary,
  undecided
};

inline constexpr std::size_t mesh_verdict_count = 7;

std::string_view name(MeshVerdict verdict);

/// What is known of one element alone.
enum class ElementState : std::uint8_t { injective, invalid, open };

}  // namespace bezcert
