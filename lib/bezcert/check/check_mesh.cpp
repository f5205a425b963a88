#include "bezcert/check/check_mesh.hpp"

#include "bezcert/parallel/in_order.hpp"
#include "bezcert/surface/embedding.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace bezcert {
namespace {

// Elements that one thread decides at a time.
constexpr std::size_t block_size = 256;

// Fewer elements are not worth waking a thread for.
constexpr std::size_t worth_threads = 4096;

// What is known of a block, beside what the observer makes of it.
struct CheckedBlock {
  ElementCounts counts;
  std::vector<BadElement> bad;
  std::unique_ptr<CheckObserver::Block> observed;
};

class ElementsCheck {
 public:
  ElementsCheck(const Mesh& mesh, std::size_t first, std::size_t last, const CheckOptions& options,
                CheckObserver& observer)
      : mesh_(mesh), options_(options), observer_(observer) {
    report_.first = first;
    report_.last = last;
    report_.criteria = options.criteria;
    report_.counts.clear(options.criteria.size());
    report_.states.resize(last - first, ElementState::open);
    for (const Criterion* criterion : options.criteria) {
      if (criterion == nullptr) throw std::invalid_argument("CheckOptions: a criterion is null");
    }
  }

  // Calls `beside` once, before or beside the elements.
  ElementsReport run(const std::function<void()>& beside) {
    const std::size_t count = report_.last - report_.first;
    Executor* const executor = count < worth_threads ? nullptr : options_.executor;
    InOrder<CheckedBlock> blocks(count, block_size, [&] {
      return CheckedBlock{{}, {}, observer_.new_block()};
    });
    blocks.run(
        executor, beside,
        [&](std::size_t begin, std::size_t end, CheckedBlock& block) { prepare(begin, end, block); },
        [&](CheckedBlock& block) { take(block); });
    if (report_.counts.elements != count) {
      throw std::logic_error("the executor did not run all works, or hid that one of them threw");
    }
    return std::move(report_);
  }

 private:
  void prepare(std::size_t begin, std::size_t end, CheckedBlock& block) {
    block.counts.clear(options_.criteria.size());
    block.bad.clear();
    cross_check_elements(mesh_, report_.first + begin, report_.first + end, options_.criteria,
                         options_.budget, options_.filter, [&](std::size_t i, const CheckedElement& checked) {
                           block.counts.add(checked);
                           report_.states[i - report_.first] = state_of(checked.decision);
                           if (checked.decision.verdict != ElementVerdict::injective &&
                               block.bad.size() < ElementsReport::kept) {
                             block.bad.push_back({i, checked.decision});
                           }
                           if (block.observed) block.observed->element(i, checked);
                         });
  }

  void take(CheckedBlock& block) {
    report_.counts.add(block.counts);
    for (BadElement& bad : block.bad) {
      if (report_.bad.size() < ElementsReport::kept) report_.bad.push_back(std::move(bad));
    }
    if (block.observed) block.observed->finish();
  }

  const Mesh& mesh_;
  const CheckOptions& options_;
  CheckObserver& observer_;
  ElementsReport report_;
};

MeshReport conclude(const MeshTopology& topology, ElementsReport elements, const CheckOptions& options) {
  MeshReport report;
  report.elements = std::move(elements);
  report.mesh = examine_mesh(topology, report.elements.states, options.budget.contact);
  if (!options.curves.empty()) report.domain = check_domain(topology.surface(), options.curves);
  return report;
}

}  // namespace

void ElementsReport::append(ElementsReport next) {
  const bool whole = next.first <= next.last && next.states.size() == next.last - next.first &&
                     next.counts.by_criterion.size() == next.criteria.size() &&
                     counts.by_criterion.size() == criteria.size();
  if (next.first != last || next.criteria != criteria || !whole) {
    throw std::invalid_argument(
        "ElementsReport::append: expected the elements that follow, with the same criteria");
  }
  last = next.last;
  counts.add(next.counts);
  states.insert(states.end(), next.states.begin(), next.states.end());
  std::move(next.bad.begin(), next.bad.end(), std::back_inserter(bad));
  if (bad.size() > kept) bad.resize(kept);
}

Outcome MeshReport::outcome() const {
  if (elements.counts.defects > 0) return Outcome::contradiction;
  const bool conforming = !domain || domain->conforming();
  switch (mesh.verdict) {
    case MeshVerdict::embedding: return conforming ? Outcome::certified : Outcome::invalid;
    case MeshVerdict::undecided: return conforming ? Outcome::undecided : Outcome::invalid;
    default: return Outcome::invalid;
  }
}

MeshReport check_mesh(const Mesh& mesh, const CheckOptions& options, CheckObserver& observer) {
  for (const InputCurve& curve : options.curves) curve.validate();
  observer.begin(mesh);
  std::optional<MeshTopology> topology;
  ElementsReport elements =
      ElementsCheck(mesh, 0, mesh.elements().size(), options, observer).run([&] { topology.emplace(mesh); });
  if (!topology) throw std::logic_error("the executor did not run all works");
  MeshReport report = conclude(*topology, std::move(elements), options);
  observer.end(mesh, report);
  return report;
}

MeshReport check_mesh(const Mesh& mesh, const CheckOptions& options) {
  CheckObserver nobody;
  return check_mesh(mesh, options, nobody);
}

ElementsReport check_elements(const Mesh& mesh, std::size_t first, std::size_t last,
                              const CheckOptions& options, CheckObserver& observer) {
  if (first > last || last > mesh.elements().size()) {
    throw std::invalid_argument("check_elements: expected a range of the mesh's elements");
  }
  observer.begin(mesh);
  return ElementsCheck(mesh, first, last, options, observer).run([] {});
}

MeshReport conclude(const Mesh& mesh, ElementsReport elements, const CheckOptions& options) {
  const std::size_t count = mesh.elements().size();
  if (elements.first != 0 || elements.last != count || elements.states.size() != count ||
      elements.counts.elements != count) {
    throw std::invalid_argument("conclude: expected the report of all elements");
  }
  return conclude(MeshTopology(mesh), std::move(elements), options);
}

}  // namespace bezcert
