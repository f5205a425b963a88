// Whether the boundary of a regular element is a simple closed curve.
//
// A regular element is a local homeomorphism of a disc; it is injective if and only if its boundary is simple
// (docs/decision.md). Every edge is held against itself and the others (curve/contact.hpp): neighbours may
// meet at their corner only, other edges nowhere.
#pragma once

#include "bezcert/curve/contact.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/element/parameter.hpp"
#include "bezcert/verdict/decision.hpp"

#include <deque>
#include <optional>

namespace bezcert {

enum class BoundaryStatus { simple, overlapping, open };

struct BoundaryResult {
  BoundaryStatus status = BoundaryStatus::open;
  std::optional<Overlap> overlap;            ///< set if overlapping
  std::optional<ExhaustedBudget> exhausted;  ///< set if open
};

/// The curves of the edges, in order.
std::deque<DyadicCurve> edge_curves(const Forms& forms);

/// Precondition: the element is regular.
BoundaryResult examine_boundary(const Forms& forms, const ContactBudget& budget = {});

/// The point of the domain at parameter t of an edge.
Parameter boundary_parameter(const Element& element, int edge, const Rational& t);

}  // namespace bezcert
