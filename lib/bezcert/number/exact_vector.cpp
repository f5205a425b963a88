#include "bezcert/number/exact_vector.hpp"

#include <cmath>
#include <stdexcept>

namespace bezcert {

ExactVector::ExactVector(std::vector<double> numbers) : doubles_(std::move(numbers)) {
  for (const double number : doubles_) {
    if (!std::isfinite(number)) throw std::invalid_argument("a number is not finite");
  }
}

ExactVector::ExactVector(std::vector<Rational> numbers) {
  reserve(numbers.size());
  for (const Rational& number : numbers) push_back(number);
}

void ExactVector::push_back(const Rational& number) {
  double nearest = 0;
  if (binary64_ && is_binary64(number, nearest)) {
    doubles_.push_back(nearest);
    return;
  }
  become_rational();
  rationals_.push_back(number);
}

void ExactVector::push_back(double number) {
  if (!std::isfinite(number)) throw std::invalid_argument("a number is not finite");
  if (binary64_) {
    doubles_.push_back(number);
  } else {
    rationals_.emplace_back(number);
  }
}

std::span<double> ExactVector::append_zeros(std::size_t count) {
  doubles_.resize(doubles_.size() + count);
  return std::span(doubles_).last(count);
}

void ExactVector::become_rational() {
  if (!binary64_) return;
  std::vector<Rational> rationals;
  rationals.reserve(doubles_.size());
  for (const double number : doubles_) rationals.push_back(exact(number));
  binary64_ = false;
  rationals_ = std::move(rationals);
  doubles_ = {};
}

}  // namespace bezcert
