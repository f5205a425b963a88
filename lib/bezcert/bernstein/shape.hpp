// Domains, degrees and the order of Bernstein coefficients.
//
// Segment of degree p: coefficient c belongs to B_c(t) = C(p,c) (1-t)^(p-c) t^c.
// Triangle of degree p: rows r = 0..p of columns c = 0..p-r; row r, column c has the exponents
//   (p-r-c, c, r) of the barycentric parameters (xi_0, xi_1, xi_2). The first coefficient is corner 0,
//   the last of the first row corner 1, the last of all corner 2.
// Square of degrees p, q: rows r = 0..q along v of columns c = 0..p along u. Corners in counter-clockwise
//   order: (0,0), (1,0), (1,1), (0,1).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace bezcert {

enum class Domain { segment, triangle, square };

/// A domain with its degree. `q` is used by squares only and 0 elsewhere.
struct Shape {
  Domain domain = Domain::triangle;
  int p = 0;
  int q = 0;

  bool operator==(const Shape&) const = default;
  auto operator<=>(const Shape&) const = default;
};

/// The number of coefficients.
constexpr std::size_t coefficient_count(Shape shape) {
  const auto p = static_cast<std::size_t>(shape.p);
  const auto q = static_cast<std::size_t>(shape.q);
  switch (shape.domain) {
    case Domain::segment: return p + 1;
    case Domain::triangle: return (p + 1) * (p + 2) / 2;
    case Domain::square: return (p + 1) * (q + 1);
  }
  return 0;
}

/// The number of rows, and of columns in one row.
constexpr int row_count(Shape shape) { return (shape.domain == Domain::triangle ? shape.p : shape.q) + 1; }
constexpr int column_count(Shape shape, int row) {
  return (shape.domain == Domain::triangle ? shape.p - row : shape.p) + 1;
}

/// Position of the coefficient in row `row`, column `column`.
constexpr std::size_t coefficient_index(Shape shape, int row, int column) {
  const int before =
      shape.domain == Domain::triangle ? row * (shape.p + 1) - row * (row - 1) / 2 : row * (shape.p + 1);
  return static_cast<std::size_t>(before + column);
}

/// The positions of the corner coefficients, in counter-clockwise order.
inline std::vector<std::size_t> corner_indices(Shape shape) {
  switch (shape.domain) {
    case Domain::segment: return {0, coefficient_index(shape, 0, shape.p)};
    case Domain::triangle:
      return {0, coefficient_index(shape, 0, shape.p), coefficient_index(shape, shape.p, 0)};
    case Domain::square:
      return {0, coefficient_index(shape, 0, shape.p), coefficient_index(shape, shape.q, shape.p),
              coefficient_index(shape, shape.q, 0)};
  }
  return {};
}

/// The positions of the coefficients of edge i, which leads from corner i to the next, in that direction.
inline std::vector<std::size_t> edge_positions(Shape shape, int edge) {
  std::vector<std::size_t> result;
  const auto add = [&](int row, int column) { result.push_back(coefficient_index(shape, row, column)); };
  if (shape.domain == Domain::triangle) {
    for (int k = 0; k <= shape.p; ++k) {
      if (edge == 0) add(0, k);
      if (edge == 1) add(k, shape.p - k);
      if (edge == 2) add(shape.p - k, 0);
    }
    return result;
  }
  for (int k = 0; k <= (edge % 2 == 0 ? shape.p : shape.q); ++k) {
    if (edge == 0) add(0, k);
    if (edge == 1) add(k, shape.p);
    if (edge == 2) add(shape.q, shape.p - k);
    if (edge == 3) add(shape.q - k, 0);
  }
  return result;
}

/// The shape of a product. Throws std::invalid_argument if the domains differ.
inline Shape product_shape(Shape a, Shape b) {
  if (a.domain != b.domain) throw std::invalid_argument("product_shape: the domains differ");
  return {a.domain, a.p + b.p, a.q + b.q};
}

}  // namespace bezcert
