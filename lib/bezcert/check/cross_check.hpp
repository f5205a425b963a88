// The cross-check of one element: every published condition against the exact decision.
#pragma once

#include "bezcert/criterion/criterion.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/mesh/mesh.hpp"
#include "bezcert/number/filter.hpp"
#include "bezcert/verdict/mesh_verdict.hpp"

#include <functional>
#include <span>
#include <vector>

namespace bezcert {

struct CheckedCriterion {
  const Criterion* criterion = nullptr;
  Verdict verdict;
  Agreement agreement = Agreement::consistent;

  /// A contradiction of a published claim: a result about the claim.
  bool is_finding() const {
    return agreement == Agreement::contradiction && criterion->standing == Standing::claimed;
  }
  /// A contradiction of a proven theorem: a defect of this program.
  bool is_defect() const {
    return agreement == Agreement::contradiction && criterion->standing == Standing::sound;
  }
};

struct CheckedElement {
  Decision decision;
  std::vector<CheckedCriterion> criteria;
  /// The strongest disagreement.
  Agreement agreement = Agreement::consistent;
};

/// Decides an element and runs the chosen criteria on it.
CheckedElement check_element(const Element& element, std::span<const Criterion* const> chosen,
                             const Budget& budget);

/// Called with the place of an element and what was found of it, which lives for the call.
using VisitChecked = std::function<void(std::size_t, const CheckedElement&)>;

/// The same for elements begin ... end - 1 of a mesh, in this order, but verdicts of criteria need have no
/// more than their status. Where that is quick, nothing is allocated for an element.
void cross_check_elements(const Mesh& mesh, std::size_t begin, std::size_t end,
                          std::span<const Criterion* const> chosen, const Budget& budget, Filter filter,
                          const VisitChecked& visit);

/// What the decision of the mesh takes from that of an element.
ElementState state_of(const Decision& decision);

}  // namespace bezcert
