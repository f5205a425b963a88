// The check of a mesh: every element by exact decision, published conditions held against it, the mesh as a
// whole, and its conformity to curves.
//
//   MeshReport report = check_mesh(mesh);                      // one call does the job
//   if (report.outcome() != Outcome::certified) ...
//
// Theorems: decide/decide.hpp (elements), surface/embedding.hpp (the mesh), surface/domain.hpp (curves).
#pragma once

#include "bezcert/check/counts.hpp"
#include "bezcert/check/observer.hpp"
#include "bezcert/surface/domain.hpp"
#include "bezcert/surface/mesh_result.hpp"
#include "bezcert/parallel/executor.hpp"

#include <optional>
#include <span>
#include <vector>

namespace bezcert {

struct CheckOptions {
  /// Published conditions to hold against the decision, which always runs. None if it alone is wanted; all:
  /// all_criteria().
  std::vector<const Criterion*> criteria;
  Budget budget;
  /// Curves that the mesh is to conform to: each exactly covered by consecutive edges.
  std::span<const InputCurve> curves;
  /// Threads to use; null: the calling thread alone. Reports do not depend on it.
  Executor* executor = nullptr;
  /// off: elements are decided by integers alone, with the same report.
  Filter filter = Filter::on;
};

/// The worst that a report holds, in this order from the best.
enum class Outcome {
  certified,     ///< all elements are injective, the mesh is an embedding and conforms to the curves
  undecided,     ///< a budget ran out, and nothing is known to be wrong
  invalid,       ///< an element, the mesh or its conformity
  contradiction  ///< a sound criterion contradicts the decision: a defect of bezcert
};

/// An element that is not certified.
struct BadElement {
  std::size_t element = 0;  ///< its place in the mesh
  Decision decision;
};

/// What is known of elements first ... last - 1, one by one.
struct ElementsReport {
  /// Bad elements that are kept, the first ones; all are counted.
  static constexpr std::size_t kept = 20;

  std::size_t first = 0, last = 0;
  std::vector<const Criterion*> criteria;  ///< those chosen, in the order of `counts.by_criterion`
  ElementCounts counts;
  std::vector<ElementState> states;  ///< of each element
  std::vector<BadElement> bad;

  /// Appends the report of the elements that follow. Throws std::invalid_argument if they do not, or if other
  /// criteria were chosen.
  void append(ElementsReport next);
};

struct MeshReport {
  ElementsReport elements;
  MeshResult mesh;
  std::optional<DomainResult> domain;  ///< if there are curves

  Outcome outcome() const;
};

/// Checks a whole mesh. The observer may be several (observer.hpp). Throws std::invalid_argument if a
/// criterion is null or a curve is none (InputCurve::validate), std::logic_error if the executor did not run
/// all works or the thread does not round to nearest, and what the observer or the executor throws.
MeshReport check_mesh(const Mesh& mesh, const CheckOptions& options, CheckObserver& observer);
MeshReport check_mesh(const Mesh& mesh, const CheckOptions& options = {});

/// The same in two steps, so that parts of a mesh can be checked apart, on several machines for example: the
/// elements of a range, whose reports are appended to each other; then the mesh, once all are there. The
/// observer sees the beginning and the elements of the range, not the end. Throws std::invalid_argument if
/// the range is none of the mesh, and as check_mesh does.
ElementsReport check_elements(const Mesh& mesh, std::size_t first, std::size_t last,
                              const CheckOptions& options, CheckObserver& observer);
/// Throws std::invalid_argument if the report is not of all elements.
MeshReport conclude(const Mesh& mesh, ElementsReport elements, const CheckOptions& options);

}  // namespace bezcert
