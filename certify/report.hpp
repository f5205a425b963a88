// What a check of one mesh adds up to, and the two ways it is written.
//
// Both writers get the mesh, then every element in mesh order, then the summary; neither keeps elements. What
// they say of an element is a function of it alone, so that threads can prepare it.
#pragma once

#include "bezcert/mesh/domain.hpp"
#include "bezcert/mesh/embedding.hpp"
#include "bezcert/report/decision_text.hpp"
#include "cross_check.hpp"

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bezcert::certify {

struct CriterionCounts {
  std::array<std::size_t, 4> by_status{};  ///< in the order of Status
  std::size_t strength_gaps = 0;
  std::size_t contradictions = 0;
};

/// Significant bits of the bounds of an area that is not known exactly.
inline constexpr int area_bits = 16;

/// Conformity to the curves of a file.
struct DomainSummary {
  std::string file;
  std::vector<std::string> names;  ///< of its curves; empty where it names none
  DomainResult result;
};

/// What is counted of elements.
struct ElementCounts {
  std::size_t elements = 0;
  std::array<std::size_t, element_verdicts.size()> by_verdict{};  ///< in the order of element_verdicts
  std::vector<CriterionCounts> by_criterion;                      ///< in the order of the chosen criteria
  std::size_t findings = 0;                                       ///< contradictions of claimed criteria
  std::size_t defects = 0;                                        ///< contradictions of sound criteria

  /// None, of so many criteria.
  void clear(std::size_t criteria);
  void add(const CheckedElement& checked);
  /// Precondition: the same criteria.
  void add(const ElementCounts& other);
  std::size_t count(ElementVerdict verdict) const { return by_verdict[static_cast<std::size_t>(verdict)]; }
};

struct Summary : ElementCounts {
  std::vector<const Criterion*> criteria;
  MeshResult mesh;                      ///< of the elements as a whole
  std::optional<DomainSummary> domain;  ///< if curves were given
  double seconds = 0;
};

class Report {
 public:
  explicit Report(std::ostream& stream) : stream_(stream) {}
  virtual ~Report() = default;
  virtual void begin(const std::string& input, const std::string& sha256, const Mesh& mesh) = 0;
  /// Appends what is said of an element to `text`; `write` is to get it, in mesh order. Between begin and
  /// end, from any thread.
  virtual void element(const Mesh& mesh, std::size_t index, const CheckedElement& checked,
                       std::string& text) const = 0;
  void write(const std::string& text);
  virtual void end(const Mesh& mesh, const Summary& summary) = 0;

 protected:
  std::ostream& stream_;
};

std::unique_ptr<Report> make_text_report(std::ostream& stream);
std::unique_ptr<Report> make_jsonl_report(std::ostream& stream);

/// "mesh.msh:12: element 5 (triangle, degree 2)", with the name if it has one.
std::string element_title(const std::string& input, const Mesh& mesh, std::size_t index);

std::string_view name(Numbers numbers);

}  // namespace bezcert::certify
