// Control points of a triangle by their exponents: positions as seen from an edge, names for messages.
#pragma once

#include "bezcert/bernstein/shape.hpp"

#include <array>
#include <initializer_list>
#include <string>

namespace bezcert {

/// Exponents (i, j, k) of the barycentric parameters, i + j + k = degree.
using Exponents = std::array<int, 3>;

inline std::size_t triangle_index(int degree, const Exponents& exponents) {
  return coefficient_index(Shape::triangle(degree), exponents[2], exponents[1]);
}

inline Exponents triangle_exponents(int degree, std::size_t index) {
  int row = 0;
  int left = static_cast<int>(index);
  while (left > degree - row) left -= degree - row++ + 1;
  return {degree - row - left, left, row};
}

/// The control point in row i away from an edge, at place j along it.
inline std::size_t edge_index(Shape triangle, int edge, int i, int j) {
  const int left = triangle.degree(0) - i - j;
  const int row = edge == 0 ? i : edge == 1 ? j : left, column = edge == 0 ? j : edge == 1 ? left : i;
  return coefficient_index(triangle, row, column);
}

/// "P(3,0,0) P(2,1,0)".
inline std::string exponents_text(int degree, std::initializer_list<std::size_t> indices) {
  std::string text;
  for (const std::size_t index : indices) {
    const Exponents e = triangle_exponents(degree, index);
    if (!text.empty()) text += " ";
    text += "P(" + std::to_string(e[0]) + "," + std::to_string(e[1]) + "," + std::to_string(e[2]) + ")";
  }
  return text;
}

}  // namespace bezcert
