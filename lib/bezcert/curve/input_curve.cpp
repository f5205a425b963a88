#include "bezcert/curve/input_curve.hpp"

#include "bezcert/number/scaled.hpp"

namespace bezcert {

CurveNet<Integer> InputCurve::exact() const {
  std::vector<Rational> all;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Rational w = weights.empty() ? Rational(1) : weights[i];
    for (const Rational& value : {Rational(x[i] * w), Rational(y[i] * w), w}) all.push_back(value);
  }
  const std::vector<Integer> integers = scaled_integers(all).values;
  CurveNet<Integer> net;
  for (std::size_t i = 0; i < integers.size(); i += 3) {
    net.x.push_back(integers[i]);
    net.y.push_back(integers[i + 1]);
    net.w.push_back(integers[i + 2]);
  }
  return net;
}

}  // namespace bezcert
