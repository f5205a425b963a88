// The control net of a polynomial triangle in doubles with one error bound, and in 128-bit integers: what a
// criterion needs when only its status is asked for. It answers what FormSigns (form_signs.hpp) answers.
//
// Points are relative to the first node and multiplied by one positive number. `turn` and `forward` give
// exact signs: from doubles if the value is farther from 0 than the bound, else from integers. Nothing is
// allocated. The bound of a shape is found by running the same statements over StaticBound, in units of the
// largest coordinate of a node relative to the first; products scale with its square (static_bound.hpp).
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/element/element.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace bezcert {

struct QuickNetTables;

class QuickNet {
 public:
  static constexpr int max_degree = 10;
  static constexpr std::size_t max_count = std::size_t{max_degree + 1} * (max_degree + 2) / 2;

  /// The net of the polynomial triangle with these nodes (positions in x and y). Returns false, and the net
  /// is not to be used, if it is not for this class: other shapes, larger degrees, exponents too far apart,
  /// elements too large or too small.
  bool load(Shape shape, Basis basis, std::span<const double> x, std::span<const double> y,
            std::span<const std::uint32_t> nodes);

  int degree() const { return degree_; }
  static constexpr bool rational() { return false; }
  static constexpr bool equal_weights(std::size_t, std::size_t) { return true; }
  std::size_t auxiliary(int edge, int j) const { return edge_index(Shape::triangle(degree_), edge, 0, j); }

  int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    if (const auto sign = certain_sign(cross(between(i, j), between(k, l)), bound_)) return *sign;
    return exact_turn(i, j, k, l);
  }
  int forward(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    if (const auto sign = certain_sign(dot(between(i, j), between(k, l)), bound_)) return *sign;
    return exact_forward(i, j, k, l);
  }
  int orientation(std::size_t i, std::size_t j, std::size_t k) const { return turn(i, j, i, k); }

  /// The signs of all Bernstein coefficients of the Jacobian numerator N, if doubles tell them all.
  std::optional<PieceSigns> numerator_signs() const;

 private:
  __extension__ using Int128 = __int128;

  Vector2<double> between(std::size_t i, std::size_t j) const { return {x_[j] - x_[i], y_[j] - y_[i]}; }
  int exact_turn(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const;
  int exact_forward(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const;
  void make_exact() const;

  int degree_ = 0;
  const QuickNetTables* tables_ = nullptr;
  double unit_ = 0;   // of products
  double bound_ = 0;  // of `turn` and `forward`
  std::array<double, max_count> x_, y_;
  // Nodes as integers times 2^exponent_, relative to the first; control points once they are needed.
  std::span<const double> all_x_, all_y_;
  std::span<const std::uint32_t> nodes_;
  int exponent_ = 0;
  mutable bool has_exact_ = false;
  mutable std::array<Int128, max_count> exact_x_, exact_y_;
};

}  // namespace bezcert
