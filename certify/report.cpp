#include "report.hpp"

#include "bezcert/io/printable.hpp"

#include <ostream>

namespace bezcert::certify {
namespace {

constexpr std::size_t longest_exact_text = 40;

// Exact if that is short, else decimal: the exact value is in the JSON report and in `explain`.
std::string determinant_text(const Rational& value) {
  const std::string exact_text = to_string(value);
  return exact_text.size() <= longest_exact_text ? "= " + exact_text : "~ " + to_decimal(value);
}

std::string range_text(const BoundaryRange& range) {
  std::string text = "edge " + std::to_string(range.edge);
  if (range.lower == range.upper) return text + " at " + to_string(range.lower);
  return text + " in [" + to_string(range.lower) + ", " + to_string(range.upper) + "]";
}

std::string coordinate_text(const RealRoot& x) {
  if (x.is_rational()) return to_string(x.lower);
  return "in [" + to_decimal(x.lower, 13) + ", " + to_decimal(x.upper, 13) + "]";
}

// The zero set of det J of a degenerate element; a rational zero is shown as the witness already.
std::string describe(const AlgebraicZero& zero) {
  std::string text;
  if (!zero.at.is_rational()) {
    text = ", det J = 0 at u " + coordinate_text(zero.at.u) + ", v " + coordinate_text(zero.at.v);
  }
  switch (zero.dimension) {
    case 0: return text + ", finitely many zeros";
    case 1: return text + ", zeros along a curve";
    case 2: return text + ", zero everywhere";
    default: return text;
  }
}

}  // namespace

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
  const MeshElement& entry = mesh.elements[index];
  std::string text = input;
  if (entry.line > 0) text += ":" + std::to_string(entry.line);
  text += ": element " + std::to_string(entry.tag);
  if (index < mesh.names.size() && !mesh.names[index].empty())
    text += " \"" + printable(mesh.names[index], 80) + "\"";
  const bool triangle = entry.shape.domain == Domain::triangle;
  text += triangle ? " (triangle, degree " : " (quadrilateral, degree ";
  text += std::to_string(entry.shape.degree(0));
  if (!triangle && entry.shape.degree(0) != entry.shape.degree(1))
    text += "x" + std::to_string(entry.shape.degree(1));
  return text + ")";
}

std::string describe(const Decision& decision) {
  std::string text(name(decision.verdict));
  if (decision.verdict == ElementVerdict::reversed) text += " (clockwise: det J < 0 everywhere)";
  if (decision.witness) {
    text += ", det J " + determinant_text(decision.witness->determinant) + " at " +
            to_string(decision.witness->parameter);
  }
  if (decision.zero) text += describe(*decision.zero);
  if (decision.overlap) {
    text += std::string(", det J > 0 but the boundary ") +
            (decision.overlap->along_a_piece ? "runs along itself: " : "meets itself: ") +
            range_text(decision.overlap->first) + " and " + range_text(decision.overlap->second);
  }
  if (!decision.open.empty()) text += "; open: " + decision.open;
  return text;
}

std::string_view name(Numbers numbers) { return numbers == Numbers::binary64 ? "binary64" : "decimal"; }

}  // namespace bezcert::certify
