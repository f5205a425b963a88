// A point of the plane, exactly.
#pragma once

#include "bezcert/number/rational.hpp"

namespace bezcert {

struct Point {
  Rational x, y;

  bool operator==(const Point&) const = default;
};

}  // namespace bezcert
