// What a published condition says of one element, and how that stands to the exact decision.
#pragma once

#include "bezcert/element/determinant_bounds.hpp"
#include "bezcert/verdict/decision.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace bezcert {

/// What a proof would prove: det J > 0 on the closed element, or that and that the map is injective.
enum class Claim { regular, injective };

/// The outcome of a criterion. A sufficient condition that fails is `inconclusive`; only a witness refutes.
enum class Status { proved, refuted, inconclusive, not_applicable };

/// All of them, in the order of reports.
inline constexpr std::array statuses = {Status::proved, Status::refuted, Status::inconclusive,
                                        Status::not_applicable};

/// Whether a theorem is proven in docs/criteria.md (`sound`) or only published (`claimed`).
enum class Standing { sound, claimed };

struct Verdict {
  std::string_view criterion;
  Claim claim = Claim::regular;
  Status status = Status::inconclusive;
  /// Which condition failed, or why the criterion does not apply; empty if proved, or if only the status was
  /// asked for.
  std::string reason;
  /// Set if refuted: det J <= 0 there.
  std::optional<Witness> witness;
  /// Set by criteria that bound det J.
  std::optional<DeterminantBounds> bounds;
};

/// consistent; strength_gap: the criterion is inconclusive about what the decision proves; contradiction:
/// one of them is wrong.
enum class Agreement { consistent, strength_gap, contradiction };

/// How the verdict of a criterion stands to the decision of the same element.
Agreement compare(const Verdict& verdict, const Decision& decision);

std::string_view name(Claim claim);
std::string_view name(Status status);
std::string_view name(Standing standing);
std::string_view name(Agreement agreement);

}  // namespace bezcert
