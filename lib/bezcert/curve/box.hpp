// Rectangles that hold curves, and the pairs of them that overlap.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/number/interval.hpp"

#include <algorithm>
#include <functional>
#include <span>

namespace bezcert {

/// A closed rectangle that contains something.
struct Box {
  double x_low, x_high, y_low, y_high;

  bool overlaps(const Box& other) const {
    return x_low <= other.x_high && other.x_low <= x_high && y_low <= other.y_high && other.y_low <= y_high;
  }
  /// Grows to contain another.
  void add(const Box& other) {
    x_low = std::min(x_low, other.x_low);
    x_high = std::max(x_high, other.x_high);
    y_low = std::min(y_low, other.y_low);
    y_high = std::max(y_high, other.y_high);
  }
};

/// Contains the curve: the plane, if a number overflows.
Box box_of(const RoundUp&, const CurveNet<Interval>& net);

/// Calls visit(i, j), i < j, for every pair of boxes that overlap or touch, in an order that depends on the
/// boxes only; stops when it returns false.
void for_overlapping_boxes(std::span<const Box> boxes,
                           const std::function<bool(std::size_t, std::size_t)>& visit);

}  // namespace bezcert
