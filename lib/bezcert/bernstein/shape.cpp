#include "bezcert/bernstein/shape.hpp"

namespace bezcert {
namespace {

// The coefficient k steps of the way from corner a to corner b; of two corners that differ in one factor.
std::size_t position_between(Shape shape, const DomainCorners::Corner& a, const DomainCorners::Corner& b,
                             int k) {
  DomainCorners::Corner exponents{};
  for (int i = 0; i < shape.dimension(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int degree = shape.degree(factor_of_coordinate(shape.domain, i));
    exponents[at] = a[at] == b[at] ? a[at] * degree : a[at] == 1 ? degree - k : k;
  }
  return coefficient_index(shape, exponents);
}

}  // namespace

std::vector<std::size_t> corner_indices(Shape shape) {
  const DomainCorners corners = domain_corners(shape.domain);
  std::vector<std::size_t> result;
  result.reserve(corners.count);
  for (std::size_t i = 0; i < corners.count; ++i) {
    result.push_back(position_between(shape, corners.list[i], corners.list[i], 0));
  }
  return result;
}

std::vector<std::size_t> edge_positions(Shape shape, int edge) {
  const DomainCorners corners = domain_corners(shape.domain);
  const DomainCorners::Corner& a = corners.list[static_cast<std::size_t>(edge)];
  const DomainCorners::Corner& b = corners.list[static_cast<std::size_t>(edge + 1) % corners.count];
  int coordinate = 0;
  while (a[static_cast<std::size_t>(coordinate)] == b[static_cast<std::size_t>(coordinate)]) ++coordinate;
  const int degree = shape.degree(factor_of_coordinate(shape.domain, coordinate));
  std::vector<std::size_t> result;
  result.reserve(static_cast<std::size_t>(degree) + 1);
  for (int k = 0; k <= degree; ++k) result.push_back(position_between(shape, a, b, k));
  return result;
}

}  // namespace bezcert
