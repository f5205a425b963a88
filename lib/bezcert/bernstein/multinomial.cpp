#include "bezcert/bernstein/multinomial.hpp"

namespace bezcert {

Integer binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  Integer result;
  mpz_bin_uiui(result.backend().data(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return result;
}

std::vector<Integer> multinomials(Shape shape) {
  std::vector<Integer> result = {Integer(1)};
  for (int f = 0; f < shape.factor_count(); ++f) {
    const std::vector<Integer> before = std::move(result);
    result.clear();
    for_each_simplex_point(shape.domain.simplex(f), shape.degree(f), [&](const SimplexPoint& at) {
      Integer multinomial = 1;
      int rest = shape.degree(f);
      for (const int exponent : at.exponents) {
        multinomial *= binomial(rest, exponent);
        rest -= exponent;
      }
      for (const Integer& other : before) result.push_back(multinomial * other);
    });
  }
  return result;
}

}  // namespace bezcert
