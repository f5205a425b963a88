#include "bezcert/curve/input_curve.hpp"

#include "bezcert/number/scaled.hpp"

#include <stdexcept>

namespace bezcert {

void InputCurve::validate() const {
  if (x.size() < 2 || y.size() != x.size() || (!weights.empty() && weights.size() != x.size())) {
    throw std::invalid_argument(
        "a curve has " + std::to_string(x.size()) + " and " + std::to_string(y.size()) + " coordinates and " +
        std::to_string(weights.size()) + " weights: expected as many of each, at least two, or no weights");
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].sign() <= 0) throw std::invalid_argument("a curve has a weight that is not positive");
  }
}

CurveNet<Integer> InputCurve::exact() const {
  validate();
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
