// Evidence that curves meet neither themselves nor each other but at joints: the rules SELF, PAIR and
// INJECTIVE `boundary` of certificates (docs/certificate-format.md).
//
// Lines that separate control points, found where curve/separation.hpp knows that there are some, and halves
// where there is none yet; a resultant of one sign where curves leave a joint in one direction to one side,
// or run very near each other, so that lines would need too many halves.
#pragma once

#include "bezcert/curve/contact.hpp"
#include "bezcert/element/forms.hpp"

#include <optional>
#include <string>

namespace bezcert {

/// What one SELF or PAIR may take: half of what a checker must accept.
struct PairLimits {
  std::size_t pieces = std::size_t{1} << 13;
  int depth = 192;
};

/// SELF of a curve. Nothing if the limits do not suffice: always so if the curve meets itself.
std::optional<std::string> self_evidence(DyadicCurve& curve, const PairLimits& limits = {});

/// PAIR of two curves that meet at `joints` only. Nothing if the limits do not suffice: always so if they
/// meet elsewhere. Precondition: the curves are injective.
std::optional<std::string> pair_evidence(DyadicCurve& a, DyadicCurve& b, Joints joints,
                                         const PairLimits& limits = {});

/// INJECTIVE `boundary` of a regular element, beginning with that word. Nothing if the limits do not suffice.
std::optional<std::string> boundary_evidence(const Forms& forms);

}  // namespace bezcert
