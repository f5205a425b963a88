#include "bezcert/verdict/criterion_verdict.hpp"

namespace bezcert {
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

std::string_view name(Claim claim) { return claim == Claim::regular ? "regular" : "injective"; }

std::string_view name(Status status) {
  switch (status) {
    case Status::proved: return "proved";
    case Status::refuted: return "refuted";
    case Status::inconclusive: return "inconclusive";
    case Status::not_applicable: return "not_applicable";
  }
  return "";
}

std::string_view name(Standing standing) { return standing == Standing::sound ? "sound" : "claimed"; }

std::string_view name(Agreement agreement) {
  switch (agreement) {
    case Agreement::consistent: return "consistent";
    case Agreement::strength_gap: return "strength_gap";
    case Agreement::contradiction: return "contradiction";
  }
  return "";
}

}  // namespace bezcert
