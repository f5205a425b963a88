#include "bezcert/curve/winding.hpp"

#include "bezcert/curve/separation.hpp"

namespace bezcert {
namespace {

template <class T>
struct HomogeneousPoint {
  T x, y, w;
};

template <class T>
Vector2<T> from_point(const HomogeneousPoint<T>& p, const CurveNet<T>& net, std::size_t i) {
  return {net.x[i] * p.w - p.x * net.w[i], net.y[i] * p.w - p.y * net.w[i]};
}

template <class T>
bool is_outside_hull(const HomogeneousPoint<T>& p, const CurveNet<T>& net) {
  std::vector<Vector2<T>> vectors;
  for (std::size_t i = 0; i < net.size(); ++i) vectors.push_back(from_point(p, net, i));
  return in_open_half_plane(vectors);
}

// The chord's crossing of the ray.
template <class T>
int crossing(const HomogeneousPoint<T>& p, const CurveNet<T>& net) {
  const Vector2<T> a = from_point(p, net, 0);
  const Vector2<T> b = from_point(p, net, net.size() - 1);
  const bool a_above = sign_of(a.y) > 0, b_above = sign_of(b.y) > 0;
  if (a_above == b_above) return 0;
  const int turn = sign_of(cross(a, b));
  if (b_above) return turn > 0 ? 1 : 0;
  return turn < 0 ? -1 : 0;
}

// All control points are above the ray's line, or none is, or all are left of the point: no crossing, however
// the piece runs. (On the line counts as below.)
template <class T>
bool misses_ray(const HomogeneousPoint<T>& p, const CurveNet<T>& net) {
  bool above = true, not_above = true, left = true;
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Vector2<T> v = from_point(p, net, i);
    if (sign_of(v.y) > 0) {
      not_above = false;
    } else {
      above = false;
    }
    left = left && sign_of(v.x) < 0;
  }
  return above || not_above || left;
}

struct Ray {
  HomogeneousPoint<Interval> interval;
  HomogeneousPoint<Integer> exact;
};

// The exact answer of predicate(point, net).
template <class Predicate>
auto filtered(DyadicCurve& curve, DyadicCurve::Piece piece, const Ray& ray, Predicate predicate) {
  return bezcert::filtered(
      curve.filter(), predicate,
      [&](const RoundUp& up) { return std::tie(ray.interval, curve.interval(up, piece)); },
      [&] { return std::tie(ray.exact, curve.exact(piece)); });
}

}  // namespace

std::optional<int> winding_share(DyadicCurve& curve, const Point& point, int depth) {
  const Integer w = lcm(Integer(denominator(point.x)), Integer(denominator(point.y)));
  const auto scaled = [&](const Rational& c) {
    return Integer(Integer(numerator(c)) * (w / denominator(c)));
  };
  const Ray ray{{to_interval(point.x), to_interval(point.y), Interval(1)},
                {scaled(point.x), scaled(point.y), w}};
  int sum = 0;
  std::vector<DyadicCurve::Piece> pieces = {DyadicCurve::whole};
  while (!pieces.empty()) {
    const DyadicCurve::Piece piece = pieces.back();
    pieces.pop_back();
    if (filtered(curve, piece, ray, [](const auto& p, const auto& net) { return misses_ray(p, net); }))
      continue;
    if (filtered(curve, piece, ray, [](const auto& p, const auto& net) { return is_outside_hull(p, net); })) {
      sum += filtered(curve, piece, ray, [](const auto& p, const auto& net) { return crossing(p, net); });
      continue;
    }
    if (curve.depth(piece) >= depth) return std::nullopt;
    const auto [first, second] = curve.halves(piece);
    pieces.push_back(first);
    pieces.push_back(second);
  }
  return sum;
}

std::optional<int> winding_number(std::span<DyadicCurve> chain, const Point& point, int depth) {
  int sum = 0;
  for (DyadicCurve& curve : chain) {
    const std::optional<int> share = winding_share(curve, point, depth);
    if (!share) return std::nullopt;
    sum += *share;
  }
  return sum;
}

// The winding number of a simple chain is 0 outside and its orientation inside. Points beside the middle of
// the first curve, nearer and nearer on both sides: one side is inside.
int orientation(std::span<DyadicCurve> chain) {
  constexpr int enough_halvings = 256;
  const CurveNet<Integer> half = chain[0].exact(chain[0].halves(DyadicCurve::whole).first);
  const std::size_t last = half.size() - 1;
  const Point middle{Rational(half.x[last], half.w[last]), Rational(half.y[last], half.w[last])};
  const Vector2<Integer> along = between(half, last - 1, half, last);
  const Rational scale(Integer(half.w[last - 1] * half.w[last]));
  for (Rational step(1, 2);; step /= 2) {
    for (const int side : {1, -1}) {
      const Rational factor = step * side / scale;
      const Point beside{middle.x - Rational(along.y) * factor, middle.y + Rational(along.x) * factor};
      const std::optional<int> winding = winding_number(chain, beside, enough_halvings);
      if (winding && *winding != 0) return *winding;
    }
  }
}

}  // namespace bezcert
