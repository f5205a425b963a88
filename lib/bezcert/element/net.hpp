// The homogeneous Bezier control net of an element in a number form: intervals, or integers over a scale.
//
// Coordinates are taken relative to the first point and brought to size about 1 by a power of two (intervals)
// or to a common factor (integers): the sign of every determinant of the net stays the same, and
//   x_true - x_first = scale * X / W   (W = 1 where the element is polynomial).
#pragma once

#include "bezcert/element/element.hpp"
#include "bezcert/number/interval.hpp"

#include <array>
#include <vector>

namespace bezcert {

/// Control points (X, Y, ..., W) in coefficient order, one list a coordinate; `weights` is empty where the
/// element is polynomial, and then (X, Y, ...) are cartesian. Otherwise X = W x, Y = W y, ...
template <class T>
struct Net {
  Shape shape;
  std::array<std::vector<T>, max_dimension> coordinates;
  std::vector<T> weights;

  bool rational() const { return !weights.empty(); }
};

struct IntervalNet {
  Net<Interval> net;
  Interval scale;
};

struct ExactNet {
  Net<Integer> net;
  std::array<Integer, max_dimension> first;  ///< x_first = scale * first
  Rational scale;
};

/// Intervals that contain the net.
IntervalNet interval_net(const RoundUp&, const Element& element);

/// The net itself.
ExactNet exact_net(const Element& element);

}  // namespace bezcert
