// The claim of the mesh: embedding, or a refutation (docs/certificate-format.md, "The claim of the mesh").
#pragma once

#include "element_rules.hpp"
#include "pair_rules.hpp"

#include <functional>

namespace verifier {

/// Checks the mesh's claim: `line` begins after the word `mesh`; `next_line` gives the lines after it, the
/// last one is "end". Returns the words of the claim ("embedding", "refuted cover", ...). `claims` has one
/// entry an element. Throws Rejected, Malformed.
std::string check_mesh(const Elements& elements, const std::vector<Claim>& claims, Tokens& line,
                       const std::function<std::string_view()>& next_line);

}  // namespace verifier
