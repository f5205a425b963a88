// Common real zeros of polynomials on a line u = alpha, alpha algebraic.
//
// In the field Q(alpha) (polynomials modulo alpha's minimal polynomial) the greatest common divisor of
// f_1(alpha, v), f_2(alpha, v), ... has exactly the common zeros as roots; Sturm's theorem, which holds over
// any ordered field, counts the real ones in an interval whose ends may depend on alpha. Signs in the field:
// zero is decided by reduction, other signs by refining alpha's interval.
#pragma once

#include "bezcert/algebra/bivariate.hpp"
#include "bezcert/algebra/real_root.hpp"

#include <memory>
#include <optional>

namespace bezcert {

class Fiber {
 public:
  /// Precondition: alpha.polynomial is irreducible (with_minimal_polynomial), `polynomials` is not empty.
  Fiber(RealRoot alpha, const std::vector<Bivariate>& polynomials);
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  const RealRoot& alpha() const;
  /// Whether all polynomials vanish on the whole line.
  bool is_whole_line() const;

  enum class Ends { included, excluded };
  /// The number of different real common zeros v from low(alpha) to high(alpha). Precondition: not the whole
  /// line, low(alpha) < high(alpha).
  int count(const Univariate& low, const Univariate& high, Ends ends);

  /// The smallest of them: a rational where that is seen (the divisor is linear with a rational root, or
  /// alpha is rational), else isolated from all other roots of the divisor in an interval of at most `width`.
  /// The polynomial is left empty if it is not known. Precondition: count(...) > 0.
  RealRoot smallest(const Univariate& low, const Univariate& high, Ends ends, const Rational& width);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace bezcert
