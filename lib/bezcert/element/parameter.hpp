// A point of the domain, exactly.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/number/rational.hpp"

#include <string>
#include <vector>

namespace bezcert {

class Parameter {
 public:
  /// By the values that are shown: of each factor of the domain, one number of a segment and otherwise the
  /// barycentric parameters; so (xi_0, xi_1, xi_2) of a triangle, (u, v) of a square. It may lie outside.
  /// Throws std::invalid_argument if their number does not fit or barycentric parameters do not sum to 1.
  Parameter(Domain domain, std::vector<Rational> values);

  /// By the affine coordinates (u, v, ...). Throws std::invalid_argument if their number does not fit.
  static Parameter at(Domain domain, const std::vector<Rational>& affine);

  Domain domain() const { return domain_; }
  const std::vector<Rational>& values() const { return values_; }
  /// The affine coordinates (u, v, ...).
  std::vector<Rational> affine() const;
  /// Whether it lies in the closed domain.
  bool is_inside() const;

  bool operator==(const Parameter&) const = default;

 private:
  Domain domain_;
  std::vector<Rational> values_;
};

/// "(1/2, 1/4, 1/4)".
std::string to_string(const Parameter& parameter);

}  // namespace bezcert
