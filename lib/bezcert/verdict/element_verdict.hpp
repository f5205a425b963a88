// What the exact decision says of one element, and by what it was proved.
#pragma once

#include <array>
#include <string_view>

namespace bezcert {

/// Let S be the signs that det J takes on the closed element. `degenerate`: S = {0} or {0, +}; `reversed`:
/// {-}; `folded`: any other S with -. S = {+} is regular, and then `injective` or `overlapping`; it stays
/// `regular` if a budget ran out before that was known, `undecided` if S is not known.
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

/// What told the signs of det J: the Bernstein coefficients of N on the whole element, those on pieces of it,
/// or algebra (docs/decision.md).
enum class SignProof { coefficients, subdivision, algebra };

std::string_view name(SignProof proof);

/// What showed that a regular element is injective: one of the sufficient conditions of
/// decide/injectivity.hpp, or that its boundary is simple (decide/boundary.hpp).
enum class InjectivityProof { none, midpoint, jacobian_hull, orientation, boundary };

std::string_view name(InjectivityProof proof);

}  // namespace bezcert
