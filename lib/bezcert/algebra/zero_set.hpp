// The real zeros of an irreducible polynomial h(u, v) on the closed triangle or square.
//
// Theorem (docs/decision.md, "Algebra"). Let h depend on v, and let C(u) be the product of h's leading
// coefficient in v, the resultant of h and h_v, and the restrictions of h to the edges below and above. Over
// every open interval between neighbouring real roots of C the zeros of h in the open domain are the graphs
// of a constant number of functions, and h changes its sign at each. So one rational u in each interval tells
// whether h has a curve of zeros inside and changes its sign. If there is none, an inner zero is a point
// where h_u = h_v = 0 as well, it lies over a multiple root of the resultant, and fibres over those roots
// decide. Zeros on the edges are roots of univariate polynomials.
#pragma once

#include "bezcert/algebra/bivariate.hpp"
#include "bezcert/algebra/planar_point.hpp"

#include <optional>
#include <utility>

namespace bezcert {

/// Closed intervals of a parameter, ascending and disjoint.
using Strips = std::vector<std::pair<Rational, Rational>>;

/// The union of intervals in any order.
Strips merged(Strips intervals);

struct ZeroSet {
  /// -1: no zero in the closed domain; 0: finitely many; 1: a curve of them.
  int dimension = -1;
  /// Whether h takes both signs in the domain; then `column_u` tells if the column is u or v = `column`,
  /// along which it does, in the open interval `cell` of which every column has that property up to finitely
  /// many.
  bool changes_sign = false;
  bool column_is_u = true;
  std::pair<Rational, Rational> cell;
  /// Zeros: all those on the edges that are isolated along their edge; one of a curve of zeros inside, if
  /// there is one; if there are none of both, one over each column that has inner ones. Empty only if there
  /// is no zero.
  std::vector<PlanarPoint> zeros;
};

/// Zeros on the closed domain. Only columns u (or v) in the strips are looked at for inner zeros: give those
/// parts of [0, 1] in which zeros are not excluded. Precondition: h is irreducible of positive degree.
ZeroSet zero_set(const Bivariate& h, Domain domain, const Strips& strips_u, const Strips& strips_v);

/// The largest degree of the resultants that zero_set may compute.
int zero_set_degree(const Bivariate& h);

}  // namespace bezcert
