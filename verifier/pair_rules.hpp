// How edges lie to each other: simple boundaries, common points (docs/certificate-format.md, INJECTIVE,
// MEET).
#pragma once

#include "elements.hpp"
#include "polynomial.hpp"

namespace verifier {

using Point = std::array<mpq_class, 2>;
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }

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
/// All of them.
std::vector<Curve> edge_curves(const Element& element);
/// The sign of x (axis 0) or y (1) of the direction in which the curve through these places of the element
/// (edge_positions, perhaps reversed) begins.
int first_direction(const Element& element, const std::vector<std::size_t>& places, int axis);
Curve reversed(Curve curve);
std::array<Curve, 2> halves(const Curve& curve);
Point control_point(const Curve& curve, std::size_t i);
/// The point at a parameter.
Point point(const Curve& curve, const mpq_class& t);

/// Common end points that are no contact.
struct Joints {
  bool end_to_begin = false;  ///< a ends where b begins
  bool begin_to_end = false;  ///< a begins where b ends
};

/// PAIR: a and b meet at the joints only.
void check_pair(Tokens& tokens, const Curve& a, const Curve& b, Joints joints, int depth = 0);
/// The evidence of INJECTIVE `boundary`.
void check_boundary(Tokens& tokens, const Element& element);

/// m has a root in (low, high); all `sides` are >= 0 at (u(x), v(x)) for every root x of m in [low, high].
void check_root(const Polynomial& m, const mpq_class& low, const mpq_class& high, const RationalPolynomial& u,
                const RationalPolynomial& v, const std::vector<Polynomial2>& sides);

/// Edges that MEET is about, and which of their ends are one point of the domain: common[i][j]: end i of the
/// first (0: t = 0, 1: t = 1) with end j of the second.
struct MeetContext {
  Curve first, second;
  bool same_edge = false;
  bool common[2][2] = {{false, false}, {false, false}};
};
/// MEET as it is written. Whether there are such edges is for the caller to check.
struct Meet {
  struct Place : EdgeName {
    mpq_class low, high;  ///< parameters, equal if `at`
    RationalPolynomial parameter;
  };
  std::string_view kind;
  Polynomial m;
  mpq_class low, high;  ///< of the root
  Place first, second;
};
/// Reads a MEET; edges are numbers (element 0) or, if `in_mesh`, EDGEs.
Meet read_meet(Tokens& tokens, bool in_mesh);
void check_meet(const Meet& meet, const MeetContext& context);

}  // namespace verifier
