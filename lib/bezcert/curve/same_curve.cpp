#include "bezcert/curve/same_curve.hpp"

#include "bezcert/algebra/univariate.hpp"
#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>
#include <array>

namespace bezcert {
namespace {

using Triple = std::array<Integer, 3>;

bool is_zero(const Triple& p) {
  return std::all_of(p.begin(), p.end(), [](const Integer& c) { return c.is_zero(); });
}

// The Bernstein coefficients of (X, Y, W), divided by their common factor, of the true degree d and times
// C(d, i). W > 0 at the first.
std::vector<Triple> reduced(const CurveNet<Integer>& net) {
  std::array<Univariate, 3> f = {from_bernstein(net.x), from_bernstein(net.y), from_bernstein(net.w)};
  const Univariate divisor = gcd(f[0], gcd(f[1], f[2]));
  int degree = 0;
  for (Univariate& one : f) {
    if (divisor.degree() > 0) one = exact_quotient(one, divisor);
    degree = std::max(degree, one.degree());
  }
  // t^k = t^k (1 - t + t)^(d-k): the coefficient of t^i (1-t)^(d-i) is C(d-k, i-k).
  std::vector<Triple> result(static_cast<std::size_t>(degree) + 1, Triple{0, 0, 0});
  for (std::size_t r = 0; r < 3; ++r) {
    for (int k = 0; k <= f[r].degree(); ++k) {
      for (int i = k; i <= degree; ++i) {
        result[static_cast<std::size_t>(i)][r] +=
            binomial(degree - k, i - k) * f[r].coefficients[static_cast<std::size_t>(k)];
      }
    }
  }
  if (result[0][2].sign() < 0) {
    for (Triple& p : result) {
      for (Integer& c : p) c = -c;
    }
  }
  return result;
}

// q = ratio * p. Precondition: p is not zero. Nothing if q is not a positive multiple.
std::optional<Rational> positive_ratio(const Triple& p, const Triple& q) {
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = r + 1; s < 3; ++s) {
      if (p[r] * q[s] != p[s] * q[r]) return std::nullopt;
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    if (p[r].is_zero()) continue;
    Rational ratio(q[r], p[r]);
    if (ratio.sign() <= 0) return std::nullopt;
    return ratio;
  }
  return std::nullopt;
}

}  // namespace

bool same_curve(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  if (a.x == b.x && a.y == b.y && a.w == b.w) return true;
  const std::vector<Triple> p = reduced(a), q = reduced(b);
  if (p.size() != q.size()) return false;
  // q_i = lambda rho^i p_i for all i. W > 0 at both ends, so the first and the last are not zero.
  std::optional<Rational> scale, step;
  int step_index = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (is_zero(p[i]) != is_zero(q[i])) return false;
    if (is_zero(p[i])) continue;
    std::optional<Rational> ratio = positive_ratio(p[i], q[i]);
    if (!ratio) return false;
    if (!scale) {
      scale = ratio;
      continue;
    }
    *ratio /= *scale;
    if (!step) {
      step = ratio;
      step_index = static_cast<int>(i);
    } else if (power(*ratio, step_index) != power(*step, static_cast<int>(i))) {
      return false;
    }
  }
  return true;
}

}  // namespace bezcert
