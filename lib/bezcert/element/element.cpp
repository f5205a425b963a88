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

Element::Element(Shape shape, Basis basis, ExactVector x, ExactVector y, ExactVector weights)
    : shape_(shape), basis_(basis), x_(std::move(x)), y_(std::move(y)), weights_(std::move(weights)) {
  const bool square = shape_.domain == Domain::square;
  if (!square) shape_.q = 0;
  if (shape_.domain == Domain::segment) throw std::invalid_argument("an element is no segment");
  if (shape_.p < 1 || (square && shape_.q < 1)) throw std::invalid_argument("the degree must be at least 1");
  if (degree() > max_degree) {
    throw std::invalid_argument("the degree must be at most " + std::to_string(max_degree));
  }
  const std::size_t count = coefficient_count(shape_);
  if (x_.size() != count || y_.size() != count) {
    throw std::invalid_argument("a " + kind_name(*this) + " of degree " + degree_name(*this) + " has " +
                                std::to_string(count) + " points, not " +
                                std::to_string(x_.size() != count ? x_.size() : y_.size()));
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
      if (converted.net.w[i].sign() <= 0) {
        throw std::invalid_argument("the weight of control point " + std::to_string(i + 1) +
                                    " is not positive after conversion from the lagrange basis");
      }
    }
  }
}

std::string kind_name(const Element& element) { return element.is_triangle() ? "triangle" : "quadrilateral"; }

std::string degree_name(const Element& element) {
  const Shape& shape = element.shape();
  if (element.is_triangle() || shape.p == shape.q) return std::to_string(shape.p);
  return std::to_string(shape.p) + "x" + std::to_string(shape.q);
}

}  // namespace bezcert
