// A rational Bezier curve and its dyadic pieces, in intervals first and in exact integers when asked.
//
// Homogeneous control points (X, Y, W), W > 0. Halving integers multiplies all three coordinates of a piece
// by one power of two, which changes no point. A geometric predicate is written once over the number type T
// with `sign_of`; `filtered` runs it on intervals and, if any sign is uncertain, again on integers
// (number/filtered_sign.hpp).
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/number/filtered_sign.hpp"

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace bezcert {

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

  /// Whether there is an interval form.
  Filter filter() const { return nodes_[whole].interval ? Filter::on : Filter::off; }
  /// Precondition: filter() == Filter::on.
  const CurveNet<Interval>& interval(const RoundUp&, Piece piece);
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

/// The exact answer of predicate(net of a, net of b) for pieces of two curves.
template <class Predicate>
bool filtered(DyadicCurve& a, DyadicCurve::Piece piece_a, DyadicCurve& b, DyadicCurve::Piece piece_b,
              Predicate predicate) {
  return filtered(
      a.filter() == Filter::on ? b.filter() : Filter::off, predicate,
      [&](const RoundUp& up) { return std::tie(a.interval(up, piece_a), b.interval(up, piece_b)); },
      [&] { return std::tie(a.exact(piece_a), b.exact(piece_b)); });
}

}  // namespace bezcert
