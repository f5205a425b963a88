// The area beside polynomial edges with double coordinates, exactly and in few integer operations.
//
// The share of an edge, the integral of (x dy - y dx) / 2 along it, is bilinear and antisymmetric in the
// coordinates of its nodes (or control points): the sum over i < j of A_ij (x_i y_j - x_j y_i) with rational
// A_ij that depend on the degree and the basis only. Doubles are integers times one power of two, so a
// chain's area is a sum of integers over the common denominator of the A_ij.
#pragma once

#include "bezcert/surface/half_edges.hpp"

#include <span>

namespace bezcert {

/// Whether an edge is polynomial and its coordinates are doubles.
bool has_plain_area(const HalfEdges& edges, HalfEdge h);

/// The sum of the shares of edges for which has_plain_area holds.
Rational plain_area(const HalfEdges& edges, std::span<const HalfEdge> half_edges);

}  // namespace bezcert
