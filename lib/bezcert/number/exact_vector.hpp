// A sequence of exact numbers, kept as doubles while all of them are doubles.
//
// Coordinates of a mesh are doubles nearly always; then this costs eight bytes a number and the filter
// reads them without conversion. One number that is not a double turns the sequence into rationals.
#pragma once

#include "bezcert/number/rational.hpp"
#include "bezcert/number/scaled.hpp"

#include <span>
#include <vector>

namespace bezcert {

class ExactVector {
 public:
  ExactVector() = default;
  /// Throws std::invalid_argument if a number is not finite.
  explicit ExactVector(std::vector<double> numbers);
  explicit ExactVector(std::vector<Rational> numbers);

  std::size_t size() const { return binary64_ ? doubles_.size() : rationals_.size(); }
  bool empty() const { return size() == 0; }

  /// Whether all numbers are doubles; then `doubles()` holds them, otherwise `rationals()` does.
  bool binary64() const { return binary64_; }
  std::span<const double> doubles() const { return doubles_; }
  std::span<const Rational> rationals() const { return rationals_; }

  /// The i-th number. Precondition: i < size().
  Rational operator[](std::size_t i) const { return binary64_ ? Rational(doubles_[i]) : rationals_[i]; }

  /// Appends a number, changing to rationals if it is no double.
  void push_back(const Rational& number);
  /// Precondition: `number` is finite.
  void push_back(double number);
  void reserve(std::size_t count) { doubles_.reserve(count); }
  /// Appends `count` zeros, to be overwritten through the result before anything else is appended.
  /// Preconditions: binary64(), and only finite numbers are written.
  std::span<double> append_zeros(std::size_t count);
  /// Removes the last `count` numbers. Precondition: count <= size().
  void remove_last(std::size_t count) {
    if (binary64_) return doubles_.resize(doubles_.size() - count);
    rationals_.resize(rationals_.size() - count);
  }

  ScaledIntegers scaled() const {
    return binary64_ ? scaled_integers(doubles()) : scaled_integers(rationals());
  }

 private:
  void become_rational();

  bool binary64_ = true;
  std::vector<double> doubles_;
  std::vector<Rational> rationals_;
};

}  // namespace bezcert
