// Whether two rational Bezier curves are one curve with one parametrisation, as edges that are glued must be.
//
// Same means: equal as maps of [0, 1] to the plane up to a projective change of the parameter,
// t -> a t / (a t + b (1 - t)) with a, b > 0. Degree elevation, common factors of X, Y, W and the scale of
// the weights do not matter; every other change of the parameter does. Theorem and proof: docs/mesh.md, "Same
// curves".
#pragma once

#include "bezcert/curve/curve_net.hpp"

namespace bezcert {

/// Whether a and b are the same. Precondition: all weights are positive.
bool same_curve(const CurveNet<Integer>& a, const CurveNet<Integer>& b);

}  // namespace bezcert
