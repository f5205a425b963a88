// Exact numbers as integers over one common factor.
//
// The sign of a homogeneous expression needs no fractions: bring all numbers of an element to one common
// factor once (a power of two for doubles, the least common denominator otherwise) and go on in
// integers. Several times faster than any rational type, and the same code for dyadic and other input.
#pragma once

#include "bezcert/number/rational.hpp"

#include <span>
#include <vector>

namespace bezcert {

/// The i-th number is `values[i] * scale`; `scale` is positive.
struct ScaledIntegers {
  std::vector<Integer> values;
  Rational scale;
};

/// Brings finite doubles to the largest common power of two. Throws std::invalid_argument if one is not
/// finite.
ScaledIntegers scaled_integers(std::span<const double> numbers);

/// Brings rationals to their least common denominator.
ScaledIntegers scaled_integers(std::span<const Rational> numbers);

}  // namespace bezcert
