#include "bezcert/check/counts.hpp"

namespace bezcert {

void ElementCounts::clear(std::size_t criteria) {
  elements = findings = defects = 0;
  by_verdict.fill(0);
  by_criterion.assign(criteria, {});
}

void ElementCounts::add(const CheckedElement& checked) {
  ++elements;
  ++by_verdict[static_cast<std::size_t>(checked.decision.verdict)];
  for (std::size_t i = 0; i < checked.criteria.size(); ++i) {
    const CheckedCriterion& one = checked.criteria[i];
    CriterionCounts& counts = by_criterion[i];
    ++counts.by_status[static_cast<std::size_t>(one.verdict.status)];
    if (one.agreement == Agreement::strength_gap) ++counts.strength_gaps;
    if (one.agreement == Agreement::contradiction) ++counts.contradictions;
    if (one.is_finding()) ++findings;
    if (one.is_defect()) ++defects;
  }
}

void ElementCounts::add(const ElementCounts& other) {
  elements += other.elements;
  findings += other.findings;
  defects += other.defects;
  for (std::size_t i = 0; i < by_verdict.size(); ++i) by_verdict[i] += other.by_verdict[i];
  for (std::size_t i = 0; i < by_criterion.size(); ++i) {
    CriterionCounts& counts = by_criterion[i];
    const CriterionCounts& more = other.by_criterion[i];
    for (std::size_t k = 0; k < counts.by_status.size(); ++k) counts.by_status[k] += more.by_status[k];
    counts.strength_gaps += more.strength_gaps;
    counts.contradictions += more.contradictions;
  }
}

}  // namespace bezcert
