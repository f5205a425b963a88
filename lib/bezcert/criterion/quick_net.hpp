// The control net of a polynomial triangle in doubles with one error bound, and in 128-bit integers: what a
// criterion needs when only its status is asked for.
//
// Points are relative to the first node and multiplied by one positive number. `turn` and `forward` give
// exact signs: from doubles if the value is farther from 0 than the bound, else from integers. Nothing is
// allocated.
//
// The bound. Let v = 2^-52, the error of one operation in any rounding mode, D the largest coordinate of a
// node relative to the first, R the largest sum of sizes of a row of the basis change (integers), m the
// number of nodes, S = R D. A control point X~ is a sum of at most m terms, each rounded twice: |X~ - X| <= 2
// (m + 2) v S. A difference of two: error e <= 4 (m + 2) v S + 4 v S = 4 (m + 3) v S, size <= 2.1 S. A cross
// or dot product of two differences: 2 (2 * 2.1 S e + e^2 + v (2.1 S)^2) + v 2 (2.1 S)^2 (1 + ...) < (33.6 (m
// + 3) + 20) v S^2 < 40 (m + 4) v S^2. The bound used is B = 64 (m + 4) v S^2, which covers the rounding of S
// and of itself. S is kept within 2^-400 and 2^400: nothing overflows, and what underflows is far below the
// slack.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/element/element.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace bezcert {

class QuickNet {
 public:
  static constexpr int max_degree = 10;
  static constexpr std::size_t max_count = std::size_t{max_degree + 1} * (max_degree + 2) / 2;

  /// The net of the polynomial triangle with these nodes (positions in x and y). Returns false, and the net
  /// is not to be used, if it is not for this class: other shapes, larger degrees, exponents too far apart.
  bool load(Shape shape, Basis basis, std::span<const double> x, std::span<const double> y,
            std::span<const std::uint32_t> nodes);

  int degree() const { return shape_.degree(0); }
  std::size_t count() const { return count_; }

  /// The sign of the cross product (i to j) x (k to l), and of the dot product.
  int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    const double value = (x_[j] - x_[i]) * (y_[l] - y_[k]) - (y_[j] - y_[i]) * (x_[l] - x_[k]);
    if (value > bound_) return 1;
    if (value < -bound_) return -1;
    return exact_turn(i, j, k, l);
  }
  int forward(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    const double value = (x_[j] - x_[i]) * (x_[l] - x_[k]) + (y_[j] - y_[i]) * (y_[l] - y_[k]);
    if (value > bound_) return 1;
    if (value < -bound_) return -1;
    return exact_forward(i, j, k, l);
  }
  /// The orientation of three control points.
  int orientation(std::size_t i, std::size_t j, std::size_t k) const { return turn(i, j, i, k); }

  /// What is certain of the Bernstein coefficients of the Jacobian numerator N.
  struct NumeratorSigns {
    bool certain = false;          ///< whether all coefficients have certain signs; none is 0 then
    bool corners_positive = true;  ///< those at the corners
    bool all_positive = true;
  };
  NumeratorSigns numerator_signs() const;

 private:
  __extension__ using Int128 = __int128;

  int exact_turn(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const;
  int exact_forward(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const;
  void make_exact() const;

  Shape shape_;
  Basis basis_ = Basis::bernstein;
  std::size_t count_ = 0;
  double bound_ = 0;
  std::array<double, max_count> x_, y_;
  // Nodes as integers times 2^exponent_, relative to the first; control points once they are needed.
  std::span<const double> all_x_, all_y_;
  std::span<const std::uint32_t> nodes_;
  int exponent_ = 0;
  mutable bool has_exact_ = false;
  mutable std::array<Int128, max_count> exact_x_, exact_y_;
};

}  // namespace bezcert
