#include "bezcert/element/map.hpp"

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/element/jacobian.hpp"

namespace bezcert {
namespace {

// Evaluation is homogeneous: the barycentric parameters of each factor are integers over one denominator, and
// the denominators' powers are divided by at the end. Fractions would be reduced at every step.
struct IntegerParameter {
  std::array<std::array<Integer, max_dimension + 1>, max_dimension> barycentric;  // by factor
  std::array<Integer, max_dimension> denominator;                                 // by factor
};

IntegerParameter integer_parameter(const Parameter& parameter) {
  IntegerParameter result;
  auto value = parameter.values().begin();
  for (int f = 0; f < parameter.domain().factor_count(); ++f) {
    const auto factor = static_cast<std::size_t>(f);
    auto& barycentric = result.barycentric[factor];
    Integer& common = result.denominator[factor];
    const int simplex = parameter.domain().simplex(f);
    if (simplex == 1) {
      common = denominator(*value);
      barycentric[1] = numerator(*value++);
      barycentric[0] = common - barycentric[1];
      continue;
    }
    common = 1;
    for (int k = 0; k <= simplex; ++k) common = lcm(common, Integer(denominator(value[k])));
    for (int k = 0; k <= simplex; ++k, ++value) {
      barycentric[static_cast<std::size_t>(k)] =
          Integer(numerator(*value)) * (common / Integer(denominator(*value)));
    }
  }
  return result;
}

Polynomial<Integer> collapse_all(Polynomial<Integer> f, const IntegerParameter& at, int to) {
  for (int factor = 0; factor < f.shape.factor_count(); ++factor) {
    if (f.shape.degree(factor) <= to) continue;
    f = collapse(std::move(f), factor, at.barycentric[static_cast<std::size_t>(factor)].data(), to);
  }
  return f;
}

// Column 0 is W, the others X, Y, ...; row 0 holds the values, the others the derivatives by u, v, ...
using Matrix = std::array<std::array<Integer, max_dimension + 1>, max_dimension + 1>;

// With K the product of the factors' denominators to the powers of their degrees: K times the value; and of
// the derivative by a coordinate K / (denominator degree) times it, both of that coordinate's factor.
void fill_column(Matrix& matrix, std::size_t column, Shape shape, const std::vector<Integer>& coefficients,
                 const IntegerParameter& at) {
  const Polynomial<Integer> linear = collapse_all(Polynomial<Integer>(shape, coefficients), at, 1);
  matrix[0][column] = collapse_all(linear, at, 0).coefficients[0];
  for (int i = 0; i < shape.dimension(); ++i) {
    matrix[static_cast<std::size_t>(i) + 1][column] =
        collapse_all(differentiate(linear, i), at, 0).coefficients[0];
  }
}

// The determinant of the rows from `row` on in the columns of the set `columns`, as many, by expansion along
// rows.
Integer determinant(const Matrix& matrix, std::size_t row, unsigned columns) {
  if (columns == 0) return 1;
  Integer result = 0;
  bool negative = false;
  for (std::size_t c = 0; c <= max_dimension; ++c) {
    if ((columns >> c) % 2 == 0) continue;
    const Integer term = matrix[row][c] * determinant(matrix, row + 1, columns & ~(1U << c));
    if (negative) {
      result -= term;
    } else {
      result += term;
    }
    negative = !negative;
  }
  return result;
}

Integer power(const Integer& base, int exponent) {
  Integer result;
  mpz_pow_ui(result.backend().data(), base.backend().data(), static_cast<unsigned long>(exponent));
  return result;
}

}  // namespace

MapValue evaluate_map(const ExactNet& exact, const Parameter& parameter) {
  const Net<Integer>& net = exact.net;
  const Shape shape = net.shape;
  if (parameter.domain() != shape.domain) {
    throw std::invalid_argument("evaluate_map: the parameter is of another domain");
  }
  const IntegerParameter at = integer_parameter(parameter);
  const int dimension = shape.dimension();
  Matrix matrix;
  for (int k = 0; k < dimension; ++k) {
    const auto coordinate = static_cast<std::size_t>(k);
    fill_column(matrix, coordinate + 1, shape, net.coordinates[coordinate], at);
  }
  Integer& weight = matrix[0][0];
  if (net.rational()) {
    fill_column(matrix, 0, shape, net.weights, at);
  } else {
    weight = 1;
    for (int f = 0; f < shape.factor_count(); ++f) {
      weight *= power(at.denominator[static_cast<std::size_t>(f)], shape.degree(f));
    }
  }
  MapValue result;
  Rational scale = degree_factor(shape);
  for (int k = 0; k < dimension; ++k) {
    const auto coordinate = static_cast<std::size_t>(k);
    result.place.push_back(
        exact.scale *
        Rational(Integer(exact.first[coordinate] * weight + matrix[0][coordinate + 1]), weight));
    scale *= exact.scale;
  }
  // det J W^(d+1) is the determinant of (P*, P*_u, P*_v, ...); with W = 1 that of the derivatives.
  const unsigned all = (2U << dimension) - 1;
  Integer value = net.rational() ? determinant(matrix, 0, all) : determinant(matrix, 1, all - 1);
  for (int i = 0; i < dimension; ++i) {
    value *= at.denominator[static_cast<std::size_t>(factor_of_coordinate(shape.domain, i))];
  }
  result.determinant = scale * Rational(value, power(weight, net.rational() ? dimension + 1 : dimension));
  return result;
}

MapValue evaluate_map(const Element& element, const Parameter& parameter) {
  return evaluate_map(exact_net(element), parameter);
}

}  // namespace bezcert
