#include "bezcert/curve/branches.hpp"

#include "bezcert/algebra/univariate.hpp"
#include "bezcert/curve/separation.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// A power series up to some order.
using Series = std::vector<Rational>;

Series series_of(const std::vector<Integer>& bernstein, std::size_t count) {
  const Univariate f = from_bernstein(bernstein);
  Series result(count, Rational(0));
  for (std::size_t k = 0; k < std::min(count, f.coefficients.size()); ++k)
    result[k] = Rational(f.coefficients[k]);
  return result;
}

Series product(const Series& f, const Series& g) {
  Series result(f.size(), Rational(0));
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f[i].sign() == 0) continue;
    for (std::size_t j = 0; i + j < f.size(); ++j) result[i + j] += f[i] * g[j];
  }
  return result;
}

// f / g. Precondition: g[0] is not 0.
Series quotient(Series f, const Series& g) {
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] /= g[0];
    for (std::size_t j = 1; i + j < f.size(); ++j) f[i + j] -= f[i] * g[j];
  }
  return f;
}

// The coefficients c_2, c_3, ... of y over x one after another: y - c_2 x^2 - ... starts with ever higher
// powers.
class Branch {
 public:
  Branch(const CurveNet<Integer>& net, const Vector2<Integer>& along, std::size_t count) {
    std::vector<Integer> x, y;
    for (std::size_t i = 0; i < net.size(); ++i) {
      const Vector2<Integer> v = between(net, 0, net, i);
      x.push_back(dot(along, v));
      y.push_back(cross(along, v));
    }
    // `between` has the factor W_0 more, which is part of the scale of both axes: give it to W as well.
    std::vector<Integer> w = net.w;
    for (Integer& value : w) value *= net.w[0];
    const Series weight = series_of(w, count);
    x_ = quotient(series_of(x, count), weight);
    rest_ = quotient(series_of(y, count), weight);
    power_ = x_;
  }

  Rational next() {
    ++order_;
    power_ = product(power_, x_);
    const Rational c = rest_[order_] / power_[order_];
    for (std::size_t i = order_; i < rest_.size(); ++i) rest_[i] -= c * power_[i];
    return c;
  }

 private:
  Series x_, rest_, power_;
  std::size_t order_ = 1;
};

}  // namespace

int compare_branches(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  const Vector2<Integer> along = between(a, 0, a, 1);
  const std::size_t bound = (a.size() - 1) * (b.size() - 1);
  // Few terms decide nearly always: try with short series first.
  for (std::size_t order = std::min<std::size_t>(bound, 4);; order = std::min(bound, 4 * order)) {
    Branch first(a, along, order + 1), second(b, along, order + 1);
    for (std::size_t k = 2; k <= order; ++k) {
      const int difference = Rational(second.next() - first.next()).sign();
      if (difference != 0) return difference;
    }
    if (order == bound) return 0;
  }
}

}  // namespace bezcert
