#include "bezcert/check/mesh_decider.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// Elements looked at together: enough to fill blocks where kinds alternate, few enough to stay in cache.
constexpr std::size_t window = 256;

enum class Weights { none, equal, different };

Weights weights_of(const Mesh& mesh, const MeshElement& entry) {
  if (mesh.weights().empty()) return Weights::none;
  const std::span<const double> weights = mesh.weights().doubles();
  const std::uint32_t* nodes = mesh.connectivity().data() + entry.first_node;
  const std::size_t count = coefficient_count(entry.shape);
  const double first = weights[nodes[0]];
  bool equal = true;
  for (std::size_t i = 0; i < count; ++i) {
    equal &= weights[nodes[i]] == first;
  }
  return equal ? Weights::equal : Weights::different;
}

// Elements of one table: their nodes, and their places in the window.
struct Group {
  Shape shape;
  Basis basis;
  bool rational;
  const batch::BlockTable* table;
  std::vector<std::size_t> first_node, place;
};

}  // namespace

void MeshDecider::settle(std::size_t first, std::size_t last, std::span<batch::Settled> results) const {
  const bool doubles =
      mesh_.coordinates(0).binary64() && mesh_.coordinates(1).binary64() && mesh_.weights().binary64();
  if (filter_ == Filter::off || !doubles) {
    std::fill(results.begin(), results.end(), batch::Settled{});
    return;
  }
  std::vector<Group> groups;
  for (std::size_t i = first; i < last; ++i) {
    const MeshElement& entry = mesh_.elements()[i];
    const Weights weights = weights_of(mesh_, entry);
    const bool rational = weights == Weights::different;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& one) {
      return one.shape == entry.shape && one.basis == entry.basis && one.rational == rational;
    });
    if (group == groups.end()) {
      const auto* table = batch::find_block_table(entry.shape, entry.basis, rational);
      groups.push_back({entry.shape, entry.basis, rational, table, {}, {}});
      group = groups.end() - 1;
    }
    group->first_node.push_back(entry.first_node);
    group->place.push_back(i - first);
  }
  std::fill(results.begin(), results.end(), batch::Settled{});
  const batch::Nodes nodes{mesh_.coordinates(0).doubles().data(), mesh_.coordinates(1).doubles().data(),
                           mesh_.weights().empty() ? nullptr : mesh_.weights().doubles().data(),
                           mesh_.connectivity().data()};
  std::vector<batch::Settled> found;
  for (const Group& group : groups) {
    if (group.table == nullptr) continue;
    if (group.place.size() == last - first) {
      batch::settle(*group.table, nodes, group.first_node, results);
      continue;
    }
    found.resize(group.place.size());
    batch::settle(*group.table, nodes, group.first_node, found);
    for (std::size_t k = 0; k < found.size(); ++k) results[group.place[k]] = found[k];
  }
}

DecisionCounts MeshDecider::decide_range(std::size_t first, std::size_t last, const Visit& visit) const {
  DecisionCounts counts;
  std::vector<batch::Settled> results(std::min(window, last - first));
  Decision settled;
  settled.verdict = ElementVerdict::injective;
  settled.pieces = 1;
  for (std::size_t begin = first; begin < last; begin += window) {
    const std::size_t end = std::min(begin + window, last);
    settle(begin, end, {results.data(), end - begin});
    for (std::size_t i = begin; i < end; ++i) {
      const batch::Settled& result = results[i - begin];
      if (result.settled) {
        settled.bounds = result.bounds;
        settled.injectivity_proof = result.injectivity_proof;
        visit(i, settled);
        ++counts.batch;
        continue;
      }
      const Element element = mesh_.element(i);
      const Forms forms(element, filter_);
      visit(i, decide(forms, budget_));
      ++(forms.went_exact() ? counts.exact : counts.interval);
    }
  }
  return counts;
}

}  // namespace bezcert
