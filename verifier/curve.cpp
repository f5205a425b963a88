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

// The derivatives at z = 0 tell rho, unless one of them is 0.
bool one_curve(Curve a, const Curve& b) {
  const auto slope = [](const Curve& c, Integers Curve::*f) {
    return fraction((c.*f)[1] * c.w[0] - (c.*f)[0] * c.w[1], c.w[0] * c.w[0]);
  };
  const Point at_a{slope(a, &Curve::x), slope(a, &Curve::y)}, at_b{slope(b, &Curve::x), slope(b, &Curve::y)};
  if (at_a == Point() || at_b == Point()) return true;
  const mpq_class rho = at_a[0] != 0 ? at_b[0] / at_a[0] : at_b[1] / at_a[1];
  if (rho <= 0) return false;
  for (const auto f : coordinates)
    a.*f = compose(a.*f, static_cast<int>((a.*f).size()) - 1, {{0, rho.get_num()}, rho.get_den()});
  return a.x * b.w == b.x * a.w && a.y * b.w == b.y * a.w;
}

}  // namespace verifier
