#include "bezcert/curve/curve_net.hpp"

#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>

namespace bezcert {

bool is_polynomial(const CurveNet<Integer>& curve) {
  return std::all_of(curve.w.begin(), curve.w.end(), [&](const Integer& w) { return w == curve.w[0]; });
}

Point point_at(const CurveNet<Integer>& curve, const Rational& t) {
  const CurveNet<Integer> there = part_of(curve, t, t);
  return {Rational(there.x[0], there.w[0]), Rational(there.y[0], there.w[0])};
}

CurveNet<Integer> part_of(const CurveNet<Integer>& curve, const Rational& lower, const Rational& upper) {
  const std::size_t count = curve.size();
  const Integer common = lcm(Integer(denominator(lower)), Integer(denominator(upper)));
  const Integer a = Integer(numerator(lower)) * (common / denominator(lower));
  const Integer b = Integer(numerator(upper)) * (common / denominator(upper));
  const auto part = [&](const std::vector<Integer>& values) {
    // Every value takes count - 1 of de Casteljau's steps, each times `common`: all have one factor.
    std::vector<Integer> result;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<Integer> polar = values;
      for (std::size_t s = 0; s + 1 < count; ++s) {
        const Integer& at = s < k ? b : a;
        const Integer rest = common - at;
        for (std::size_t i = 0; i + 1 < count - s; ++i) polar[i] = rest * polar[i] + at * polar[i + 1];
      }
      result.push_back(polar[0]);
    }
    return result;
  };
  return {part(curve.x), part(curve.y), part(curve.w)};
}

std::pair<CurveNet<Integer>, CurveNet<Integer>> split(const CurveNet<Integer>& curve, const Rational& t) {
  return {part_of(curve, 0, t), part_of(curve, t, 1)};
}

CurveNet<Integer> elevated(const CurveNet<Integer>& curve, int degree) {
  // All coefficients of 1 are 1.
  const std::vector<Integer> one(static_cast<std::size_t>(degree) + 2 - curve.size(), 1);
  return from_scaled(
      {scaled_product(curve.x, one), scaled_product(curve.y, one), scaled_product(curve.w, one)});
}

CurveNet<Integer> balanced(const CurveNet<Integer>& curve, const Integer& a, const Integer& b) {
  CurveNet<Integer> result = curve;
  Integer from_begin = 1, from_end = 1;
  for (std::size_t i = 0; i < curve.size(); ++i, from_begin *= a, from_end *= b) {
    const std::size_t back = curve.size() - 1 - i;
    for (auto* values : {&result.x, &result.y, &result.w}) {
      (*values)[i] *= from_begin;
      (*values)[back] *= from_end;
    }
  }
  return result;
}

std::vector<Integer> scaled_product(const std::vector<Integer>& f, const std::vector<Integer>& g) {
  const int m = static_cast<int>(f.size()) - 1, n = static_cast<int>(g.size()) - 1;
  std::vector<Integer> result(f.size() + g.size() - 1, 0);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      result[static_cast<std::size_t>(i + j)] +=
          binomial(m, i) * f[static_cast<std::size_t>(i)] * (binomial(n, j) * g[static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

CurveNet<Integer> from_scaled(CurveNet<Integer> scaled) {
  // The least common multiple of the binomials makes their division exact.
  const int degree = static_cast<int>(scaled.size()) - 1;
  Integer common = 1;
  for (int k = 0; k <= degree; ++k) common = lcm(common, binomial(degree, k));
  for (int k = 0; k <= degree; ++k) {
    const Integer factor = common / binomial(degree, k);
    for (auto* values : {&scaled.x, &scaled.y, &scaled.w}) (*values)[static_cast<std::size_t>(k)] *= factor;
  }
  return scaled;
}

}  // namespace bezcert
