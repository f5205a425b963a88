// What the search for a contact of two curves may take, in units that do not depend on the machine.
#pragma once

#include <cstddef>

namespace bezcert {

/// What algebra may take by default: some 10 s at the worst for elements up to degree 7.
inline constexpr std::size_t default_algebra_bits = std::size_t{4095} << 13;

struct ContactBudget {
  /// Pairs of pieces compared before algebra is asked.
  std::size_t pairs = 2048;
  /// Halvings of a curve for one piece.
  int depth = 64;
  /// The largest resultant that algebra is asked about: degree times bits of a coefficient.
  std::size_t algebra_bits = default_algebra_bits;
};

}  // namespace bezcert
