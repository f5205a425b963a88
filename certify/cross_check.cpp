#include "cross_check.hpp"

#include <algorithm>

namespace bezcert::certify {
namespace {

bool decision_proves(Claim claim, const Decision& decision) {
  return claim == Claim::regular ? is_regular(decision.verdict)
                                 : decision.verdict == ElementVerdict::injective;
}

bool decision_refutes(Claim claim, const Decision& decision) {
  if (decision.verdict == ElementVerdict::overlapping) return claim == Claim::injective;
  return certainly_invalid(decision);
}

}  // namespace

std::string_view name(Agreement agreement) {
  switch (agreement) {
    case Agreement::consistent: return "consistent";
    case Agreement::strength_gap: return "strength_gap";
    case Agreement::contradiction: return "contradiction";
  }
  return "";
}

bool certainly_invalid(const Decision& decision) {
  return is_invalid(decision.verdict) ||
         (decision.verdict == ElementVerdict::undecided && decision.witness.has_value());
}

ElementState state_of(const Decision& decision) {
  if (certainly_invalid(decision)) return ElementState::invalid;
  return decision.verdict == ElementVerdict::injective ? ElementState::injective : ElementState::open;
}

Agreement compare(const Verdict& verdict, const Decision& decision) {
  switch (verdict.status) {
    case Status::proved:
      return decision_refutes(verdict.claim, decision) ? Agreement::contradiction : Agreement::consistent;
    case Status::refuted:
      return decision_proves(verdict.claim, decision) ? Agreement::contradiction : Agreement::consistent;
    case Status::inconclusive:
      return decision_proves(verdict.claim, decision) ? Agreement::strength_gap : Agreement::consistent;
    case Status::not_applicable: return Agreement::consistent;
  }
  return Agreement::consistent;
}

CheckedElement check_element(const Element& element, std::span<const Criterion* const> chosen,
                             const Budget& budget) {
  const Forms forms(element);
  return check_decided(decide(forms, budget), forms, chosen);
}

CheckedElement check_decided(Decision decision, const Forms& forms,
                             std::span<const Criterion* const> chosen) {
  CheckedElement result;
  result.decision = std::move(decision);
  for (const Criterion* criterion : chosen) {
    CheckedCriterion checked{criterion, criterion->check(forms), Agreement::consistent};
    checked.agreement = compare(checked.verdict, result.decision);
    result.agreement = std::max(result.agreement, checked.agreement);
    result.criteria.push_back(std::move(checked));
  }
  return result;
}

}  // namespace bezcert::certify
