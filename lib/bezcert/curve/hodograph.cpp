#include "bezcert/curve/hodograph.hpp"

#include "bezcert/algebra/real_root.hpp"

namespace bezcert {
namespace {

// The coefficients of f' in the degree of f: n times the differences, elevated.
std::vector<Integer> derivative(const std::vector<Integer>& f) {
  const std::size_t n = f.size() - 1;
  std::vector<Integer> result(f.size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Integer step = f[i + 1] - f[i];
    result[i] += step * (n - i);
    result[i + 1] += step * (i + 1);
  }
  return result;
}

}  // namespace

CurveNet<Integer> hodograph(const CurveNet<Integer>& curve) {
  const std::vector<Integer> weight_slope = derivative(curve.w);
  const auto numerator = [&](const std::vector<Integer>& f) {
    std::vector<Integer> result = scaled_product(derivative(f), curve.w);
    const std::vector<Integer> less = scaled_product(f, weight_slope);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] -= less[k];
    return result;
  };
  return from_scaled({numerator(curve.x), numerator(curve.y), scaled_product(curve.w, curve.w)});
}

Vector2<Rational> derivative_at(const CurveNet<Integer>& curve, const Rational& t) {
  Point point = point_at(hodograph(curve), t);
  return {std::move(point.x), std::move(point.y)};
}

bool is_regular(const CurveNet<Integer>& curve) {
  const CurveNet<Integer> slope = hodograph(curve);
  const Univariate common = gcd(from_bernstein(slope.x), from_bernstein(slope.y));
  if (common.is_zero()) return false;  // a single point
  return common.degree() == 0 || roots_in(square_free_part(common), 0, 1).empty();
}

}  // namespace bezcert
