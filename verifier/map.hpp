// Elements as polynomial maps, and their edges: rational Bezier curves, their parts, the side on which they
// pass a point, and whether two of them are one.
#pragma once

#include "elements.hpp"

namespace verifier {

/// X, Y, W in powers of u and v, times one positive number; if not rational W = 1, and X, Y are times one.
struct Map {
  Polynomial2 x, y, w;
};
/// Throws Malformed if a control weight is not positive.
Map map_of(const Element& element);
/// N = [P P_u P_v] times a positive number.
Polynomial2 jacobian_numerator(const Map& map, bool rational);

using Point = std::array<mpq_class, 2>;
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline mpq_class cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
/// A node or control point.
Point element_point(const Element& element, std::size_t i);

/// Homogeneous coordinates, w > 0: control points times binomials and one positive number.
struct Curve {
  Integers x, y, w;
};
inline constexpr Integers Curve::*coordinates[] = {&Curve::x, &Curve::y, &Curve::w};

/// All edges. Throws Malformed as map_of does.
std::vector<Curve> edge_curves(const Element& element);
Curve reversed(Curve curve);
/// The curve from one parameter to another.
Curve part(Curve curve, const mpq_class& low, const mpq_class& high);
std::array<Curve, 2> halves(const Curve& curve);
Point control_point(const Curve& curve, std::size_t i);
/// The point at a parameter.
Point point(const Curve& curve, const mpq_class& t);

/// How often the curve, its pieces whose boxes do not hold p replaced by chords, passes the ray from p along
/// the positive x axis upwards less downwards. Rejected if this does not end: p may be on the curve.
int crossings(const Point& p, Curve curve);
int winding(const Point& p, const std::vector<Curve>& loop);

/// Whether a(rho z) = b(z) for a rho > 0, z = t / (1 - t): b is a after a change of its parameter that keeps
/// the direction. True as well, for "perhaps", if one of them is not regular at its begin: edges of regular
/// elements are.
bool one_curve(Curve a, const Curve& b);

}  // namespace verifier
