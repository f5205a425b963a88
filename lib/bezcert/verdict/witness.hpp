// Evidence that a verdict shows: parameters of an element, each checked by itself.
#pragma once

#include "bezcert/algebra/planar_point.hpp"
#include "bezcert/element/parameter.hpp"

#include <vector>

namespace bezcert {

/// A parameter, the exact value of det J there, and the place in the plane that the element maps it to: (x,
/// y), exactly.
struct Witness {
  Parameter parameter;
  Rational determinant;
  std::vector<Rational> place;
};

struct ExactNet;

/// Evaluates the map and det J at a parameter directly (evaluate_map): the witness stands on its own.
Witness make_witness(const ExactNet& net, Parameter parameter);

/// The zero set of det J in the closed domain.
struct AlgebraicZero {
  /// One zero in (u, v), element.hpp: rational, or isolated.
  PlanarPoint at;
  /// Of the whole zero set: 0 finitely many points, 1 a curve, 2 the whole domain; -1: not known.
  int dimension = 0;
};

/// A part of the boundary: edge number (edge i leads from corner i to the next) and a parameter range on it,
/// from 0 at the edge's first corner to 1. One point where lower == upper.
struct BoundaryRange {
  int edge = 0;
  Rational lower, upper;
};

/// Two parts of the boundary that have an image point in common.
struct Overlap {
  BoundaryRange first, second;
  /// Whether the two parts run along each other for a piece.
  bool along_a_piece = false;
};

}  // namespace bezcert
