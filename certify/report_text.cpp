#include "mesh_text.hpp"
#include "report.hpp"

#include <ostream>

namespace bezcert::certify {
namespace {

class TextReport : public Report {
 public:
  using Report::Report;

  void begin(const std::string& input, const std::string&, const Mesh&) override { input_ = input; }

  void element(const Mesh& mesh, std::size_t index, const CheckedElement& checked,
               std::string& text) const override {
    const bool good = checked.decision.verdict == ElementVerdict::injective;
    if (good && checked.agreement != Agreement::contradiction) return;
    const std::string title = element_title(input_, mesh, index);
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

  void end(const Mesh& mesh, const Summary& summary) override {
    stream_ << input_ << ": " << summary.elements << (summary.elements == 1 ? " element: " : " elements: ");
    bool first = true;
    for (const ElementVerdict verdict : element_verdicts) {
      if (summary.count(verdict) == 0) continue;
      stream_ << (first ? "" : ", ") << summary.count(verdict) << " " << name(verdict);
      first = false;
    }
    const IgnoredCells& ignored = mesh.origin().ignored;
    if (ignored.points + ignored.lines + ignored.volumes > 0) {
      stream_ << " (ignored: " << ignored.points << " points, " << ignored.lines << " lines, "
              << ignored.volumes << " volume cells)";
    }
    stream_ << '\n';
    for (std::size_t i = 0; i < summary.criteria.size(); ++i)
      criterion(*summary.criteria[i], summary.by_criterion[i]);
    for (const std::string& line : mesh_lines(summary.mesh)) stream_ << input_ << ": " << line << '\n';
    if (!summary.domain) return;
    for (const std::string& line : domain_lines(*summary.domain)) stream_ << input_ << ": " << line << '\n';
  }

 private:
  void criterion(const Criterion& criterion, const CriterionCounts& counts) {
    stream_ << input_ << ": " << criterion.name << " (" << name(criterion.standing) << "): ";
    bool first = true;
    for (const Status status :
         {Status::proved, Status::refuted, Status::inconclusive, Status::not_applicable}) {
      const std::size_t count = counts.by_status[static_cast<std::size_t>(status)];
      if (count == 0) continue;
      stream_ << (first ? "" : ", ") << count << " " << name(status);
      first = false;
    }
    if (counts.strength_gaps > 0) stream_ << "; strength gaps: " << counts.strength_gaps;
    if (counts.contradictions > 0) {
      stream_ << (criterion.standing == Standing::claimed ? "; findings: " : "; CONTRADICTIONS: ")
              << counts.contradictions;
    }
    stream_ << '\n';
  }

  std::string input_;
};

}  // namespace

std::unique_ptr<Report> make_text_report(std::ostream& stream) {
  return std::make_unique<TextReport>(stream);
}

}  // namespace bezcert::certify
