#include "map.hpp"

#include <algorithm>

namespace verifier {

namespace {

/// The same with the origin for p.
int crossings(const Curve& c, int depth) {
  if (one_strict_sign(c.x) || one_strict_sign(c.y)) {
    const bool up = c.y[0] <= 0 && c.y.back() > 0, down = c.y[0] > 0 && c.y.back() <= 0;
    const int side = up || down ? cmp(c.x[0] * c.y.back(), c.x.back() * c.y[0]) : 0;
    return up && side > 0 ? 1 : down && side < 0 ? -1 : 0;
  }
  require(depth < 4096, "a point is not shown to be off a curve");
  const auto half = halves(c);
  return crossings(half[0], depth + 1) + crossings(half[1], depth + 1);
}

/// The coefficients of powers of z as polynomials in rho: those of c(rho z), or of c(z).
Polynomial2 in_z(const Integers& c, bool with_rho) {
  Polynomial2 rows;
  for (std::size_t i = 0; i < c.size(); ++i) {
    rows.emplace_back(with_rho ? i + 1 : 1);
    rows.back().back() = c[i];
  }
  trim(rows);
  return rows;
}

}  // namespace

Curve reversed(Curve curve) {
  for (const auto f : coordinates) std::reverse((curve.*f).begin(), (curve.*f).end());
  return curve;
}

Curve part(Curve curve, const mpq_class& low, const mpq_class& high) {
  const std::size_t d = curve.x.size(),
                    size = limbs({low.get_num(), low.get_den(), high.get_num(), high.get_den()});
  for (const auto f : coordinates) {
    spend(2 * d * d * product_work(limbs(curve.*f) + d * size, size));
    shear(line(curve.*f), true);  // to powers
    curve.*f = bernstein(curve.*f, low, high);
  }
  return curve;
}

std::array<Curve, 2> halves(const Curve& curve) {
  const mpq_class middle(1, 2);
  return {part(curve, 0, middle), part(curve, middle, 1)};
}

Point control_point(const Curve& curve, std::size_t i) {
  return {fraction(curve.x[i], curve.w[i]), fraction(curve.y[i], curve.w[i])};
}

Point point(const Curve& curve, const mpq_class& t) { return control_point(part(curve, t, t), 0); }

int crossings(const Point& p, Curve c) {
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    c.x[i] = c.x[i] * p[0].get_den() - p[0].get_num() * c.w[i];
    c.y[i] = c.y[i] * p[1].get_den() - p[1].get_num() * c.w[i];
  }
  return crossings(c, 0);
}

int winding(const Point& p, const std::vector<Curve>& loop) {
  int sum = 0;
  for (const Curve& c : loop) sum += crossings(p, c);
  return sum;
}

// The differences X_a(rho z) W_b(z) - W_a(rho z) X_b(z), and with Y, have coefficients of powers of z whose
// common roots rho != 0 are simple, and those of rho^j = r for one j and r (certificate-format.md): their
// greatest common divisor has a change of sign if and only if r > 0.
bool one_curve(const Curve& a, const Curve& b) {
  bool equal = a.x.size() == b.x.size();  // in the same parameter: by far the most
  for (const auto f : coordinates)
    for (std::size_t i = 0; equal && i < a.x.size(); ++i) equal = (a.*f)[i] * b.w[0] == (b.*f)[i] * a.w[0];
  if (equal) return true;
  Polynomial divisor;
  for (const auto f : {&Curve::x, &Curve::y})
    for (const Polynomial& c : in_z(a.*f, true) * in_z(b.w, false) - in_z(a.w, true) * in_z(b.*f, false))
      divisor = common_divisor(divisor, c);
  return divisor.empty() || std::any_of(divisor.begin(), divisor.end(),
                                        [&](const mpz_class& c) { return sgn(c) * sgn(divisor.back()) < 0; });
}

}  // namespace verifier
