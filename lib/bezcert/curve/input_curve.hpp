// A curve of the domain that a mesh is to conform to: a rational Bezier curve given exactly.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "bezcert/number/exact_vector.hpp"

#include <cstdint>
#include <string>

namespace bezcert {

struct InputCurve {
  ExactVector x, y;     ///< its control points, at least two
  ExactVector weights;  ///< positive, one a point; empty: all equal
  std::string name;     ///< may be empty
  std::uint32_t line = 0;

  /// Throws std::invalid_argument if there are fewer than two points, counts do not fit, or a weight is not
  /// positive.
  void validate() const;

  /// Its homogeneous control points, with X / W and Y / W the true coordinates, times a positive factor.
  /// Throws as validate() does.
  CurveNet<Integer> exact() const;
};

}  // namespace bezcert
