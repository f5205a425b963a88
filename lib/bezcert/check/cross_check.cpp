#include "bezcert/check/cross_check.hpp"

#include "bezcert/check/mesh_decider.hpp"
#include "bezcert/criterion/quick_net.hpp"

#include <algorithm>

namespace bezcert {
ElementState state_of(const Decision& decision) {
  if (certainly_invalid(decision)) return ElementState::invalid;
  return decision.verdict == ElementVerdict::injective ? ElementState::injective : ElementState::open;
}

namespace {

void judge(CheckedElement& element, CheckedCriterion& checked, const Criterion* criterion, Verdict verdict) {
  checked.criterion = criterion;
  checked.verdict = std::move(verdict);
  checked.agreement = compare(checked.verdict, element.decision);
  element.agreement = std::max(element.agreement, checked.agreement);
}

// An element with its number forms, copied out of the mesh when it is needed.
class FullForms {
 public:
  FullForms(const Mesh& mesh, std::size_t i, Filter filter) : mesh_(mesh), i_(i), filter_(filter) {}

  const Forms& get() {
    if (!element_) {
      element_ = mesh_.element(i_);
      forms_.emplace(*element_, filter_);
    }
    return *forms_;
  }

 private:
  const Mesh& mesh_;
  std::size_t i_;
  Filter filter_;
  std::optional<Element> element_;
  std::optional<Forms> forms_;
};

// The net that answers by status alone, where the element has one.
bool load(const Mesh& mesh, std::size_t i, QuickNet& net) {
  if (!mesh.coordinates(0).binary64() || !mesh.coordinates(1).binary64() || mesh.rational(i)) return false;
  const MeshElement& entry = mesh.elements()[i];
  return net.load(entry.shape, entry.basis, mesh.coordinates(0).doubles(), mesh.coordinates(1).doubles(),
                  {mesh.connectivity().data() + entry.first_node, coefficient_count(entry.shape)});
}

}  // namespace

CheckedElement check_element(const Element& element, std::span<const Criterion* const> chosen,
                             const Budget& budget) {
  const Forms forms(element);
  CheckedElement result;
  result.decision = decide(forms, budget);
  for (const Criterion* criterion : chosen) {
    judge(result, result.criteria.emplace_back(), criterion, criterion->check(forms));
  }
  return result;
}

void cross_check_elements(const Mesh& mesh, std::size_t begin, std::size_t end,
                          std::span<const Criterion* const> chosen, const Budget& budget, Filter filter,
                          const VisitChecked& visit) {
  CheckedElement checked;
  checked.criteria.resize(chosen.size());
  QuickNet net;
  MeshDecider(mesh, budget, filter).decide_range(begin, end, [&](std::size_t i, const Decision& decision) {
    checked.decision = decision;
    checked.agreement = Agreement::consistent;
    const bool is_quick = !chosen.empty() && filter == Filter::on && load(mesh, i, net);
    FullForms forms(mesh, i, filter);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const Criterion& criterion = *chosen[k];
      const std::optional<Status> status = is_quick && criterion.quick ? criterion.quick(net) : std::nullopt;
      judge(checked, checked.criteria[k], &criterion,
            status ? begin_verdict(criterion, *status) : criterion.check(forms.get()));
    }
    visit(i, checked);
  });
}

}  // namespace bezcert
