#include "bezcert/mesh/loop_area.hpp"

#include "bezcert/curve/separation.hpp"
#include "bezcert/curve/winding.hpp"
#include "bezcert/mesh/polynomial_area.hpp"

#include <algorithm>

namespace bezcert {
namespace {

AreaBounds& operator+=(AreaBounds& sum, const AreaBounds& share) {
  sum.lower += share.lower;
  sum.upper += share.upper;
  return sum;
}

bool is_polynomial(const CurveNet<Integer>& net) {
  return std::all_of(net.w.begin(), net.w.end(), [&](const Integer& w) { return w == net.w[0]; });
}

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

AreaBounds share(DyadicCurve& curve, DyadicCurve::Piece piece, int depth) {
  if (depth == 0) return piece_share(curve.exact(piece));
  const auto [first, second] = curve.halves(piece);
  AreaBounds sum = share(curve, first, depth - 1);
  return sum += share(curve, second, depth - 1);
}

bool is_narrow(const AreaBounds& area) {
  if (area.lower.sign() * area.upper.sign() <= 0) return false;
  const Rational smaller = std::min(abs(area.lower), abs(area.upper));
  return (area.upper - area.lower) * 1024 <= smaller;
}

// The winding number of a simple chain is 0 outside and its orientation inside. Points beside the middle of
// the first edge, nearer and nearer on both sides: one side is inside.
int orientation_by_winding(const MeshEdges& edges, const BoundaryLoop& loop) {
  constexpr int enough_halvings = 256;
  std::vector<DyadicCurve> curves;
  for (const EdgeUse use : loop.uses) curves.push_back(edges.curve(use));
  const CurveNet<Integer> half = curves[0].exact(curves[0].halves(DyadicCurve::whole).first);
  const std::size_t last = half.size() - 1;
  const Point middle{Rational(half.x[last], half.w[last]), Rational(half.y[last], half.w[last])};
  const Vector2<Integer> along = between(half, last - 1, half, last);
  const Rational scale(Integer(half.w[last - 1] * half.w[last]));
  for (Rational step(1, 2);; step /= 2) {
    for (const int side : {1, -1}) {
      const Rational factor = step * side / scale;
      const Point beside{middle.x - Rational(along.y) * factor, middle.y + Rational(along.x) * factor};
      std::optional<int> winding = 0;
      for (DyadicCurve& curve : curves) {
        const std::optional<int> share = winding_share(curve, beside, enough_halvings);
        if (!share) winding.reset();
        if (!winding) break;
        *winding += *share;
      }
      if (winding && *winding != 0) return *winding;
    }
  }
}

}  // namespace

std::optional<LoopArea> plain_loop_area(const MeshEdges& edges, const BoundaryLoop& loop) {
  constexpr std::size_t few = 16;
  const auto is_plain = [&](EdgeUse use) {
    return edges.nodes(use).size() <= few && has_plain_area(edges, use);
  };
  if (!std::all_of(loop.uses.begin(), loop.uses.end(), is_plain)) return std::nullopt;
  const Rational area = plain_area(edges, loop.uses);
  return LoopArea{{area, area}, area.sign()};
}

LoopArea loop_area(const MeshEdges& edges, const BoundaryLoop& loop) {
  if (const auto plain = plain_loop_area(edges, loop)) return *plain;
  constexpr int deepest = 8;
  AreaBounds polynomial;
  std::vector<DyadicCurve> rational;
  std::vector<EdgeUse> plain;
  for (const EdgeUse use : loop.uses) {
    if (has_plain_area(edges, use)) {
      plain.push_back(use);
      continue;
    }
    CurveNet<Integer> net = edges.exact(use);
    if (is_polynomial(net)) {
      const Rational area = polynomial_share(net);
      polynomial += {area, area};
    } else {
      rational.emplace_back(std::nullopt, std::move(net));
    }
  }
  const Rational area_of_plain = plain_area(edges, plain);
  polynomial += {area_of_plain, area_of_plain};
  if (rational.empty()) return {polynomial, polynomial.lower.sign()};
  AreaBounds sum;
  for (int depth = 2; depth <= deepest; ++depth) {
    sum = polynomial;
    for (DyadicCurve& curve : rational) sum += share(curve, DyadicCurve::whole, depth);
    if (is_narrow(sum)) return {sum, sum.lower.sign()};
  }
  if (sum.lower.sign() * sum.upper.sign() > 0) return {sum, sum.lower.sign()};
  const int orientation = orientation_by_winding(edges, loop);
  if (orientation > 0) sum.lower = 0;
  if (orientation < 0) sum.upper = 0;
  return {sum, orientation};
}

}  // namespace bezcert
