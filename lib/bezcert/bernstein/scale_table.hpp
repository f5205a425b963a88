// Multinomials of a shape in both number forms, kept: the way between coefficients and scaled coefficients.
//
// Scaled coefficients (multinomial.hpp) times `cofactor` are Bernstein coefficients times `multiple`, the
// least common multiple of the multinomials: integers stay integers.
#pragma once

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/number/interval.hpp"

#include <type_traits>
#include <vector>

namespace bezcert {

struct ScaleTable {
  std::vector<Integer> multinomial;
  std::vector<Integer> cofactor;  ///< multiple / multinomial
  std::vector<Interval> multinomial_interval;
  std::vector<Interval> cofactor_interval;
  Integer multiple;

  template <class T>
  const std::vector<T>& multinomials_as() const {
    if constexpr (std::is_same_v<T, Interval>) {
      return multinomial_interval;
    } else {
      return multinomial;
    }
  }
  template <class T>
  const std::vector<T>& cofactors_as() const {
    if constexpr (std::is_same_v<T, Interval>) {
      return cofactor_interval;
    } else {
      return cofactor;
    }
  }
};

/// The table of a shape; built on first use.
const ScaleTable& scale_table(Shape shape);

/// Bernstein to scaled coefficients, for T = Interval or Integer.
template <class T>
void to_scaled(Polynomial<T>& f) {
  const std::vector<T>& factors = scale_table(f.shape).template multinomials_as<T>();
  for (std::size_t i = 0; i < factors.size(); ++i) f.coefficients[i] = f.coefficients[i] * factors[i];
}

/// Scaled to Bernstein coefficients times `multiple`.
template <class T>
void from_scaled(Polynomial<T>& f) {
  const std::vector<T>& factors = scale_table(f.shape).template cofactors_as<T>();
  for (std::size_t i = 0; i < factors.size(); ++i) f.coefficients[i] = f.coefficients[i] * factors[i];
}

}  // namespace bezcert
