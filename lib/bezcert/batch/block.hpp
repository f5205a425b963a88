// One block: up to eight elements of one kind, shape and basis, in plain doubles with proven error bounds.
//
// The block finds enclosures of the extreme Bernstein coefficients of det J (times W^3 / ...: see
// BlockResult) and says of each element whether two things are certain:
//   - every Bernstein coefficient of the Jacobian numerator is > 0 (criteria.md, "coefficients": regular);
//   - the element is injective by "midpoint" or "jacobian_hull" (decision.md).
// What it does not settle is no statement at all: the caller decides it with intervals and integers.
// Proofs: kernel.hpp (what is computed), static_bound.hpp (error bounds).
#pragma once

#include "bezcert/batch/lanes.hpp"

#include <cstddef>
#include <cstdint>

namespace bezcert::batch {

enum class Kind { triangle, square, rational_triangle };

/// Larger degrees are not looked at.
inline constexpr int max_block_degree = 10;

/// Error bounds in units (static_bound.hpp), with slack for the operations that use them.
struct Errors {
  double coefficient = 0;  ///< of the smallest and largest coefficient, and the corner ones
  double cone = 0;         ///< of p, q, r, s
  double mixed = 0;
};

/// What a kernel needs to know of a shape in a basis. Arrays are owned by table.cpp and never change.
struct BlockTable {
  Kind kind = Kind::triangle;
  int p = 0;
  int q = 0;
  bool lagrange = false;
  /// Whether midpoint proves injectivity; otherwise the hull is tried.
  bool midpoint = false;
  /// From nodes to control points: entries row_start[i] ... of control point i.
  const std::uint16_t* row_start = nullptr;
  const std::uint16_t* column = nullptr;
  const double* value = nullptr;
  /// Multinomials: of the two derivatives (rational: of the sub-nets), and the inverse ones of the columns
  /// (rational) and of N, there with the factor of det J.
  const double* along_u = nullptr;
  const double* along_v = nullptr;
  const double* columns = nullptr;
  const double* determinant = nullptr;
  Errors errors;
};

/// Coordinates, weights (null if none) and connectivity of a mesh.
struct Nodes {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* weight = nullptr;
  const std::uint32_t* connectivity = nullptr;
};

/// Of each element: whether it is certainly regular and injective, and then enclosures (positive doubles) of
/// the four numbers that DeterminantBounds rounds.
struct BlockResult {
  enum Bound { min_lower, min_upper, max_lower, max_upper };
  double lower[4][lane_count];
  double upper[4][lane_count];
  bool settled[lane_count];
};

/// first_node[k]: where the nodes of element k begin in the connectivity. All eight must be valid; repeat
/// one for a block that is not full.
using BlockFunction = void(const BlockTable&, const Nodes&, const std::size_t* first_node, BlockResult&);

BlockFunction run_block_baseline;
#ifdef __x86_64__
BlockFunction run_block_avx2;
BlockFunction run_block_avx512;
#endif

}  // namespace bezcert::batch
