// Whether two rational Bezier curves have a common point, decided exactly.
//
// Dyadic pieces first: pieces whose hulls are disjoint do not meet, neighbours that part at their joint meet
// only there, pieces that certainly cross do meet (separation.hpp). What is left is a finite system of two
// polynomials in two parameters, X1 W2 = X2 W1 and Y1 W2 = Y2 W1: a common factor is a curve of solutions
// (the curves run along each other), isolated solutions come from a resultant and fibres over its real roots
// (algebra/). Tangential contacts, contacts at irrational parameters and shared pieces are so decided.
#pragma once

#include "bezcert/curve/contact_budget.hpp"
#include "bezcert/curve/contact_result.hpp"
#include "bezcert/curve/dyadic_curve.hpp"

namespace bezcert {

/// End points that are known to be common: they are no contact.
struct Joints {
  bool end_to_begin = false;  ///< a ends where b begins
  bool begin_to_end = false;  ///< a begins where b ends
};

/// Whether a curve meets itself. Precondition: its derivative vanishes nowhere on [0, 1].
ContactResult self_contact(DyadicCurve& curve, const ContactBudget& budget = {});

/// Whether two curves meet in other points than their joints (common end points that are not named in
/// `joints` are contacts). Precondition: both are injective, their derivatives vanish nowhere on [0, 1].
ContactResult find_contact(DyadicCurve& a, DyadicCurve& b, Joints joints = {},
                           const ContactBudget& budget = {});

}  // namespace bezcert
