// Whether two edges that follow each other run in one direction: then they meet at their joint only.
//
// Let d be any vector and P_0 ... P_n, Q_0 ... Q_m the control points of polynomial edges p and q with P_n =
// Q_0. If d (P_i+1 - P_i) > 0 and d (Q_j+1 - Q_j) > 0 for all i and j, then d p and d q increase strictly
// (their derivatives are means of these numbers, times n and m), so that d p(s) <= d P_n <= d q(t), with
// equality on both sides for s = 1, t = 0 alone. (The hodographs lie in an open half-plane.) Most pairs of
// neighbours on a boundary are such.
//
// Asked in doubles, for d from the first point to the last, rounded: any d will do. With e_k = d (x_k - x_0)
// for the nodes (or control points) x_k, d (P_i+1 - P_i) is a sum S of c_k e_k, c_k integers below 2^40, with
// m <= 64 terms. Let v = 2^-52, the error of one operation in any rounding mode, and a the largest sum
// |d_x| |x_k - x_0| + |d_y| |y_k - y_0|. Then e_k is wrong by at most ((1 + v)^3 - 1) a, a product with c_k
// adds one rounding and the sum m - 1: |s - S| <= ((1 + v)^(m+3) - 1) C a with C = sum |c_k|, and computing
// C a is wrong by as little. Together that is below (m + 4) v C a; the test takes twice that. All numbers are
// kept below 2^900 in size, so that nothing overflows, and a above 2^-800, so that what underflows (below
// 2^-1000 in all) is far inside the slack.
#pragma once

#include "bezcert/surface/half_edges.hpp"

namespace bezcert {

/// True only if the edges certainly have one point in common, the end of `first`, which is the beginning of
/// `second`. In any rounding mode. Precondition: that is one node, or two at one point.
bool run_one_way(const HalfEdges& edges, HalfEdge first, HalfEdge second);

}  // namespace bezcert
