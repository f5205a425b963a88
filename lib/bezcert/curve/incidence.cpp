#include "bezcert/curve/incidence.hpp"

#include "bezcert/algebra/real_root.hpp"
#include "bezcert/number/scaled.hpp"

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

// De Casteljau's step at t = p / q, times q.
void step(std::vector<Integer>& values, std::size_t count, const Integer& p, const Integer& rest) {
  for (std::size_t i = 0; i + 1 < count; ++i) values[i] = rest * values[i] + p * values[i + 1];
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

CurveNet<Integer> part_of(const CurveNet<Integer>& curve, const Rational& lower, const Rational& upper) {
  const std::size_t count = curve.size();
  const Integer common = lcm(Integer(denominator(lower)), Integer(denominator(upper)));
  const Integer a = Integer(numerator(lower)) * (common / denominator(lower));
  const Integer b = Integer(numerator(upper)) * (common / denominator(upper));
  const auto part = [&](const std::vector<Integer>& values) {
    // Every value takes count - 1 steps, so all have the same factor common^(count - 1).
    std::vector<Integer> result;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<Integer> polar = values;
      for (std::size_t s = 0; s + 1 < count; ++s) {
        const Integer& at = s < k ? b : a;
        step(polar, count - s, at, common - at);
      }
      result.push_back(polar[0]);
    }
    return result;
  };
  return {part(curve.x), part(curve.y), part(curve.w)};
}

Point point_at(const CurveNet<Integer>& curve, const Rational& t) {
  const CurveNet<Integer> there = part_of(curve, t, t);
  return {Rational(there.x[0], there.w[0]), Rational(there.y[0], there.w[0])};
}

}  // namespace bezcert
