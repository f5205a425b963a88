// The signs and zeros of the Jacobian numerator N, decided by algebra: for what dyadic subdivision cannot
// settle.
//
// N is factored over the rationals; N changes its sign exactly where a factor of odd multiplicity does, and
// vanishes where any factor does (algebra/zero_set.hpp). Proof in docs/decision.md, "Algebra".
#pragma once

#include "bezcert/algebra/zero_set.hpp"
#include "bezcert/verdict/decision.hpp"

#include <array>
#include <optional>

namespace bezcert {

struct AlgebraicSigns {
  /// Set if the budget is too small; then nothing else is.
  std::optional<ExhaustedBudget> exhausted;
  /// A rational (u, v) where N has the sign asked for, if N has it anywhere.
  std::optional<std::array<Rational, 2>> opposite;
  /// Only if there is no `opposite`.
  std::optional<AlgebraicZero> zero;
};

/// Whether N takes the sign `wanted` (1 or -1) and, if not, whether it vanishes. Only columns in the strips
/// are looked at. Preconditions: n is not 0; it takes the other sign -wanted somewhere; n is not 0 at zeros
/// outside the strips, but on edges.
AlgebraicSigns algebraic_signs(const Polynomial<Integer>& n, int wanted, const Strips& strips_u,
                               const Strips& strips_v, std::size_t budget_bits);

}  // namespace bezcert
