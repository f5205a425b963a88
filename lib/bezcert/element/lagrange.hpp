// From equispaced Lagrange nodes to Bernstein coefficients, exactly.
//
// The Lagrange basis function of the node mu / n is the product over the barycentric coordinates of
// binomials in n xi_r: L_mu = prod_r C(n xi_r, mu_r) (it is 1 at its node and vanishes at the others, of
// which each has a smaller mu_r for some r). Made homogeneous with 1 = xi_0 + xi_1 + xi_2 it is a product of
// n linear forms, whose coefficients over the multinomials are its Bernstein coefficients: rational numbers
// with one common denominator. On a product of simplices the matrix is the product of the factors' matrices.
#pragma once

#include "bezcert/bernstein/shape.hpp"
#include "bezcert/number/interval.hpp"

#include <type_traits>
#include <vector>

namespace bezcert {

/// A sparse matrix of integers over one common denominator.
struct BasisChange {
  struct Entry {
    std::size_t column = 0;
    Integer exact;
    Interval interval;
  };
  std::vector<std::vector<Entry>> rows;
  Integer denominator;
};

/// coefficients = matrix * nodal values / denominator. Built once a shape, then kept.
const BasisChange& lagrange_to_bernstein(Shape shape);

/// Nodal values to `denominator` times the coefficients, for T = Interval (while a RoundUp lives) or Integer.
/// Nothing happens to an empty list.
template <class T>
void change_basis(const BasisChange& change, std::vector<T>& values) {
  if (values.empty()) return;
  std::vector<T> result;
  result.reserve(values.size());
  for (const auto& row : change.rows) {
    T sum(0);
    for (const auto& entry : row) {
      if constexpr (std::is_same_v<T, Interval>) {
        sum += entry.interval * values[entry.column];
      } else {
        sum += entry.exact * values[entry.column];
      }
    }
    result.push_back(std::move(sum));
  }
  values = std::move(result);
}

}  // namespace bezcert
