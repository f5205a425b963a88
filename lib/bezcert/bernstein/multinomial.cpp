#include "bezcert/bernstein/multinomial.hpp"

namespace bezcert {

Integer binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  Integer result;
  mpz_bin_uiui(result.backend().data(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

std::vector<Integer> multinomials(Shape shape) {
  std::vector<Integer> result;
  result.reserve(coefficient_count(shape));
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      if (shape.domain == Domain::triangle) {
        result.push_back(binomial(shape.p, r) * binomial(shape.p - r, c));
      } else {
        result.push_back(binomial(shape.q, r) * binomial(shape.p, c));
      }
    }
  }
  return result;
}

}  // namespace bezcert
