// The decisions of a mesh's elements: by blocks of floating point (batch/) where they prove everything, each
// by itself otherwise. Every decision is the one that `decide` gives for the element alone.
#pragma once

#include "bezcert/batch/batch.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/mesh/mesh.hpp"

#include <functional>

namespace bezcert {

/// How elements were decided: for benchmarks; no answer depends on it.
struct DecisionCounts {
  std::size_t batch = 0;     ///< by a block
  std::size_t interval = 0;  ///< by intervals
  std::size_t exact = 0;     ///< with integers
};

class MeshDecider {
 public:
  /// Keeps a reference: `mesh` must outlive this. Filter::off leaves out blocks and intervals.
  explicit MeshDecider(const Mesh& mesh, const Budget& budget = {}, Filter filter = Filter::on)
      : mesh_(mesh), budget_(budget), filter_(filter) {}

  /// Called with the place of an element and its decision, which lives for the call.
  using Visit = std::function<void(std::size_t, const Decision&)>;

  /// Decides elements first ... last - 1, in this order. Thread-safe for different callers.
  /// Throws std::invalid_argument as Mesh::element does.
  DecisionCounts decide_range(std::size_t first, std::size_t last, const Visit& visit) const;

 private:
  void settle(std::size_t first, std::size_t last, std::span<batch::Settled> results) const;

  const Mesh& mesh_;
  Budget budget_;
  Filter filter_;
};

}  // namespace bezcert
