#include "bezcert/element/element.hpp"

#include "bezcert/element/net.hpp"

#include <stdexcept>

namespace bezcert {
namespace {

bool all_equal(const ExactVector& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] != numbers[0]) return false;
  }
  return true;
}

}  // namespace

Element::Element(Shape shape, Basis basis, Coordinates coordinates, ExactVector weights)
    : shape_(shape), basis_(basis), coordinates_(std::move(coordinates)), weights_(std::move(weights)) {
  if (dimension() != 2) throw std::invalid_argument("an element is planar: no segment and no volume");
  for (int f = 0; f < shape_.factor_count(); ++f) {
    if (shape_.degree(f) < 1) throw std::invalid_argument("the degree must be at least 1");
  }
  if (basis_ != Basis::bernstein && basis_ != Basis::lagrange)
    throw std::invalid_argument("the basis is not known");
  if (degree() > max_degree) {
    throw std::invalid_argument("the degree must be at most " + std::to_string(max_degree));
  }
  const std::size_t count = coefficient_count(shape_);
  for (std::size_t k = 0; k < coordinates_.size(); ++k) {
    const std::size_t expected = k < static_cast<std::size_t>(dimension()) ? count : 0;
    if (coordinates_[k].size() == expected) continue;
    throw std::invalid_argument("a " + kind_name(*this) + " of degree " + degree_name(*this) + " has " +
                                std::to_string(expected) + " points, not " +
                                std::to_string(coordinates_[k].size()));
  }
  if (weights_.empty()) return;
  if (weights_.size() != count) {
    throw std::invalid_argument("a " + kind_name(*this) + " of degree " + degree_name(*this) + " has " +
                                std::to_string(count) + " weights, not " + std::to_string(weights_.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (weights_[i].sign() <= 0) {
      throw std::invalid_argument("weight " + std::to_string(i + 1) + " is " + to_string(weights_[i]) +
                                  ": weights must be positive");
    }
  }
  rational_ = !all_equal(weights_);
  if (rational_ && basis_ == Basis::lagrange) {
    const ExactNet converted = exact_net(*this);
    for (std::size_t i = 0; i < count; ++i) {
      if (converted.net.weights[i].sign() <= 0) {
        throw std::invalid_argument("the weight of control point " + std::to_string(i + 1) +
                                    " is not positive after conversion from the lagrange basis");
      }
    }
  }
}

std::string kind_name(const Element& element) { return element.is_triangle() ? "triangle" : "quadrilateral"; }

std::string degree_name(const Element& element) {
  const Shape& shape = element.shape();
  std::string result = std::to_string(shape.degree(0));
  bool equal = true;
  for (int f = 1; f < shape.factor_count(); ++f) {
    result += "x" + std::to_string(shape.degree(f));
    equal = equal && shape.degree(f) == shape.degree(0);
  }
  return equal ? std::to_string(shape.degree(0)) : result;
}

}  // namespace bezcert
