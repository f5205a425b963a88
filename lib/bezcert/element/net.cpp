#include "bezcert/element/net.hpp"

#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace bezcert {
namespace {

// Nodal values to control points, multiplied by a positive integer. Returns the integer that X / W is
// multiplied by: of homogeneous coordinates all three are, and it cancels.
template <class T>
Integer to_bernstein(Net<T>& net) {
  const BasisChange& change = lagrange_to_bernstein(net.shape);
  for (std::vector<T>& values : net.coordinates) change_basis(change, values);
  change_basis(change, net.weights);
  return net.rational() ? Integer(1) : change.denominator;
}

template <class T>
void make_homogeneous(Net<T>& net) {
  for (std::vector<T>& values : net.coordinates) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] * net.weights[i];
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

// All coordinates one after the other, brought to one common factor.
ScaledIntegers common_coordinates(std::span<const ExactVector> coordinates) {
  const bool binary64 = std::all_of(coordinates.begin(), coordinates.end(),
                                    [](const ExactVector& numbers) { return numbers.binary64(); });
  if (binary64) {
    std::vector<double> all;
    all.reserve(coordinates.size() * coordinates[0].size());
    for (const ExactVector& numbers : coordinates) {
      all.insert(all.end(), numbers.doubles().begin(), numbers.doubles().end());
    }
    return scaled_integers(all);
  }
  std::vector<Rational> all;
  for (const ExactVector& numbers : coordinates) {
    for (std::size_t i = 0; i < numbers.size(); ++i) all.push_back(numbers[i]);
  }
  return scaled_integers(all);
}

}  // namespace

IntervalNet interval_net(const RoundUp&, const Element& element) {
  IntervalNet result;
  Net<Interval>& net = result.net;
  net.shape = element.shape();
  double largest = 0;
  for (std::size_t k = 0; k < element.coordinates().size(); ++k) {
    net.coordinates[k] = relative_to_first(element.coordinates()[k]);
    largest = std::max(largest, largest_magnitude(net.coordinates[k]));
  }
  const double factor = normalizing_factor(largest);
  for (std::vector<Interval>& values : net.coordinates) multiply_all(values, factor);
  result.scale = Interval(1.0 / factor);  // a power of two: exact
  if (element.rational()) {
    net.weights.reserve(element.weights().size());
    for (std::size_t i = 0; i < element.weights().size(); ++i) {
      net.weights.push_back(interval_at(element.weights(), i));
    }
    multiply_all(net.weights, normalizing_factor(largest_magnitude(net.weights)));
    make_homogeneous(net);
  }
  if (element.basis() == Basis::lagrange) result.scale = result.scale / to_interval(to_bernstein(net));
  return result;
}

ExactNet exact_net(const Element& element) {
  ExactNet result;
  Net<Integer>& net = result.net;
  net.shape = element.shape();
  const ScaledIntegers common = common_coordinates(element.coordinates());
  auto next = common.values.begin();
  for (std::size_t k = 0; k < element.coordinates().size(); ++k) {
    const auto end = next + static_cast<std::ptrdiff_t>(element.coordinates()[k].size());
    result.first[k] = *next;
    net.coordinates[k].assign(next, end);
    for (Integer& value : net.coordinates[k]) value -= result.first[k];
    next = end;
  }
  result.scale = common.scale;
  if (element.rational()) {
    net.weights = element.weights().scaled().values;
    make_homogeneous(net);
  }
  if (element.basis() == Basis::lagrange) {
    const Integer divisor = to_bernstein(net);
    result.scale /= Rational(divisor);
    for (Integer& value : result.first) value *= divisor;
  }
  return result;
}

}  // namespace bezcert
