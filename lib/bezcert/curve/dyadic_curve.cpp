#include "bezcert/curve/dyadic_curve.hpp"

#include "bezcert/bernstein/halve.hpp"

#include <stdexcept>
#include <utility>

namespace bezcert {
namespace {

template <class T>
std::pair<CurveNet<T>, CurveNet<T>> halve(const CurveNet<T>& net) {
  auto [xl, xr] = bezcert::halve(net.x);
  auto [yl, yr] = bezcert::halve(net.y);
  auto [wl, wr] = bezcert::halve(net.w);
  return {{std::move(xl), std::move(yl), std::move(wl)}, {std::move(xr), std::move(yr), std::move(wr)}};
}

}  // namespace

DyadicCurve::DyadicCurve(std::optional<CurveNet<Interval>> interval, CurveNet<Integer> exact) {
  if (exact.size() < 2) throw std::invalid_argument("DyadicCurve: at least two control points");
  Node root;
  root.interval = std::move(interval);
  root.exact = std::move(exact);
  nodes_.push_back(std::move(root));
}

DyadicCurve::DyadicCurve(CurveNet<Interval> interval, std::function<CurveNet<Integer>()> make_exact)
    : make_exact_(std::move(make_exact)) {
  if (interval.size() < 2) throw std::invalid_argument("DyadicCurve: at least two control points");
  nodes_.emplace_back().interval = std::move(interval);
}

Rational DyadicCurve::lower(Piece piece) const {
  return Rational(nodes_[piece].position) * power_of_two(-nodes_[piece].depth);
}

Rational DyadicCurve::upper(Piece piece) const {
  return Rational(Integer(nodes_[piece].position + 1)) * power_of_two(-nodes_[piece].depth);
}

std::pair<DyadicCurve::Piece, DyadicCurve::Piece> DyadicCurve::halves(Piece piece) {
  if (nodes_[piece].first_half == 0) {
    nodes_[piece].first_half = nodes_.size();
    for (const int second : {0, 1}) {
      Node child;
      child.parent = piece;
      child.depth = nodes_[piece].depth + 1;
      child.position = nodes_[piece].position * 2 + second;
      nodes_.push_back(std::move(child));
    }
  }
  return {nodes_[piece].first_half, nodes_[piece].first_half + 1};
}

template <class T>
const CurveNet<T>& DyadicCurve::net(std::optional<CurveNet<T>> Node::*form, Piece piece) {
  Node& node = nodes_[piece];
  if (!(node.*form)) {
    auto [first, second] = halve(net(form, node.parent));
    const Piece at = nodes_[node.parent].first_half;
    nodes_[at].*form = std::move(first);
    nodes_[at + 1].*form = std::move(second);
  }
  return *(node.*form);
}

const CurveNet<Interval>& DyadicCurve::interval(const RoundUp&, Piece piece) {
  return net(&Node::interval, piece);
}
const CurveNet<Integer>& DyadicCurve::exact(Piece piece) {
  if (!nodes_[whole].exact) nodes_[whole].exact = make_exact_();
  return net(&Node::exact, piece);
}

}  // namespace bezcert
