// What is counted of checked elements. Counts of parts of a mesh add up to those of the whole.
#pragma once

#include "bezcert/check/cross_check.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace bezcert {

struct CriterionCounts {
  std::array<std::size_t, statuses.size()> by_status{};  ///< in the order of Status
  std::size_t strength_gaps = 0;
  std::size_t contradictions = 0;

  std::size_t count(Status status) const { return by_status[static_cast<std::size_t>(status)]; }
};

struct ElementCounts {
  std::size_t elements = 0;
  std::array<std::size_t, element_verdicts.size()> by_verdict{};  ///< in the order of element_verdicts
  std::vector<CriterionCounts> by_criterion;                      ///< in the order of the chosen criteria
  std::size_t findings = 0;                                       ///< contradictions of claimed criteria
  std::size_t defects = 0;                                        ///< contradictions of sound criteria

  std::size_t count(ElementVerdict verdict) const { return by_verdict[static_cast<std::size_t>(verdict)]; }

  /// None, of so many criteria.
  void clear(std::size_t criteria);
  void add(const CheckedElement& checked);
  /// Precondition: the same criteria.
  void add(const ElementCounts& other);
};

}  // namespace bezcert
