#include "bezcert/curve/incidence.hpp"

#include "bezcert/algebra/real_root.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// The common zeros of X - x W and Y - y W: where the curve is at the point. 0 if it is there always.
Univariate equation(const CurveNet<Integer>& curve, const Point& point) {
  const auto difference = [&](const std::vector<Integer>& values, const Rational& at) {
    std::vector<Integer> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
      result.push_back(values[i] * Integer(denominator(at)) - curve.w[i] * Integer(numerator(at)));
    }
    return from_bernstein(result);
  };
  return gcd(difference(curve.x, point.x), difference(curve.y, point.y));
}

}  // namespace

bool passes_inside(const CurveNet<Integer>& curve, const Point& point) {
  const Univariate f = equation(curve, point);
  if (f.is_zero()) return true;
  if (f.degree() == 0) return false;
  const std::vector<RealRoot> roots = roots_in(square_free_part(f), 0, 1);
  return std::any_of(roots.begin(), roots.end(), [](const RealRoot& root) {
    return !root.is_rational() || (root.lower.sign() > 0 && root.lower < 1);
  });
}

std::vector<Rational> rational_parameters(const CurveNet<Integer>& curve, const Point& point,
                                          const Rational& lower) {
  std::vector<Rational> result;
  const Univariate f = equation(curve, point);
  if (f.degree() < 1) return result;
  for (const auto& [factor, multiplicity] : irreducible_factors(f)) {
    if (factor.degree() != 1) continue;
    const Rational t = root_of_linear(factor);
    if (t > lower && t <= 1) result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool run_together(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  const auto is_on = [](const CurveNet<Integer>& curve, const Point& point) {
    return point == point_at(curve, 0) || point == point_at(curve, 1) || passes_inside(curve, point);
  };
  std::vector<Rational> on_b;
  if (is_on(a, point_at(b, 0))) on_b.push_back(0);
  if (is_on(a, point_at(b, 1))) on_b.push_back(1);
  for (const int end : {0, 1}) {
    for (const Rational& t : rational_parameters(b, point_at(a, end), 0)) on_b.push_back(t);
  }
  std::sort(on_b.begin(), on_b.end());
  if (on_b.empty() || on_b.front() == on_b.back()) return false;
  // More common points than the product of the degrees: by Bezout one irreducible curve holds both.
  const auto samples = static_cast<long>((a.size() - 1) * (b.size() - 1) + 1);
  for (long k = 1; k <= samples; ++k) {
    const Rational t = on_b.front() + (on_b.back() - on_b.front()) * Rational(k, samples + 1);
    if (!passes_inside(a, point_at(b, t))) return false;
  }
  return true;
}

}  // namespace bezcert
