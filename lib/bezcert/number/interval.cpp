#include "bezcert/number/interval.hpp"

#include <mpfr.h>

namespace bezcert {
namespace {

Interval bounds_of(mpq_srcptr value) {
  // 53 bits as in a double. MPFR's exponent range is wider: mpfr_get_d rounds once more in the same
  // direction where the value is subnormal or too large, which keeps the enclosure.
  mpfr_t bound;
  mpfr_init2(bound, 53);
  mpfr_set_q(bound, value, MPFR_RNDD);
  const double lower = mpfr_get_d(bound, MPFR_RNDD);
  mpfr_set_q(bound, value, MPFR_RNDU);
  const double upper = mpfr_get_d(bound, MPFR_RNDU);
  mpfr_clear(bound);
  return {lower, upper};
}

}  // namespace

Interval to_interval(const Rational& value) { return bounds_of(value.backend().data()); }

Interval to_interval(const Integer& value) {
  if (mpz_sizeinbase(value.backend().data(), 2) <= 53) {
    return Interval(mpz_get_d(value.backend().data()));
  }
  return to_interval(Rational(value));
}

}  // namespace bezcert
