// A point of the parameter plane whose coordinates are real algebraic numbers.
#pragma once

#include "bezcert/algebra/real_root.hpp"

namespace bezcert {

/// A point (u, v) with algebraic coordinates. A coordinate's polynomial is empty where only the interval is
/// known.
struct PlanarPoint {
  RealRoot u, v;

  bool is_rational() const { return u.is_rational() && v.is_rational(); }
};

}  // namespace bezcert
