#include "bezcert/report/jsonl_report.hpp"

#include "bezcert/report/decision_text.hpp"
#include "bezcert/report/mesh_json.hpp"
#include "bezcert/version.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <ostream>

namespace bezcert {
namespace {

using namespace std::string_view_literals;  // lengths known to the compiler

Json texts_of(const std::vector<Rational>& numbers) {
  Json texts = Json::array();
  for (const Rational& number : numbers) texts.push_back(to_string(number));
  return texts;
}

Json witness_object(const Witness& witness) {
  Json decimals = Json::array();
  for (const Rational& number : witness.place) decimals.push_back(to_decimal(number));
  return {{"parameter", texts_of(witness.parameter.values())},
          {"det", to_string(witness.determinant)},
          {"place", texts_of(witness.place)},
          {"place_decimal", decimals}};
}

// Part of the boundary: an edge (from corner i to the next) and the parameter range on it.
Json range_object(const BoundaryRange& range) {
  return {{"edge", range.edge}, {"lower", to_string(range.lower)}, {"upper", to_string(range.upper)}};
}

// A coordinate of a zero of det J: its exact value, or an isolating interval and, where it is known, the
// integer polynomial (coefficients from the constant term on) whose only root in it the coordinate is.
Json coordinate_object(const RealRoot& x) {
  if (x.is_rational()) return to_string(x.lower);
  Json object = {{"lower", to_string(x.lower)}, {"upper", to_string(x.upper)}};
  if (!x.polynomial.is_zero()) {
    Json coefficients = Json::array();
    for (const Integer& c : x.polynomial.coefficients) coefficients.push_back(c.str());
    object["polynomial"] = coefficients;
  }
  return object;
}

Json zero_object(const AlgebraicZero& zero) {
  Json object = {{"u", coordinate_object(zero.at.u)}, {"v", coordinate_object(zero.at.v)}};
  object["dimension"] = zero.dimension >= 0 ? Json(zero.dimension) : Json(nullptr);
  return object;
}

// Paths and names may hold any bytes: what is no UTF-8 is replaced, not thrown at.
std::string text_of(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }
std::string line_of(const Json& object) { return text_of(object) + '\n'; }

// Appends to a text: what is short goes through a buffer, which takes a few instructions a word.
class Writer {
 public:
  explicit Writer(std::string& text) : text_(text) {}
  ~Writer() { flush(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Inlined, so that words of known length are a few moves.
  [[gnu::always_inline]] Writer& operator<<(std::string_view word) {
    if (word.size() > room()) flush();
    if (word.size() > buffer_.size()) {
      text_ += word;
    } else {
      std::memcpy(at_, word.data(), word.size());
      at_ += word.size();
    }
    return *this;
  }
  Writer& operator<<(std::uint64_t number) {
    if (longest > room()) flush();
    at_ = std::to_chars(at_, at_ + longest, number).ptr;
    return *this;
  }
  Writer& operator<<(const Dyadic& number) {
    if (longest > room()) flush();
    char* const end = write_short(number, at_);
    if (end == nullptr) return *this << std::string_view(to_string(to_rational(number)));
    at_ = end;
    return *this;
  }
  void field(std::string_view key, const Json& value) {
    *this << ",\""sv << key << "\":"sv << std::string_view(text_of(value));
  }

 private:
  static constexpr std::size_t longest = 40;  // of a number

  std::size_t room() const { return static_cast<std::size_t>(buffer_.data() + buffer_.size() - at_); }
  void flush() {
    text_.append(buffer_.data(), at_);
    at_ = buffer_.data();
  }

  std::string& text_;
  std::array<char, 512> buffer_;
  char* at_ = buffer_.data();
};

class JsonLinesReport : public Report {
 public:
  using Report::Report;

 private:
  void write_header(const Mesh& mesh) override {
    stream_ << line_of({{"schema", "bezcert.report/1"},
                        {"tool", "bezcert " + std::string(version)},
                        {"input", source_.input},
                        {"sha256", source_.sha256},
                        {"basis", mesh.origin().basis_name},
                        {"numbers", name(mesh.origin().numbers)}});
  }

  // Written directly: with a document for each element this took longer than the decision.
  void append_element(const Mesh& mesh, std::size_t index, const CheckedElement& checked,
                      std::string& text) const override {
    const MeshElement& entry = mesh.elements()[index];
    const Decision& decision = checked.decision;
    const bool triangle = entry.shape.domain == Domain::triangle;
    Writer to(text);
    const MeshOrigin& origin = mesh.origin();
    const std::uint32_t line = origin.line(index);
    to << "{\"element\":"sv << origin.number(index) << ",\"line\":"sv;
    line > 0 ? to << line : to << "null"sv;
    if (!origin.name(index).empty()) to.field("name", std::string(origin.name(index)));
    to << (triangle ? ",\"kind\":\"triangle\",\"degree\":"sv : ",\"kind\":\"quadrilateral\",\"degree\":["sv)
       << static_cast<std::uint64_t>(entry.shape.degree(0));
    if (!triangle) to << ","sv << static_cast<std::uint64_t>(entry.shape.degree(1)) << "]"sv;
    to << (mesh.rational(index) ? ",\"rational\":true"sv : ",\"rational\":false"sv) << ",\"verdict\":\""sv
       << name(decision.verdict) << "\",\"min_det\":{\"lower\":\""sv << decision.bounds.min_lower
       << "\",\"upper\":\""sv << decision.bounds.min_upper << "\"}"sv;
    if (decision.witness) {
      to.field("witness", witness_object(*decision.witness));
    } else {
      to << ",\"witness\":null"sv;
    }
    if (decision.zero) to.field("zero", zero_object(*decision.zero));
    if (decision.overlap) {
      to.field("overlap",
               Json::array({range_object(decision.overlap->first), range_object(decision.overlap->second)}));
    }
    if (!decision.exhausted.empty()) to.field("open", open_text(decision));
    to << ",\"criteria\":{"sv;
    for (std::size_t i = 0; i < checked.criteria.size(); ++i) {
      to << (i > 0 ? ",\""sv : "\""sv) << checked.criteria[i].criterion->name << "\":\""sv
         << name(checked.criteria[i].verdict.status) << "\""sv;
    }
    to << "},\"agreement\":\""sv << name(checked.agreement) << "\"}\n"sv;
  }

  void write_summary(const Mesh& mesh, const MeshReport& report) override {
    const ElementCounts& counts = report.elements.counts;
    Json object;
    object["elements"] = counts.elements;
    for (const ElementVerdict verdict : element_verdicts) {
      object["verdicts"][std::string(name(verdict))] = counts.count(verdict);
    }
    object["contradictions"] = counts.findings + counts.defects;
    object["findings"] = counts.findings;
    object["sound_contradictions"] = counts.defects;
    Json criteria = Json::object();
    for (std::size_t i = 0; i < counts.by_criterion.size(); ++i) {
      const Criterion& criterion = *report.elements.criteria[i];
      criteria[std::string(criterion.name)] = criterion_object(criterion, counts.by_criterion[i]);
    }
    object["criteria"] = criteria;
    object["mesh"] = mesh_object(mesh, report.mesh);
    if (report.domain) object["domain"] = domain_object(source_.curves, mesh, *report.domain);
    object["ignored"] = {{"points", mesh.origin().ignored.points},
                         {"lines", mesh.origin().ignored.lines},
                         {"volumes", mesh.origin().ignored.volumes}};
    object["seconds"] = seconds();
    stream_ << line_of({{"summary", object}});
  }

  static Json criterion_object(const Criterion& criterion, const CriterionCounts& counts) {
    Json object;
    for (const Status status : statuses) object[std::string(name(status))] = counts.count(status);
    object["strength_gaps"] = counts.strength_gaps;
    object["contradictions"] = counts.contradictions;
    object["standing"] = name(criterion.standing);
    return object;
  }
};

}  // namespace

std::unique_ptr<Report> make_jsonl_report(std::ostream& stream, ReportSource source) {
  return std::make_unique<JsonLinesReport>(stream, std::move(source));
}

}  // namespace bezcert
