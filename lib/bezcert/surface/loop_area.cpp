#include "bezcert/surface/loop_area.hpp"

#include "bezcert/curve/winding.hpp"
#include "bezcert/surface/polynomial_area.hpp"

#include <algorithm>

namespace bezcert {
namespace {

bool is_narrow(const AreaBounds& area) {
  if (area.lower.sign() * area.upper.sign() <= 0) return false;
  const Rational smaller = std::min(abs(area.lower), abs(area.upper));
  return (area.upper - area.lower) * 1024 <= smaller;
}

}  // namespace

std::optional<LoopArea> plain_loop_area(const HalfEdges& edges, const BoundaryLoop& loop) {
  constexpr std::size_t few = 16;
  const auto is_plain = [&](HalfEdge h) { return edges.nodes(h).size() <= few && has_plain_area(edges, h); };
  if (!std::all_of(loop.edges.begin(), loop.edges.end(), is_plain)) return std::nullopt;
  const Rational area = plain_area(edges, loop.edges);
  return LoopArea{{area, area}, area.sign()};
}

LoopArea loop_area(const HalfEdges& edges, const BoundaryLoop& loop) {
  if (const auto plain = plain_loop_area(edges, loop)) return *plain;
  constexpr int deepest = 8;
  AreaBounds polynomial;
  std::vector<DyadicCurve> rational;
  std::vector<HalfEdge> plain;
  for (const HalfEdge h : loop.edges) {
    if (has_plain_area(edges, h)) {
      plain.push_back(h);
      continue;
    }
    DyadicCurve curve(std::nullopt, edges.exact(h));
    if (is_polynomial(curve.exact(DyadicCurve::whole))) {
      polynomial += area_beside(curve, 0);
    } else {
      rational.push_back(std::move(curve));
    }
  }
  const Rational area_of_plain = plain_area(edges, plain);
  polynomial += {area_of_plain, area_of_plain};
  if (rational.empty()) return {polynomial, polynomial.lower.sign()};
  AreaBounds sum;
  for (int depth = 2; depth <= deepest; ++depth) {
    sum = polynomial;
    for (DyadicCurve& curve : rational) sum += area_beside(curve, depth);
    if (is_narrow(sum)) return {sum, sum.lower.sign()};
  }
  if (sum.lower.sign() * sum.upper.sign() > 0) return {sum, sum.lower.sign()};
  std::vector<DyadicCurve> chain;
  for (const HalfEdge h : loop.edges) chain.push_back(edges.curve(h));
  const int side = orientation(chain);
  if (side > 0) sum.lower = 0;
  if (side < 0) sum.upper = 0;
  return {sum, side};
}

}  // namespace bezcert
