// Curves by polynomials in powers of the parameter, which know nothing of control points but how they are
// defined.
#pragma once

#include "bezcert/curve/curve_net.hpp"
#include "random_input.hpp"
#include "rational_polynomial.hpp"

namespace bezcert::test {

/// The curve (x / w, y / w).
struct PowerForm {
  RationalPolynomial x, y, w;

  Point operator()(const Rational& t) const { return {x(t) / w(t), y(t) / w(t)}; }
};

inline RationalPolynomial power(const RationalPolynomial& f, std::size_t n) {
  RationalPolynomial result({Rational(1)});
  for (std::size_t k = 0; k < n; ++k) result = result * f;
  return result;
}

/// The sum of C(n, i) t^i (1 - t)^(n - i) times each coefficient.
inline PowerForm power_form(const CurveNet<Integer>& net) {
  const std::size_t n = net.size() - 1;
  const RationalPolynomial t({Rational(0), Rational(1)}), rest({Rational(1), Rational(-1)});
  PowerForm result;
  Rational choose = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    const RationalPolynomial basis = choose * (power(t, i) * power(rest, n - i));
    result.x = result.x + Rational(net.x[i]) * basis;
    result.y = result.y + Rational(net.y[i]) * basis;
    result.w = result.w + Rational(net.w[i]) * basis;
    choose *= Rational(static_cast<long>(n - i), static_cast<long>(i + 1));
  }
  return result;
}

/// Control points at random places, weights from 1/1000 to 1000, all times one factor.
inline CurveNet<Integer> random_curve(Random& random, int degree) {
  CurveNet<Integer> net;
  for (int i = 0; i <= degree; ++i) {
    const Integer w =
        random.chance(50) ? Integer(random.integer(1, 1000)) : 1000 * Integer(random.integer(1, 1000));
    net.x.push_back(w * random.integer(-99, 99));
    net.y.push_back(w * random.integer(-99, 99));
    net.w.push_back(w);
  }
  return net;
}

}  // namespace bezcert::test
