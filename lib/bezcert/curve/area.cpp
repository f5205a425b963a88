#include "bezcert/curve/area.hpp"

#include "bezcert/curve/dyadic_curve.hpp"

#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>

namespace bezcert {
namespace {

Rational polynomial_share(const CurveNet<Integer>& net) {
  const auto [positive, negative] = bracket_integral(net.x, net.y);
  return (positive + negative) / Rational(Integer(2 * net.w[0] * net.w[0]));
}

// With the origin in the first point: x dy - y dx = (X Y' - Y X') / W^2 dt, X and Y relative to that point.
AreaBounds piece_share(const CurveNet<Integer>& net) {
  const std::size_t last = net.size() - 1;
  const Integer &x0 = net.x[0], &y0 = net.y[0], &w0 = net.w[0];
  std::vector<Integer> x(net.size()), y(net.size());
  for (std::size_t i = 0; i <= last; ++i) {
    x[i] = net.x[i] * w0 - x0 * net.w[i];
    y[i] = net.y[i] * w0 - y0 * net.w[i];
  }
  const auto [positive, negative] = bracket_integral(x, y);
  const auto [w_low, w_high] = std::minmax_element(net.w.begin(), net.w.end());
  // X and Y have the factor w0 more.
  const Integer twice = 2 * w0 * w0;
  const Rational low(Integer(twice * *w_low * *w_low)), high(Integer(twice * *w_high * *w_high));
  const Rational chord =
      Rational(Integer(x0 * net.y[last] - y0 * net.x[last]), Integer(2 * w0 * net.w[last]));
  return {chord + positive / high + negative / low, chord + positive / low + negative / high};
}

AreaBounds pieces_share(DyadicCurve& curve, DyadicCurve::Piece piece, int halvings) {
  if (halvings == 0) return piece_share(curve.exact(piece));
  const auto [first, second] = curve.halves(piece);
  AreaBounds sum = pieces_share(curve, first, halvings - 1);
  return sum += pieces_share(curve, second, halvings - 1);
}

}  // namespace

std::pair<Rational, Rational> bracket_integral(const std::vector<Integer>& x, const std::vector<Integer>& y) {
  // The scaled coefficients (number k times C(2n-1, k)) of X Y' - Y X', degree 2n - 1.
  const int n = static_cast<int>(x.size()) - 1;
  std::vector<Integer> scaled(2 * x.size() - 2, 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j + 1 < x.size(); ++j) {
      const Integer products = x[i] * (y[j + 1] - y[j]) - y[i] * (x[j + 1] - x[j]);
      scaled[i + j] += products * binomial(n, static_cast<int>(i)) * binomial(n - 1, static_cast<int>(j)) * n;
    }
  }
  // The integral over [0, 1] is the mean of the Bernstein coefficients.
  const int degree = static_cast<int>(scaled.size()) - 1;
  Rational positive = 0, negative = 0;
  for (int k = 0; k <= degree; ++k) {
    const Integer& value = scaled[static_cast<std::size_t>(k)];
    (value.sign() > 0 ? positive : negative) += Rational(value, binomial(degree, k));
  }
  return {positive / (degree + 1), negative / (degree + 1)};
}

AreaBounds area_beside(DyadicCurve& curve, int halvings) {
  const CurveNet<Integer>& net = curve.exact(DyadicCurve::whole);
  if (!is_polynomial(net)) return pieces_share(curve, DyadicCurve::whole, halvings);
  const Rational area = polynomial_share(net);
  return {area, area};
}

}  // namespace bezcert
