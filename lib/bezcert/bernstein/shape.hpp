// Domains, degrees and the order of Bernstein coefficients.
//
// A domain is a product of simplices: segment {1}, triangle {2}, square {1, 1}; tetrahedron {3}, hexahedron
// {1, 1, 1} and prism {2, 1} are of the same kind. A shape gives each factor a degree, and a basis function
// is a product of one Bernstein polynomial a factor. The first factor's coefficients lie together, the last
// factor is outermost; within a factor see simplex.hpp. Of the planar ones: Segment of degree p: coefficient
// c belongs to B_c(t) = C(p,c) (1-t)^(p-c) t^c. Triangle of degree p: rows r = 0..p of columns c = 0..p-r;
// row r, column c has the exponents
//   (p-r-c, c, r) of the barycentric parameters (xi_0, xi_1, xi_2). The first coefficient is corner 0,
//   the last of the first row corner 1, the last of all corner 2.
// Square of degrees p, q: rows r = 0..q along v of columns c = 0..p along u. Corners in counter-clockwise
//   order: (0,0), (1,0), (1,1), (0,1).
// The affine coordinates of a domain are (u, v, ...): of each factor in turn, the barycentric parameters of
// its corners 1, 2, ...
#pragma once

#include "bezcert/bernstein/simplex.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace bezcert {

/// A product of at most three simplices, of dimension at most three in all.
class Domain {
 public:
  /// The dimensions of the simplices; 0: no more. Throws std::invalid_argument if their sum is not 1 to 3.
  explicit constexpr Domain(int first, int second = 0, int third = 0) {
    const bool large = first > max_dimension || second > max_dimension || third > max_dimension;
    const bool gap = large || first <= 0 || second < 0 || third < 0 || (second == 0 && third > 0);
    if (gap || first + second + third > max_dimension) {
      throw std::invalid_argument("a domain is a product of simplices of dimension 1 to 3 in all");
    }
    packed_ = static_cast<std::uint8_t>(first | second << 2 | third << 4);
  }
  static const Domain segment, triangle, square;

  /// The dimension of a factor's simplex; 0 for a factor that is not there.
  constexpr int simplex(int factor) const {
    return factor < 0 || factor >= max_dimension ? 0 : packed_ >> 2 * factor & 3;
  }
  constexpr int factor_count() const { return (simplex(0) > 0) + (simplex(1) > 0) + (simplex(2) > 0); }
  constexpr int dimension() const { return simplex(0) + simplex(1) + simplex(2); }

  bool operator==(const Domain&) const = default;
  auto operator<=>(const Domain&) const = default;

 private:
  std::uint8_t packed_ = 0;  // two bits a factor: elements of meshes hold a shape each
};

inline constexpr Domain Domain::segment{1};
inline constexpr Domain Domain::triangle{2};
inline constexpr Domain Domain::square{1, 1};

/// A domain with the degree of each factor.
class Shape {
 public:
  Domain domain = Domain::triangle;

  /// A triangle of degree 0.
  constexpr Shape() = default;
  /// Degrees of factors that the domain has not are dropped. Throws std::invalid_argument if a degree does
  /// not fit in 16 bits (elements are refused long before).
  constexpr Shape(Domain of, int first, int second = 0, int third = 0) : domain(of) {
    const std::array<int, max_dimension> given{first, second, third};
    for (int f = 0; f < of.factor_count(); ++f) set_degree(f, given[static_cast<std::size_t>(f)]);
  }
  static constexpr Shape segment(int degree) { return {Domain::segment, degree}; }
  static constexpr Shape triangle(int degree) { return {Domain::triangle, degree}; }
  static constexpr Shape square(int along_u, int along_v) { return {Domain::square, along_u, along_v}; }

  constexpr int factor_count() const { return domain.factor_count(); }
  constexpr int dimension() const { return domain.dimension(); }
  /// The degree of a factor; 0 for a factor that is not there.
  constexpr int degree(int factor) const {
    return factor < 0 || factor >= max_dimension ? 0 : degrees_[static_cast<std::size_t>(factor)];
  }
  /// The same shape with `more` (perhaps negative) added to the degree of one factor, or of all.
  constexpr Shape raised(int factor, int more) const {
    Shape result = *this;
    result.set_degree(factor, degree(factor) + more);
    return result;
  }
  constexpr Shape all_raised(int more) const {
    Shape result = *this;
    for (int f = 0; f < factor_count(); ++f) result.set_degree(f, degree(f) + more);
    return result;
  }

  /// (Written out: compared for every element of a mesh, and an array is compared by a call.)
  constexpr bool operator==(const Shape& other) const {
    return domain == other.domain && degrees_[0] == other.degrees_[0] && degrees_[1] == other.degrees_[1] &&
           degrees_[2] == other.degrees_[2];
  }
  auto operator<=>(const Shape&) const = default;

 private:
  constexpr void set_degree(int factor, int degree) {
    if (degree != static_cast<std::int16_t>(degree)) throw std::invalid_argument("the degree is too large");
    degrees_[static_cast<std::size_t>(factor)] = static_cast<std::int16_t>(degree);
  }

  std::array<std::int16_t, max_dimension> degrees_{};
};

/// The number of coefficients along one factor.
constexpr std::size_t coefficient_count(Shape shape, int factor) {
  return simplex_count(shape.domain.simplex(factor), shape.degree(factor));
}

/// The number of coefficients.
constexpr std::size_t coefficient_count(Shape shape) {
  std::size_t result = 1;
  for (int f = 0; f < shape.factor_count(); ++f) result *= coefficient_count(shape, f);
  return result;
}

/// The number of rows, and of columns in one row. Precondition of all that speaks of rows: at most two
/// dimensions.
constexpr int row_count(Shape shape) {
  return (shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1)) + 1;
}
constexpr int column_count(Shape shape, int row) {
  return (shape.domain == Domain::triangle ? shape.degree(0) - row : shape.degree(0)) + 1;
}

/// Position of the coefficient in row `row`, column `column`.
constexpr std::size_t coefficient_index(Shape shape, int row, int column) {
  const int before =
      row * (shape.degree(0) + 1) - (shape.domain == Domain::triangle ? row * (row - 1) / 2 : 0);
  return static_cast<std::size_t>(before + column);
}

/// Position of the coefficient with the exponents of the affine coordinates, for any domain.
constexpr std::size_t coefficient_index(Shape shape, const std::array<int, max_dimension>& exponents) {
  std::size_t result = 0, stride = 1, coordinate = 0;
  for (int f = 0; f < shape.factor_count(); ++f) {
    std::array<int, max_dimension> own{};
    for (int k = 0; k < shape.domain.simplex(f); ++k) {
      own[static_cast<std::size_t>(k)] = exponents[coordinate++];
    }
    result += stride * simplex_position(shape.degree(f), own);
    stride *= coefficient_count(shape, f);
  }
  return result;
}

/// The number of values that name a point of a domain: of each factor, one of a segment and otherwise the
/// barycentric parameters.
constexpr std::size_t parameter_size(Domain domain) {
  std::size_t result = 0;
  for (int f = 0; f < domain.factor_count(); ++f) {
    const auto simplex = static_cast<std::size_t>(domain.simplex(f));
    result += simplex == 1 ? 1 : simplex + 1;
  }
  return result;
}

/// The factor that an affine coordinate belongs to.
constexpr int factor_of_coordinate(Domain domain, int coordinate) {
  int factor = 0;
  while (coordinate >= domain.simplex(factor)) coordinate -= domain.simplex(factor++);
  return factor;
}

/// The rows of a shape: coefficients whose exponents differ in the first affine coordinate alone lie
/// together. The row and the layer are the exponents of the second coordinate and of the third (0 where there
/// is none).
class ShapeRows {
 public:
  explicit constexpr ShapeRows(Shape shape) : shape_(shape), dimension_(shape.dimension()) {
    const int of_row = dimension_ > 1 ? factor_of_coordinate(shape.domain, 1) : max_dimension;
    const int of_layer = dimension_ > 2 ? factor_of_coordinate(shape.domain, 2) : max_dimension;
    if (dimension_ > 1) rows_ = shape.degree(of_row);
    if (dimension_ > 2) layers_ = shape.degree(of_layer);
    columns_less_row_ = of_row == 0;
    columns_less_layer_ = of_layer == 0;
    rows_less_layer_ = of_row == of_layer;
  }
  constexpr int layer_count() const { return layers_ + 1; }
  constexpr int row_count(int layer) const { return rows_ - rows_less_layer_ * layer + 1; }
  constexpr int column_count(int row, int layer) const {
    return shape_.degree(0) - columns_less_row_ * row - columns_less_layer_ * layer + 1;
  }
  /// The position of the first coefficient of a row.
  constexpr std::size_t first(int row, int layer) const {
    if (dimension_ == 3) return coefficient_index(shape_, {0, row, layer});
    return static_cast<std::size_t>(row * (shape_.degree(0) + 1) - columns_less_row_ * (row * (row - 1) / 2));
  }

 private:
  Shape shape_;
  int dimension_;
  int rows_ = 0, layers_ = 0;
  int columns_less_row_ = 0, columns_less_layer_ = 0, rows_less_layer_ = 0;
};

/// The corners of a domain by their affine coordinates, each 0 or 1.
struct DomainCorners {
  using Corner = std::array<int, max_dimension>;
  std::array<Corner, 1 << max_dimension> list{};
  std::size_t count = 1;
};

/// In their order: a segment times a segment is walked around (counter-clockwise); every further factor
/// repeats what there is, one copy a corner of its simplex.
constexpr DomainCorners domain_corners(Domain domain) {
  DomainCorners result;
  int dimension = 0;
  for (int f = 0; f < domain.factor_count(); ++f) {
    const std::size_t before = result.count;
    for (int corner = 1; corner <= domain.simplex(f); ++corner) {
      for (std::size_t i = 0; i < before; ++i) {
        DomainCorners::Corner copy = result.list[dimension == 1 ? before - 1 - i : i];
        copy[static_cast<std::size_t>(dimension + corner) - 1] = 1;
        result.list[result.count++] = copy;
      }
    }
    dimension += domain.simplex(f);
  }
  return result;
}

/// The positions of the corner coefficients, in the order of `domain_corners`.
std::vector<std::size_t> corner_indices(Shape shape);

/// The positions of the coefficients of edge i of a planar domain, which leads from corner i to the next, in
/// that direction.
std::vector<std::size_t> edge_positions(Shape shape, int edge);

/// The shape of a product. Throws std::invalid_argument if the domains differ.
constexpr Shape product_shape(Shape a, Shape b) {
  if (a.domain != b.domain) throw std::invalid_argument("product_shape: the domains differ");
  return {a.domain, a.degree(0) + b.degree(0), a.degree(1) + b.degree(1), a.degree(2) + b.degree(2)};
}

}  // namespace bezcert
