#include "bezcert/element/net.hpp"

#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <cmath>

namespace bezcert {
namespace {

// Nodal values to control points, multiplied by a positive integer. Returns the integer that X / W is
// multiplied by: of homogeneous coordinates all three are, and it cancels.
template <class T>
Integer to_bernstein(Net<T>& net) {
  const BasisChange& change = lagrange_to_bernstein(net.shape);
  change_basis(change, net.x);
  change_basis(change, net.y);
  change_basis(change, net.w);
  return net.rational() ? Integer(1) : change.denominator;
}

template <class T>
void make_homogeneous(Net<T>& net) {
  for (std::size_t i = 0; i < net.w.size(); ++i) {
    net.x[i] = net.x[i] * net.w[i];
    net.y[i] = net.y[i] * net.w[i];
  }
}

// 2^-k that brings numbers of size `largest` to about 1. Kept away from the ends of the exponent range,
// so that the factor and its inverse are doubles and the products of scaled numbers do not overflow.
double normalizing_factor(double largest) {
  if (largest == 0 || !std::isfinite(largest)) return 1;
  return std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
}

// The numbers minus the first, contained in intervals. Rationals are subtracted exactly first: they may be
// large and close together.
std::vector<Interval> relative_to_first(const ExactVector& numbers) {
  std::vector<Interval> result;
  result.reserve(numbers.size());
  if (numbers.binary64()) {
    const Interval first(numbers.doubles()[0]);
    for (const double number : numbers.doubles()) result.push_back(Interval(number) - first);
  } else {
    const Rational& first = numbers.rationals()[0];
    for (const Rational& number : numbers.rationals()) {
      result.push_back(to_interval(Rational(number - first)));
    }
  }
  return result;
}

double largest_magnitude(const std::vector<Interval>& numbers) {
  double largest = 0;
  for (const Interval& number : numbers) largest = std::max({largest, -number.inf(), number.sup()});
  return largest;
}

void multiply_all(std::vector<Interval>& numbers, double factor) {
  const Interval scale(factor);
  for (Interval& number : numbers) number = number * scale;
}

// x and y brought to one common factor, relative to the first point.
ScaledIntegers common_coordinates(const ExactVector& x, const ExactVector& y) {
  ScaledIntegers both;
  if (x.binary64() && y.binary64()) {
    std::vector<double> all(x.doubles().begin(), x.doubles().end());
    all.insert(all.end(), y.doubles().begin(), y.doubles().end());
    both = scaled_integers(all);
  } else {
    std::vector<Rational> all;
    for (std::size_t i = 0; i < x.size(); ++i) all.push_back(x[i]);
    for (std::size_t i = 0; i < y.size(); ++i) all.push_back(y[i]);
    both = scaled_integers(all);
  }
  const Integer first_x = both.values.front();
  const Integer first_y = both.values[x.size()];
  for (std::size_t i = 0; i < both.values.size(); ++i) {
    both.values[i] -= i < x.size() ? first_x : first_y;
  }
  return both;
}

}  // namespace

IntervalNet interval_net(const RoundUp&, const Element& element) {
  IntervalNet result;
  Net<Interval>& net = result.net;
  net.shape = element.shape();
  net.x = relative_to_first(element.x());
  net.y = relative_to_first(element.y());
  const double factor = normalizing_factor(std::max(largest_magnitude(net.x), largest_magnitude(net.y)));
  multiply_all(net.x, factor);
  multiply_all(net.y, factor);
  result.scale = Interval(1.0 / factor);  // a power of two: exact
  if (element.rational()) {
    net.w.reserve(element.weights().size());
    for (std::size_t i = 0; i < element.weights().size(); ++i) {
      net.w.push_back(interval_at(element.weights(), i));
    }
    multiply_all(net.w, normalizing_factor(largest_magnitude(net.w)));
    make_homogeneous(net);
  }
  if (element.basis() == Basis::lagrange) result.scale = result.scale / to_interval(to_bernstein(net));
  return result;
}

ExactNet exact_net(const Element& element) {
  ExactNet result;
  Net<Integer>& net = result.net;
  net.shape = element.shape();
  ScaledIntegers coordinates = common_coordinates(element.x(), element.y());
  const auto middle = coordinates.values.begin() + static_cast<std::ptrdiff_t>(element.x().size());
  net.x.assign(coordinates.values.begin(), middle);
  net.y.assign(middle, coordinates.values.end());
  result.scale = coordinates.scale;
  if (element.rational()) {
    net.w = element.weights().scaled().values;
    make_homogeneous(net);
  }
  if (element.basis() == Basis::lagrange) result.scale /= Rational(to_bernstein(net));
  return result;
}

}  // namespace bezcert
