// Adaptive subdivision with proven bounds: the Bernstein coefficient condition on every piece of a
// subdivision of the domain (the idea of Johnen, Remacle, Geuzaine 2013, here in exact arithmetic and for
// rational elements). If it holds on every piece, det J > 0; a corner of a piece with N <= 0 refutes. The
// coefficients over the pieces bound min det J and max det J from both sides. Proof: docs/criteria.md.
#pragma once

#include "bezcert/criterion/criterion.hpp"

namespace bezcert {

struct SubdivisionOptions {
  /// Stop when the sign is settled and the bounds of min det J, and those of max det J, are no further
  /// apart than this times the largest |det J| found. Must be positive.
  Rational relative_width = Rational(1, 4);
  /// Give up (inconclusive) after this many pieces.
  std::size_t pieces = 1000;
};

/// Applies to every element; sets `bounds`. Throws std::invalid_argument if the width is not positive.
Verdict subdivision(const Forms& forms, const SubdivisionOptions& options = {});

/// Only the first piece, the whole element: children of a piece that proves det J > 0 prove it as well (their
/// coefficients are means of its own, and N > 0 at their corners), so cutting changes bounds only.
std::optional<Status> quick_subdivision(const QuickNet& net);

inline constexpr Criterion subdivision_info{
    "subdivision",
    "adaptive Bernstein subdivision",
    "the coefficient condition on every piece of a subdivision => det J > 0, with bounds of det J",
    Claim::regular,
    Standing::sound,
    false,
    [](const Forms& forms) { return subdivision(forms); },
    quick_subdivision};

}  // namespace bezcert
