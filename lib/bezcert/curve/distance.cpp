#include "bezcert/curve/distance.hpp"

#include "bezcert/curve/dyadic_curve.hpp"

#include <algorithm>

namespace bezcert {
namespace {

constexpr int halvings = 6;

// The curve a - b: (X1 W2 - X2 W1, Y1 W2 - Y2 W1, W1 W2).
CurveNet<Integer> difference(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  const auto minus = [](std::vector<Integer> f, const std::vector<Integer>& g) {
    for (std::size_t k = 0; k < f.size(); ++k) f[k] -= g[k];
    return f;
  };
  return from_scaled({minus(scaled_product(a.x, b.w), scaled_product(a.w, b.x)),
                      minus(scaled_product(a.y, b.w), scaled_product(a.w, b.y)), scaled_product(a.w, b.w)});
}

// The square of the distance of control point k to the origin.
Rational square(const CurveNet<Integer>& net, std::size_t k) {
  return Rational(Integer(net.x[k] * net.x[k] + net.y[k] * net.y[k]), Integer(net.w[k] * net.w[k]));
}

// The pieces of a curve after the halvings, in order.
std::vector<DyadicCurve::Piece> pieces_of(DyadicCurve& curve) {
  std::vector<DyadicCurve::Piece> pieces = {DyadicCurve::whole};
  for (int depth = 0; depth < halvings; ++depth) {
    std::vector<DyadicCurve::Piece> finer;
    for (const DyadicCurve::Piece piece : pieces) {
      const auto [first, second] = curve.halves(piece);
      finer.push_back(first);
      finer.push_back(second);
    }
    pieces = std::move(finer);
  }
  return pieces;
}

// floor(sqrt(square) 2^shift) with enough bits for the grid of reports.
std::pair<Integer, long> root_bits(const Rational& square) {
  constexpr long bits = 128;
  const Integer above = numerator(square), below = denominator(square);
  const auto size = static_cast<long>(msb(above)) - static_cast<long>(msb(below));
  const long shift = (bits - size) / 2;
  const Integer scaled = floor(Rational(square * power_of_two(2 * shift)));
  return {sqrt(scaled), shift};
}

}  // namespace

Dyadic root_down(const Rational& square) {
  if (square.sign() <= 0) return {};
  const auto [root, shift] = root_bits(square);
  return round_down(Rational(Rational(root) * power_of_two(-shift)));
}

Dyadic root_up(const Rational& square) {
  if (square.sign() <= 0) return {};
  const auto [root, shift] = root_bits(square);
  return round_up(Rational(Rational(Integer(root + 1)) * power_of_two(-shift)));
}

DistanceBounds largest_distance(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  DyadicCurve apart(std::nullopt, difference(a, b));
  Rational lower = 0, upper = 0;
  for (const DyadicCurve::Piece piece : pieces_of(apart)) {
    const CurveNet<Integer>& net = apart.exact(piece);
    lower = std::max({lower, square(net, 0), square(net, net.size() - 1)});
    for (std::size_t k = 0; k < net.size(); ++k) upper = std::max(upper, square(net, k));
  }
  return {root_down(lower), root_up(upper)};
}

DistanceBounds distance_bounds(const CurveNet<Integer>& curve, const Point& point) {
  DyadicCurve halved(std::nullopt, curve);
  std::optional<Rational> nearest;
  for (const DyadicCurve::Piece piece : pieces_of(halved)) {
    const CurveNet<Integer>& net = halved.exact(piece);
    for (const std::size_t k : {std::size_t{0}, net.size() - 1}) {
      const Rational x = Rational(net.x[k], net.w[k]) - point.x, y = Rational(net.y[k], net.w[k]) - point.y;
      const Rational distance = x * x + y * y;
      if (!nearest || distance < *nearest) nearest = distance;
    }
  }
  return {Dyadic{}, root_up(*nearest)};
}

}  // namespace bezcert
