#include "bezcert/report/text_report.hpp"

#include "bezcert/io/printable.hpp"
#include "bezcert/report/decision_text.hpp"
#include "bezcert/report/mesh_text.hpp"

#include <ostream>

namespace bezcert {
namespace {

class TextReport : public Report {
 public:
  using Report::Report;

 private:
  void write_header(const Mesh&) override {}

  void append_element(const Mesh& mesh, std::size_t i, const CheckedElement& checked,
                      std::string& text) const override {
    const bool good = checked.decision.verdict == ElementVerdict::injective;
    if (good && checked.agreement != Agreement::contradiction) return;
    const std::string title = element_title(source_.input, mesh, i);
    const auto add = [&](auto... parts) { (text.append(parts), ...); };
    if (!good) add(title, ": ", describe(checked.decision), "\n");
    for (const CheckedCriterion& one : checked.criteria) {
      if (one.agreement != Agreement::contradiction) continue;
      add(title,
          one.is_finding() ? ": finding: " : ": CONTRADICTION (a defect of bezcert): ", one.criterion->name,
          " (", one.criterion->theorem, ", ", name(one.criterion->standing), ") says ",
          name(one.verdict.status), " ", name(one.criterion->claim), ", but the element is ",
          name(checked.decision.verdict), "\n");
    }
  }

  void write_summary(const Mesh& mesh, const MeshReport& report) override {
    const ElementCounts& counts = report.elements.counts;
    line() << counts.elements << (counts.elements == 1 ? " element: " : " elements: ");
    const char* comma = "";
    for (const ElementVerdict verdict : element_verdicts) {
      if (counts.count(verdict) == 0) continue;
      stream_ << comma << counts.count(verdict) << " " << name(verdict);
      comma = ", ";
    }
    const IgnoredCells& ignored = mesh.origin().ignored;
    if (ignored.points + ignored.lines + ignored.volumes > 0) {
      stream_ << " (ignored: " << ignored.points << " points, " << ignored.lines << " lines, "
              << ignored.volumes << " volume cells)";
    }
    stream_ << '\n';
    for (std::size_t i = 0; i < counts.by_criterion.size(); ++i)
      write_criterion(*report.elements.criteria[i], counts.by_criterion[i]);
    for (const std::string& text : mesh_lines(mesh, report.mesh)) line() << text << '\n';
    if (!report.domain) return;
    for (const std::string& text : domain_lines(mesh, source_.curves, *report.domain)) line() << text << '\n';
  }

  void write_criterion(const Criterion& criterion, const CriterionCounts& counts) {
    line() << criterion.name << " (" << name(criterion.standing) << "): ";
    const char* comma = "";
    for (const Status status : statuses) {
      if (counts.count(status) == 0) continue;
      stream_ << comma << counts.count(status) << " " << name(status);
      comma = ", ";
    }
    if (counts.strength_gaps > 0) stream_ << "; strength gaps: " << counts.strength_gaps;
    if (counts.contradictions > 0) {
      stream_ << (criterion.standing == Standing::claimed ? "; findings: " : "; CONTRADICTIONS: ")
              << counts.contradictions;
    }
    stream_ << '\n';
  }

  // The beginning of a line: what it is about.
  std::ostream& line() { return stream_ << source_.input << ": "; }
};

}  // namespace

std::unique_ptr<Report> make_text_report(std::ostream& stream, ReportSource source) {
  return std::make_unique<TextReport>(stream, std::move(source));
}

std::string element_title(const std::string& input, const Mesh& mesh, std::size_t i) {
  const MeshElement& entry = mesh.elements()[i];
  const MeshOrigin& origin = mesh.origin();
  std::string text = input;
  if (origin.line(i) > 0) text += ":" + std::to_string(origin.line(i));
  text += ": element " + std::to_string(origin.number(i));
  if (!origin.name(i).empty()) text += " \"" + printable(origin.name(i), 80) + "\"";
  const bool triangle = entry.shape.domain == Domain::triangle;
  text += triangle ? " (triangle, degree " : " (quadrilateral, degree ";
  text += std::to_string(entry.shape.degree(0));
  if (!triangle && entry.shape.degree(0) != entry.shape.degree(1))
    text += "x" + std::to_string(entry.shape.degree(1));
  return text + ")";
}

}  // namespace bezcert
