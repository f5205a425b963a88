// How edges lie to each other: simple boundaries, common points (docs/certificate-format.md, INJECTIVE,
// MEET).
#pragma once

#include "elements.hpp"
#include "polynomial.hpp"

namespace verifier {

mpz_class choose(std::size_t n, std::size_t k);
/// a / b in lowest terms.
mpq_class fraction(const mpz_class& a, const mpz_class& b);

/// A rational Bezier curve: homogeneous control points (x, y, w), w > 0, times one positive number.
struct Curve {
  std::vector<mpz_class> x, y, w;
};
inline constexpr std::vector<mpz_class> Curve::*coordinates[] = {&Curve::x, &Curve::y, &Curve::w};

/// Throws Malformed if there is no such edge, or a control weight of it is not positive.
Curve edge_curve(const Element& element, int e);
/// The sign of x (axis 0) or y (1) of the direction in which the curve through these places of the element
/// (edge_positions, perhaps reversed) begins.
int first_direction(const Element& element, const std::vector<std::size_t>& places, int axis);
Curve reversed(Curve curve);
/// The two halves of a curve.
std::array<Curve, 2> halves(const Curve& curve);
/// The curve restricted to [low, high], 0 <= low < high <= 1, without halving.
Curve restricted(const Curve& curve, const mpq_class& low, const mpq_class& high);
/// The point at a parameter in [0, 1].
std::array<mpq_class, 2> point(const Curve& curve, const mpq_class& t);

/// Common end points that are no contact.
struct Joints {
  bool end_to_begin = false;  ///< a ends where b begins
  bool begin_to_end = false;  ///< a begins where b ends
};

/// PAIR: a and b meet at the joints only.
void check_pair(Tokens& tokens, const Curve& a, const Curve& b, Joints joints);
/// The evidence of INJECTIVE `boundary`.
void check_boundary(Tokens& tokens, const Element& element);

/// Edges that MEET is about, and which of their ends are one point of the domain: common[i][j]: end i of the
/// first (0: t = 0, 1: t = 1) with end j of the second.
struct MeetContext {
  Curve first, second;
  bool same_edge = false;
  bool common[2][2] = {{false, false}, {false, false}};
};
/// MEET as it is written. Whether there are such edges is for the caller to check.
struct Meet {
  std::string_view kind;
  Polynomial m;
  mpq_class low, high;              ///< of the root
  mpq_class first_low, first_high;  ///< parameters, equal if `at`
  mpq_class second_low, second_high;
  RationalPolynomial s, t;
  EdgeName first, second;
};
/// Reads a MEET; edges are numbers (element 0) or, if `in_mesh`, EDGEs.
Meet read_meet(Tokens& tokens, bool in_mesh);
/// Checks it.
void check_meet(const Meet& meet, const MeetContext& context);

}  // namespace verifier
