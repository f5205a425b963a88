// Proven bounds of det J on an element.
#pragma once

#include "bezcert/number/dyadic.hpp"

namespace bezcert {

/// min_lower <= min det J <= min_upper, max_lower <= max det J <= max_upper. The inner two are the extreme
/// values at corners of pieces; the outer two come from the extreme coefficients over the pieces. Rounded
/// outwards (number/dyadic.hpp).
struct DeterminantBounds {
  Dyadic min_lower, min_upper, max_lower, max_upper;
};

}  // namespace bezcert
