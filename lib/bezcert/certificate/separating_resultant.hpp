// The rule `r` of certificates: a resultant of one sign shows that two curves do not meet but at a joint.
#pragma once

#include "bezcert/curve/contact.hpp"

namespace bezcert {

/// Whether rule `r` holds for a and b: R(s) = Res_t(F, G) in the formal degree of b's control points, divided
/// by s as often as it can be if there is a joint, has Bernstein coefficients of strictly one sign on [0, 1].
/// Precondition: at most one joint.
bool resultant_separates(const CurveNet<Integer>& a, const CurveNet<Integer>& b, Joints joints);

}  // namespace bezcert
