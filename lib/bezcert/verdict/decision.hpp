// The outcome of the exact decision of one element, with its evidence.
#pragma once

#include "bezcert/element/determinant_bounds.hpp"
#include "bezcert/verdict/element_verdict.hpp"
#include "bezcert/verdict/witness.hpp"

#include <optional>
#include <vector>

namespace bezcert {

/// A limit that a search met, in units that do not depend on the machine (Budget, decide/decide.hpp).
struct ExhaustedBudget {
  enum class Limit {
    depth,           ///< halvings for one piece of the subdivision of N
    pieces,          ///< pieces of it
    memory_bits,     ///< bits of the coefficients of all pieces
    factoring_bits,  ///< algebra bits, of which a sixteenth may go into N when it is factored
    factor_bits,     ///< algebra bits, for the resultants of a factor of N
    contact_bits     ///< algebra bits, for the contact of two edges
  };
  Limit limit = Limit::pieces;
  std::size_t allowed = 0;
  /// Algebra bits: what would have been needed (factoring_bits: the bits of N).
  std::size_t needed = 0;
  /// factor_bits: the degrees of the factor in u and in v.
  int degree_u = 0, degree_v = 0;
};

struct Decision {
  ElementVerdict verdict = ElementVerdict::undecided;
  /// folded, reversed: det J < 0 there. degenerate: det J = 0 there, if a rational zero is known (`zero`
  /// tells otherwise). undecided: the lowest value met, if it is not positive.
  std::optional<Witness> witness;
  /// folded: a parameter with det J >= 0, so that the element is not reversed.
  std::optional<Witness> other_witness;
  /// degenerate: the zero set of det J; its dimension is -1 if the budget for algebra is too small to tell.
  std::optional<AlgebraicZero> zero;
  /// overlapping: two parts of the boundary with a common image point.
  std::optional<Overlap> overlap;
  /// Proven bounds of min and max det J, as the subdivision left them.
  DeterminantBounds bounds;
  /// What told the signs of det J (undecided: what was tried last).
  SignProof sign_proof = SignProof::coefficients;
  /// injective: what showed it.
  InjectivityProof injectivity_proof = InjectivityProof::none;
  /// undecided: the limits that ran out. regular: the one that is in the way of injective.
  std::vector<ExhaustedBudget> exhausted;
  /// Pieces of the subdivision of N that were looked at.
  std::size_t pieces = 0;
};

/// Whether the element is certainly not certifiable: an invalid verdict, or undecided with a witness that
/// det J <= 0 somewhere.
bool certainly_invalid(const Decision& decision);

}  // namespace bezcert
