// Polynomials in the power basis u^a v^b: another form of the same functions, in which the derivative is
// plain. On the triangle (xi_0, xi_1, xi_2) = (1-u-v, u, v); on the segment t = u.
#pragma once

#include "bernstein/explicit_sum.hpp"

#include <map>
#include <utility>

namespace bezcert::test {

using PowerForm = std::map<std::pair<int, int>, Rational>;

inline PowerForm times(const PowerForm& f, const PowerForm& g) {
  PowerForm result;
  for (const auto& [m, a] : f) {
    for (const auto& [n, b] : g) result[{m.first + n.first, m.second + n.second}] += a * b;
  }
  return result;
}

inline PowerForm to_power(const PowerForm& base, int exponent) {
  PowerForm result{{{0, 0}, Rational(1)}};
  for (int k = 0; k < exponent; ++k) result = times(result, base);
  return result;
}

inline PowerForm power_form(const Polynomial<Rational>& f) {
  const PowerForm u{{{1, 0}, Rational(1)}};
  const PowerForm v{{{0, 1}, Rational(1)}};
  const PowerForm one_minus_u{{{0, 0}, Rational(1)}, {{1, 0}, Rational(-1)}};
  const PowerForm one_minus_v{{{0, 0}, Rational(1)}, {{0, 1}, Rational(-1)}};
  const PowerForm first{{{0, 0}, Rational(1)}, {{1, 0}, Rational(-1)}, {{0, 1}, Rational(-1)}};
  const int p = f.shape.degree(0);
  const int q = f.shape.degree(1);
  PowerForm sum;
  for (int r = 0; r < row_count(f.shape); ++r) {
    for (int c = 0; c < column_count(f.shape, r); ++c) {
      PowerForm term{{{0, 0}, f.at(r, c)}};
      Integer factor;
      if (f.shape.domain == Domain::triangle) {
        factor = factorial(p) / (factorial(p - r - c) * factorial(c) * factorial(r));
        term = times(times(term, to_power(first, p - r - c)), times(to_power(u, c), to_power(v, r)));
      } else {
        factor = choose(p, c) * choose(q, r);
        term = times(times(term, to_power(one_minus_u, p - c)), to_power(u, c));
        term = times(times(term, to_power(one_minus_v, q - r)), to_power(v, r));
      }
      for (const auto& [m, a] : term) sum[m] += Rational(factor) * a;
    }
  }
  return sum;
}

/// The derivative with respect to u (0) or v (1).
inline PowerForm derivative(const PowerForm& f, int variable) {
  PowerForm result;
  for (const auto& [m, a] : f) {
    const auto [i, j] = m;
    if (variable == 0 && i > 0) result[{i - 1, j}] += i * a;
    if (variable == 1 && j > 0) result[{i, j - 1}] += j * a;
  }
  return result;
}

/// The value at a parameter of the domain's form.
inline Rational value(const PowerForm& f, Domain domain, const std::vector<Rational>& at) {
  const Rational u = domain == Domain::triangle ? at[1] : at[0];
  const Rational v = domain == Domain::triangle ? at[2] : domain == Domain::square ? at[1] : Rational(0);
  Rational sum = 0;
  for (const auto& [m, a] : f) sum += a * powers(u, m.first).back() * powers(v, m.second).back();
  return sum;
}

}  // namespace bezcert::test
