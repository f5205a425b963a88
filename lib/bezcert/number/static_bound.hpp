// Forward error bounds for all inputs at once, found by running the computation itself.
//
// A computation is written once over its number type T. With T = double (or eight of them) it computes; with
// T = StaticBound the same statements, in the same order, compute for every intermediate result a bound
//   |computed| <= magnitude  and  |computed - exact| <= error,
// valid for all inputs within the magnitudes it is started with. So the bound of each degree is derived by
// the program, and cannot disagree with the order of operations that the compiler sees. This is the one way
// in which an error bound is stated (filtered_sign.hpp).
//
// Rules. Let a, b be computed and A, B exact, |a| <= m, |a - A| <= e (b: n, f), and let one operation of
// doubles err by at most eps |result| + tiny, with eps = 2^-52: true for round to nearest (2^-53) and for the
// other rounding modes, and with or without subnormal numbers (tiny).
//   a + b, a - b:  |fl| <= m + n (rounding is monotone),  error <= e + f + eps (m + n) + tiny
//   a b:           |fl| <= m n,   |a b - A B| = |a (b - B) + B (a - A)| <= m f + (n + f) e,
//                  error <= m f + (n + f) e + eps m n + tiny
//   min, max, |.|: |min(a, b) - min(A, B)| <= max(e, f), as min is monotone in both and moves by at most what
//                  its arguments move; so are max and |.|.
//   a constant c that is the double next to a real number: magnitude |c|, error eps |c|.
// A fused multiply-add rounds once where these rules count two roundings, so they cover it too. The sums and
// products of the bounds themselves are rounded up, by taking the next double.
//
// Inputs are taken in units: the largest coordinate is 1. Results of degree k in the coordinates scale by the
// k-th power, the relative terms with them. tiny does not: an operation that underflows errs by at most
// 2^-1022, which in units is 2^-1022 / (unit of the result), at most tiny = 2^-600 if that unit is at least
// `least_unit`. Whoever uses a bound keeps to such units, and far enough from overflow.
#pragma once

#include <cmath>
#include <limits>

namespace bezcert {

struct StaticBound {
  double magnitude = 0;
  double error = 0;
};

namespace detail {

inline constexpr double eps = 0x1p-52;
inline constexpr double tiny = 0x1p-600;

// At least the exact value whose rounded value (in any mode) is x.
inline double up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
inline double sum_up(double a, double b) { return up(a + b); }
inline double product_up(double a, double b) { return a == 0 || b == 0 ? 0 : up(a * b); }

inline StaticBound rounded(double magnitude, double error) {
  return {magnitude, sum_up(sum_up(error, product_up(eps, magnitude)), tiny)};
}

}  // namespace detail

inline StaticBound operator+(const StaticBound& a, const StaticBound& b) {
  return detail::rounded(detail::sum_up(a.magnitude, b.magnitude), detail::sum_up(a.error, b.error));
}
inline StaticBound operator-(const StaticBound& a, const StaticBound& b) { return a + b; }
inline StaticBound operator*(const StaticBound& a, const StaticBound& b) {
  using namespace detail;
  return rounded(product_up(a.magnitude, b.magnitude),
                 sum_up(product_up(a.magnitude, b.error), product_up(sum_up(b.magnitude, b.error), a.error)));
}
/// A constant that is the double next to a real number.
inline StaticBound operator*(const StaticBound& a, double constant) {
  const double magnitude = std::abs(constant);
  return a * StaticBound{magnitude, detail::product_up(detail::eps, magnitude)};
}

inline StaticBound smaller(const StaticBound& a, const StaticBound& b) {
  return {std::fmax(a.magnitude, b.magnitude), std::fmax(a.error, b.error)};
}
inline StaticBound larger(const StaticBound& a, const StaticBound& b) { return smaller(a, b); }
inline StaticBound absolute(const StaticBound& a) { return a; }

/// The computed number taken as what is meant: later errors are counted from it.
inline StaticBound as_exact(const StaticBound& a) { return {a.magnitude, 0}; }

/// A difference of two doubles, at most 1 in size as computed.
inline StaticBound unit_difference() { return detail::rounded(1, 0); }

/// The smallest unit of a result for which bounds hold.
inline constexpr double least_unit = 0x1p-420;

/// The bound's error, with slack for what is done with it: the product with the unit of the actual inputs (a
/// few roundings), and the sum of a number and its bound (one rounding of at most eps (magnitude + error)
/// units).
inline double error_of(const StaticBound& bound) {
  using namespace detail;
  const double rounding = product_up(2 * eps, sum_up(bound.magnitude, bound.error));
  return product_up(sum_up(bound.error, rounding), 1 + 0x1p-40);
}

}  // namespace bezcert
