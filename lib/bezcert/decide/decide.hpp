// The exact decision of one element.
//
// Theorem used (docs/decision.md): let S be the set of signs that det J takes on the closed element. S = {+}
// is regular; {0} or {0,+} degenerate; {-} reversed; every other S folded. Subdivision of the Jacobian
// numerator finds S: on a piece whose coefficients have one sign, the signs of N are known; a corner of a
// piece gives the sign at a dyadic parameter. Where N touches zero, or nearly so, subdivision does not end:
// what it leaves open goes to algebra (algebraic.hpp). All signs are exact. What is open when a budget is
// spent is `undecided`, never a guess.
#pragma once

#include "bezcert/decide/algebraic.hpp"
#include "bezcert/decide/boundary.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/proof/verdict.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace bezcert {

enum class ElementVerdict { injective, regular, overlapping, degenerate, folded, reversed, undecided };

/// All verdicts, in the order of reports.
inline constexpr std::array element_verdicts = {ElementVerdict::injective,   ElementVerdict::regular,
                                                ElementVerdict::overlapping, ElementVerdict::degenerate,
                                                ElementVerdict::folded,      ElementVerdict::reversed,
                                                ElementVerdict::undecided};

std::string_view name(ElementVerdict verdict);

/// Whether det J > 0 on the closed element is certain, or certainly not so.
bool is_regular(ElementVerdict verdict);
bool is_invalid(ElementVerdict verdict);

/// Limits, in units that do not depend on the machine.
struct Budget {
  /// Pieces of the subdivision of N.
  std::size_t pieces = 4096;
  /// Halvings of the domain for one piece.
  int depth = 96;
  /// The largest resultant that algebra is asked about, in bits: degree times bits of a coefficient. 0: no
  /// algebra.
  std::size_t algebra_bits = default_algebra_bits;
  ContactBudget contact;
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
  /// What proved it: "coefficients", "subdivision" or "algebra" for the sign; for injective also how
  /// (injectivity.hpp), or "boundary" (boundary.hpp).
  std::string_view sign_proof;
  std::string_view injectivity_proof;
  /// undecided: the budget that ran out. regular: what is missing for injective.
  std::string open;
  /// Pieces of the subdivision of N that were looked at.
  std::size_t pieces = 0;
};

Decision decide(const Forms& forms, const Budget& budget = {});

}  // namespace bezcert
