// Common points of two rational Bezier curves by elimination.
//
// With homogeneous curves (X1, Y1, W1)(s) and (X2, Y2, W2)(t), W1, W2 > 0, the images meet at (s, t) exactly
// where F = X1 W2 - X2 W1 and G = Y1 W2 - Y2 W1 vanish. A common factor of F and G is a curve of solutions in
// the (s, t) square; after division by it F and G have finitely many common zeros, over roots of their
// resultant. For a curve with itself, F and G are divided by s - t first: what then vanishes at s = t are
// cusps.
#pragma once

#include "bezcert/algebra/zero_set.hpp"
#include "bezcert/curve/contact.hpp"

namespace bezcert {

struct AlgebraicContact {
  std::optional<ExceededBits> exceeded;  ///< set if the budget is too small; then nothing else is
  std::optional<Contact> contact;        ///< a common point other than the joints
};

/// F and G, polynomials in u = s and v = t. `itself`: a and b are one curve, both are divided by s - t.
struct ContactEquations {
  Bivariate f, g;
};
ContactEquations contact_equations(const CurveNet<Integer>& a, const CurveNet<Integer>& b, bool itself);

/// Looks at s and t in the strips only. `itself`: a and b are one curve, its diagonal s = t is left out.
/// Preconditions: as find_contact and self_contact.
AlgebraicContact contact_by_algebra(const CurveNet<Integer>& a, const CurveNet<Integer>& b, bool itself,
                                    Joints joints, const Strips& strips_s, const Strips& strips_t,
                                    std::size_t budget_bits);

}  // namespace bezcert
