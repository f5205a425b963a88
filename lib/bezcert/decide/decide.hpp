// The exact decision of one element.
//
// Theorem used (docs/decision.md): let S be the set of signs that det J takes on the closed element. S = {+}
// is regular; {0} or {0,+} degenerate; {-} reversed; every other S folded. Subdivision of the Jacobian
// numerator finds S: on a piece whose coefficients have one sign, the signs of N are known; a corner of a
// piece gives the sign at a dyadic parameter. Where N touches zero, or nearly so, subdivision does not end:
// what it leaves open goes to algebra (algebraic.hpp). All signs are exact. What is open when a budget is
// spent is `undecided`, never a guess.
#pragma once

#include "bezcert/curve/contact_budget.hpp"
#include "bezcert/element/element.hpp"
#include "bezcert/verdict/decision.hpp"

namespace bezcert {

class Forms;

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

/// Decides an element. The second is for callers that go on with its number forms (element/forms.hpp).
Decision decide(const Element& element, const Budget& budget = {});
Decision decide(const Forms& forms, const Budget& budget = {});

}  // namespace bezcert
