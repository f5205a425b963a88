// The claims of one element: signs of N, zeros, injectivity (docs/certificate-format.md, "Claims of
// elements").
#pragma once

#include "elements.hpp"

namespace verifier {

enum class Claim { injective, regular, overlapping, degenerate, folded, reversed, invalid, undecided };

/// Checks the claim that `tokens` (after the position) make of the element. Throws Rejected, Malformed.
Claim check_element(const Element& element, Tokens& tokens);

}  // namespace verifier
