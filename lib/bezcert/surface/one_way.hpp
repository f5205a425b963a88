// Whether two edges that follow each other run in one direction: then they meet at their joint only.
//
// Let d be any vector and P_0 ... P_n, Q_0 ... Q_m the control points of polynomial edges p and q with P_n =
// Q_0. If d (P_i+1 - P_i) > 0 and d (Q_j+1 - Q_j) > 0 for all i and j, then d p and d q increase strictly
// (their derivatives are means of these numbers, times n and m), so that d p(s) <= d P_n <= d q(t), with
// equality on both sides for s = 1, t = 0 alone. (The hodographs lie in an open half-plane.) Most pairs of
// neighbours on a boundary are such.
//
// Asked in doubles, for d from the first point to the last, rounded: any d will do. d (P_i+1 - P_i) is a sum
// of products of d with nodes relative to the first, with integer coefficients; its error is found by running
// the same sum over StaticBound. Units are kept between 2^-420 and 2^850, so that bounds hold and nothing
// overflows.
#pragma once

#include "bezcert/surface/half_edges.hpp"

namespace bezcert {

/// True only if the edges certainly have one point in common, the end of `first`, which is the beginning of
/// `second`. In any rounding mode. Precondition: that is one node, or two at one point.
bool run_one_way(const HalfEdges& edges, HalfEdge first, HalfEdge second);

}  // namespace bezcert
