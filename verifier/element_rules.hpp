// The claims of one element: signs of N, zeros, injectivity (docs/certificate-format.md, "Claims of
// elements").
#pragma once

#include "elements.hpp"
#include "polynomial.hpp"

namespace verifier {

enum class Claim { injective, regular, overlapping, degenerate, folded, reversed, invalid, undecided };

/// X, Y, W in the power basis in (u, v), times one positive number; W is {{1}} times a number if not
/// rational. Throws Malformed if a control weight is not positive.
struct Map {
  Polynomial2 x, y, w;
};
Map map_of(const Element& element);

/// Checks the claim that `tokens` (after the position) make of the element. Throws Rejected, Malformed.
Claim check_element(const Element& element, Tokens& tokens);

}  // namespace verifier
