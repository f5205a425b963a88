// FLINT's C types as owners. Included by the sources of this folder only. FLINT computes with doubles in
// places and counts on rounding to nearest, which every polynomial that is handed to it checks.
#pragma once

#include "bezcert/algebra/univariate.hpp"
#include "bezcert/number/interval.hpp"

#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>

#include <stdexcept>

namespace bezcert {

/// What interval work would leave behind if algebra ran inside of it (number/interval.hpp says why it does
/// not) shows at once: throws std::logic_error unless the thread rounds to nearest.
inline void expect_rounding_to_nearest() {
  if (!rounds_to_nearest()) throw std::logic_error("algebra needs a thread that rounds to nearest");
}

inline void set(fmpz_t to, const Integer& from) { fmpz_set_mpz(to, from.backend().data()); }
inline Integer to_integer(const fmpz_t from) {
  Integer result;
  fmpz_get_mpz(result.backend().data(), from);
  return result;
}

struct FlintInteger {
  fmpz_t value;

  FlintInteger() { fmpz_init(value); }
  explicit FlintInteger(const Integer& from) : FlintInteger() { set(value, from); }
  ~FlintInteger() { fmpz_clear(value); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;
};

struct FlintPolynomial {
  fmpz_poly_t value;

  FlintPolynomial() { fmpz_poly_init(value); }
  explicit FlintPolynomial(const Univariate& f) : FlintPolynomial() {
    expect_rounding_to_nearest();
    for (std::size_t k = f.coefficients.size(); k-- > 0;) {
      const FlintInteger c(f.coefficients[k]);
      fmpz_poly_set_coeff_fmpz(value, static_cast<slong>(k), c.value);
    }
  }
  ~FlintPolynomial() { fmpz_poly_clear(value); }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
};

inline Univariate to_univariate(const fmpz_poly_t f) {
  Univariate result;
  for (slong k = 0; k < fmpz_poly_length(f); ++k) {
    result.coefficients.push_back(to_integer(fmpz_poly_get_coeff_ptr(f, k)));
  }
  return result;
}

}  // namespace bezcert
