// Evidence that two places on edges have one image: the rule MEET of certificates
// (docs/certificate-format.md).
//
// A point where both parameters are rational; or two ranges that certainly cross (Poincare-Miranda); or
// parameters that are polynomials in one algebraic number, found by algebra/algebraic_point.hpp and checked
// by division. What is written is checked here exactly, as the format says, wherever the contact comes from.
#pragma once

#include "bezcert/curve/contact.hpp"
#include "bezcert/decide/boundary.hpp"

#include <optional>
#include <string>

namespace bezcert {

/// An edge, and what the certificate calls it.
struct NamedCurve {
  CurveNet<Integer> net;
  std::string name;
};

/// Which places on two edges are one point of the domain (or of the glued domain), and so no contact.
struct CommonPlaces {
  bool same_edge = false;  ///< equal parameters
  /// [i][j]: end i of the first edge (0: its beginning) and end j of the second.
  bool ends[2][2] = {{false, false}, {false, false}};
};

/// MEET at a contact of two edges, in different places. Nothing if that cannot be shown of this contact.
std::optional<std::string> meet_evidence(const NamedCurve& a, const NamedCurve& b, const CommonPlaces& common,
                                         const Contact& contact);

/// MEET where the beginning, the middle or the end of one edge lies on the other at a rational parameter.
std::optional<std::string> meet_at_ends(const NamedCurve& a, const NamedCurve& b, const CommonPlaces& common);

/// MEET of an element whose boundary meets itself there.
std::optional<std::string> meet_evidence(const Forms& forms, const Overlap& overlap);

}  // namespace bezcert
