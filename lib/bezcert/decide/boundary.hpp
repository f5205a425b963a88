// Whether the boundary of a regular element is a simple closed curve.
//
// A regular element is a local homeomorphism of a disc; it is injective if and only if its boundary is simple
// (docs/decision.md). The boundary's edges are halved until every piece is monotone, neighbours part at
// their common point, and other pieces have disjoint hulls: then it is simple. Or two pieces certainly
// cross, or end points of pieces coincide: then it is not. Contacts that are neither (tangential, or
// at parameters that are not dyadic on one side only) stay open when the budget is spent.
#pragma once

#include "bezcert/element/forms.hpp"

#include <optional>
#include <string>

namespace bezcert {

/// A part of the boundary: edge number (edge i leads from corner i to the next) and a parameter range on it,
/// from 0 at the edge's first corner to 1. One point where lower == upper.
struct BoundaryRange {
  int edge = 0;
  Rational lower, upper;
};

/// Two parts of the boundary that have an image point in common.
struct Overlap {
  BoundaryRange first, second;
};

enum class BoundaryStatus { simple, overlapping, open };

struct BoundaryResult {
  BoundaryStatus status = BoundaryStatus::open;
  std::optional<Overlap> overlap;  ///< set if overlapping
  std::string exhausted;           ///< set if open: the budget that ran out
};

struct BoundaryBudget {
  /// Pairs of pieces compared.
  std::size_t pairs = 65536;
  /// Halvings of an edge for one piece: coordinates grow by the degree in bits with each.
  int depth = 96;
};

/// Precondition: the element is regular.
BoundaryResult examine_boundary(const Forms& forms, const BoundaryBudget& budget = {});

/// The point of the domain at parameter t of an edge.
Parameter boundary_parameter(const Element& element, int edge, const Rational& t);

}  // namespace bezcert
