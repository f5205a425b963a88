#include "report.hpp"

#include "bezcert/io/printable.hpp"

#include <ostream>

namespace bezcert::certify {
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

void Report::write(const std::string& text) {
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string element_title(const std::string& input, const Mesh& mesh, std::size_t index) {
  const MeshElement& entry = mesh.elements()[index];
  std::string text = input;
  if (mesh.origin().line(index) > 0) text += ":" + std::to_string(mesh.origin().line(index));
  text += ": element " + std::to_string(mesh.origin().number(index));
  if (const std::string_view given = mesh.origin().name(index); !given.empty())
    text += " \"" + printable(given, 80) + "\"";
  const bool triangle = entry.shape.domain == Domain::triangle;
  text += triangle ? " (triangle, degree " : " (quadrilateral, degree ";
  text += std::to_string(entry.shape.p);
  if (!triangle && entry.shape.p != entry.shape.q) text += "x" + std::to_string(entry.shape.q);
  return text + ")";
}

std::string_view name(Numbers numbers) { return numbers == Numbers::binary64 ? "binary64" : "decimal"; }

}  // namespace bezcert::certify
