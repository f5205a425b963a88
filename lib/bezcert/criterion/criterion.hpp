// The published conditions under test: what each claims, where it stands, how it is checked.
//
// A condition is written once, as a template over the numbers that answer its signs (form_signs.hpp); what
// fails is data, from which `check` makes the reason.
//
// Adding a criterion means one file pair, whose header ends with the criterion's `Criterion`, and one line in
// registry.cpp.
#pragma once

#include "bezcert/verdict/criterion_verdict.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace bezcert {

class Forms;
class QuickNet;

using Check = Verdict (*)(const Forms&);
/// The status alone, or nothing if this net does not tell it.
using QuickCheck = std::optional<Status> (*)(const QuickNet&);

struct Criterion {
  std::string_view name;
  /// Paper and theorem.
  std::string_view theorem;
  /// The condition and what is said to follow, in one line.
  std::string_view statement;
  Claim claim;
  Standing standing;
  /// Whether a counterexample is known (then it is in the corpus).
  bool refuted;
  Check check;
  /// The status that `check` gives, by the same code over other numbers, without reason or witness: reports
  /// need no more, and it is much faster.
  QuickCheck quick = nullptr;
};

/// A verdict with the criterion's name and claim, without evidence.
inline Verdict begin_verdict(const Criterion& criterion, Status status, std::string reason = {}) {
  Verdict verdict;
  verdict.reason = std::move(reason);
  verdict.criterion = criterion.name;
  verdict.claim = criterion.claim;
  verdict.status = status;
  return verdict;
}

/// All criteria, in the order of reports.
std::span<const Criterion> criteria();

/// The same, as choices (CheckOptions::criteria).
std::vector<const Criterion*> all_criteria();

/// The criterion of that name, or nullptr.
const Criterion* find_criterion(std::string_view name);

}  // namespace bezcert
