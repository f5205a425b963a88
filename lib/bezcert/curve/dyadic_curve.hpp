// A rational Bezier curve and its dyadic pieces, in intervals first and in exact integers when asked.
//
// Homogeneous control points (X, Y, W), W > 0. Halving integers multiplies all three coordinates of a piece
// by one power of two, which changes no point. A geometric predicate is written once over the number type T
// with `sign_of`; `filtered` runs it on intervals and, if any sign is uncertain, again on integers.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/number/interval.hpp"

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace bezcert {

/// Thrown by `sign_of` inside `filtered` when an interval holds numbers of several signs.
struct UncertainSign {};

inline int sign_of(const Interval& value) {
  if (const auto certain = certain_sign(value)) return *certain;
  throw UncertainSign{};
}
inline int sign_of(const Integer& value) { return value.sign(); }

/// A curve over [0, 1] with the binary tree of its halves.
class DyadicCurve {
 public:
  using Piece = std::size_t;
  static constexpr Piece whole = 0;

  /// Both forms of the same control points; without `interval` every predicate is exact.
  DyadicCurve(std::optional<CurveNet<Interval>> interval, CurveNet<Integer> exact);

  /// The same; the exact form is made when it is first asked for.
  DyadicCurve(CurveNet<Interval> interval, std::function<CurveNet<Integer>()> make_exact);

  int depth(Piece piece) const { return nodes_[piece].depth; }
  /// The parameters where the piece begins and ends.
  Rational lower(Piece piece) const;
  Rational upper(Piece piece) const;
  /// The first and the second half.
  std::pair<Piece, Piece> halves(Piece piece);

  bool has_interval() const { return nodes_[whole].interval.has_value(); }
  /// Needs a RoundingScope. Precondition: has_interval().
  const CurveNet<Interval>& interval(Piece piece);
  const CurveNet<Integer>& exact(Piece piece);

 private:
  struct Node {
    Piece parent = 0;
    int depth = 0;
    Integer position = 0;  // the piece is [position, position + 1] / 2^depth
    Piece first_half = 0;  // 0: not split
    std::optional<CurveNet<Interval>> interval;
    std::optional<CurveNet<Integer>> exact;
  };

  template <class T>
  const CurveNet<T>& net(std::optional<CurveNet<T>> Node::*form, Piece piece);

  std::deque<Node> nodes_;
  std::function<CurveNet<Integer>()> make_exact_;
};

/// predicate(net of a, net of b) for pieces of two curves, on intervals or else exactly.
template <class Predicate>
bool filtered(const RoundingScope&, DyadicCurve& a, DyadicCurve::Piece piece_a, DyadicCurve& b,
              DyadicCurve::Piece piece_b, Predicate predicate) {
  if (a.has_interval() && b.has_interval()) {
    try {
      return predicate(a.interval(piece_a), b.interval(piece_b));
    } catch (const UncertainSign&) {
    }
  }
  return predicate(a.exact(piece_a), b.exact(piece_b));
}

}  // namespace bezcert
