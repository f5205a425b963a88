#include "bezcert/element/lagrange.hpp"

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/bernstein/table_cache.hpp"

namespace bezcert {
namespace {

using Matrix = std::vector<std::vector<Rational>>;  // [coefficient][node]

// The scaled coefficients of prod_r prod_{s < mu_r} (n xi_r - s (sum of all xi)), without the 1/mu_r!.
Polynomial<Integer> product_of_forms(Domain domain, const std::vector<int>& mu, int degree) {
  Polynomial<Integer> product(Shape{domain, 0, 0}, {Integer(1)});
  for (std::size_t r = 0; r < mu.size(); ++r) {
    for (int s = 0; s < mu[r]; ++s) {
      Polynomial<Integer> form(Shape{domain, 1, 0});
      for (std::size_t k = 0; k < mu.size(); ++k) form.coefficients[k] = (k == r ? degree : 0) - s;
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

Matrix simplex_matrix(Domain domain, int degree) {
  const Shape shape{domain, degree, 0};
  const std::size_t count = coefficient_count(shape);
  const std::vector<Integer> factors = multinomials(shape);
  Matrix matrix(count, std::vector<Rational>(count));
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      std::vector<int> mu = {degree - r - c, c};
      if (domain == Domain::triangle) mu.push_back(r);
      Integer divisor = 1;
      for (const int part : mu) divisor *= factorial(part);
      const Polynomial<Integer> product = product_of_forms(domain, mu, degree);
      const std::size_t node = coefficient_index(shape, r, c);
      for (std::size_t i = 0; i < count; ++i) {
        matrix[i][node] = Rational(product.coefficients[i], Integer(divisor * factors[i]));
      }
    }
  }
  return matrix;
}

Matrix square_matrix(Shape shape) {
  const Matrix along_u = simplex_matrix(Domain::segment, shape.p);
  const Matrix along_v = simplex_matrix(Domain::segment, shape.q);
  const std::size_t count = coefficient_count(shape);
  const std::size_t columns = along_u.size();
  Matrix matrix(count, std::vector<Rational>(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      matrix[i][j] = along_v[i / columns][j / columns] * along_u[i % columns][j % columns];
    }
  }
  return matrix;
}

BasisChange build(Shape shape) {
  const Matrix matrix =
      shape.domain == Domain::square ? square_matrix(shape) : simplex_matrix(shape.domain, shape.p);
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
