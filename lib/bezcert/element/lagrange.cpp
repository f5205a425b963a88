#include "bezcert/element/lagrange.hpp"

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/bernstein/table_cache.hpp"

namespace bezcert {
namespace {

using Matrix = std::vector<std::vector<Rational>>;  // [coefficient][node]

// The scaled coefficients of prod_r prod_{s < mu_r} (n xi_r - s (sum of all xi)), without the 1/mu_r!.
Polynomial<Integer> product_of_forms(Shape simplex, const std::array<int, max_dimension + 1>& mu) {
  Polynomial<Integer> product(Shape(simplex.domain, 0), {Integer(1)});
  for (std::size_t r = 0; r < mu.size(); ++r) {
    for (int s = 0; s < mu[r]; ++s) {
      Polynomial<Integer> form(Shape(simplex.domain, 1));
      for (std::size_t k = 0; k < form.coefficients.size(); ++k) {
        form.coefficients[k] = (k == r ? simplex.degree(0) : 0) - s;
      }
      product = convolve(product, form);
    }
  }
  return product;
}

Integer factorial(int n) {
  Integer result = 1;
  for (int i = 2; i <= n; ++i) result *= i;
  return result;
}

Matrix simplex_matrix(Shape simplex) {
  const std::size_t count = coefficient_count(simplex);
  const std::vector<Integer> factors = multinomials(simplex);
  Matrix matrix(count, std::vector<Rational>(count));
  for_each_simplex_point(simplex.dimension(), simplex.degree(0), [&](const SimplexPoint& node) {
    Integer divisor = 1;
    for (const int part : node.exponents) divisor *= factorial(part);
    const Polynomial<Integer> product = product_of_forms(simplex, node.exponents);
    for (std::size_t i = 0; i < count; ++i) {
      matrix[i][node.position] = Rational(product.coefficients[i], Integer(divisor * factors[i]));
    }
  });
  return matrix;
}

// The matrix of a product whose last factor has the matrix `outer`.
Matrix product_matrix(const Matrix& inner, const Matrix& outer) {
  const std::size_t size = inner.size(), count = size * outer.size();
  Matrix matrix(count, std::vector<Rational>(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      matrix[i][j] = outer[i / size][j / size] * inner[i % size][j % size];
    }
  }
  return matrix;
}

BasisChange build(Shape shape) {
  Matrix matrix = {{Rational(1)}};
  for (int f = 0; f < shape.factor_count(); ++f) {
    const Shape simplex(Domain(shape.domain.simplex(f)), shape.degree(f));
    matrix = product_matrix(matrix, simplex_matrix(simplex));
  }
  BasisChange result;
  result.denominator = 1;
  for (const auto& row : matrix) {
    for (const Rational& entry : row)
      result.denominator = lcm(result.denominator, Integer(denominator(entry)));
  }
  for (const auto& row : matrix) {
    auto& sparse = result.rows.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (row[j].sign() == 0) continue;
      const Integer value = numerator(Rational(row[j] * Rational(result.denominator)));
      sparse.push_back({j, value, to_interval(value)});
    }
  }
  return result;
}

}  // namespace

const BasisChange& lagrange_to_bernstein(Shape shape) {
  static TableCache<BasisChange> cache;
  return cache.get(shape, build);
}

}  // namespace bezcert
