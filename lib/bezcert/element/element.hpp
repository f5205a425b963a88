// One element: a rational Bezier triangle or tensor patch, given exactly.
//
// The geometric map is x(xi) = sum w_m P_m B_m(xi) / sum w_m B_m(xi) (basis bernstein), or the homogeneous
// map (w x, w y, ..., w) interpolates its values at the equispaced nodes of the domain (basis lagrange).
// Domain: the unit right triangle with corners (0,0), (1,0), (0,1), barycentric (1-u-v, u, v); or the unit
// square. det J is the Jacobian determinant of the map with respect to (u, v), in length squared.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/number/exact_vector.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace bezcert {

/// What the points of an element are: Bezier control points, or nodes that the map interpolates.
enum class Basis { bernstein, lagrange };

/// The largest degree an element may have; the mathematics has no limit, the memory has.
inline constexpr int max_degree = 64;

class Element {
 public:
  /// The points by coordinate: as many lists as the domain has dimensions, the others empty.
  using Coordinates = std::array<ExactVector, max_dimension>;

  /// An element of shape (domain triangle or square, degrees at least 1) with one point a coefficient, in
  /// the order of shape.hpp, and one weight a point, or none for all equal.
  /// Throws std::invalid_argument if the shape is not of an element, a count does not fit or a weight is
  /// not positive (in the lagrange basis: a weight of the control net that it converts to).
  Element(Shape shape, Basis basis, Coordinates coordinates, ExactVector weights = {});

  const Shape& shape() const { return shape_; }
  Basis basis() const { return basis_; }
  int dimension() const { return shape_.dimension(); }
  /// One list of numbers a coordinate.
  std::span<const ExactVector> coordinates() const {
    return std::span(coordinates_).first(static_cast<std::size_t>(dimension()));
  }
  /// Empty if none were given.
  const ExactVector& weights() const { return weights_; }

  bool is_triangle() const { return shape_.domain == Domain::triangle; }
  /// Whether the weights differ; an element with equal weights is polynomial.
  bool rational() const { return rational_; }
  /// The largest degree of a factor of the domain.
  int degree() const { return std::max({shape_.degree(0), shape_.degree(1), shape_.degree(2)}); }

 private:
  Shape shape_;
  Basis basis_;
  Coordinates coordinates_;
  ExactVector weights_;
  bool rational_ = false;
};

/// "triangle" or "quadrilateral".
std::string kind_name(const Element& element);

/// "3" for a triangle or a quadrilateral of equal degrees, "2x3" otherwise.
std::string degree_name(const Element& element);

}  // namespace bezcert
