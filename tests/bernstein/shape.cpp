// shape.hpp: the order of coefficients is the one it states.
#include "bernstein/explicit_sum.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("rows and columns number the coefficients one after the other") {
  for (const Shape shape : all_shapes(8)) {
    INFO(show(shape));
    std::size_t next = 0;
    for (int r = 0; r < row_count(shape); ++r) {
      for (int c = 0; c < column_count(shape, r); ++c) {
        if (coefficient_index(shape, r, c) != next) FAIL("row " << r << ", column " << c);
        ++next;
      }
    }
    CHECK(next == coefficient_count(shape));
  }
  CHECK(coefficient_count({Domain::segment, 5, 0}) == 6);
  CHECK(coefficient_count({Domain::triangle, 3, 0}) == 10);
  CHECK(coefficient_count({Domain::triangle, 0, 0}) == 1);
  CHECK(coefficient_count({Domain::square, 2, 3}) == 12);
  CHECK(row_count({Domain::square, 2, 3}) == 4);
  CHECK(column_count({Domain::square, 2, 3}, 3) == 3);
  CHECK(row_count({Domain::segment, 4, 0}) == 1);
  CHECK(column_count({Domain::triangle, 4, 0}, 3) == 2);
}

TEST_CASE("row r, column c of a triangle has the exponents (p-r-c, c, r)") {
  // Degree 3 written out: 300 210 120 030 / 201 111 021 / 102 012 / 003.
  const int exponents[10][3] = {{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {2, 0, 1},
                                {1, 1, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}};
  const Shape cubic{Domain::triangle, 3, 0};
  for (std::size_t m = 0; m < 10; ++m) {
    INFO("coefficient " << m);
    CHECK(coefficient_index(cubic, exponents[m][2], exponents[m][1]) == m);
    // The library evaluates the m-th basis function as that monomial.
    Polynomial<Rational> f(cubic);
    f.coefficients[m] = 1;
    const Rational x(2, 11), y(3, 11), z(6, 11);
    const Integer factor =
        6 / (factorial(exponents[m][0]) * factorial(exponents[m][1]) * factorial(exponents[m][2]));
    CHECK(evaluate(f, {x, y, z}) == Rational(factor) * power(x, exponents[m][0]) * power(y, exponents[m][1]) *
                                        power(z, exponents[m][2]));
  }
}

TEST_CASE("rows of a square run along v, columns along u") {
  const Shape shape{Domain::square, 1, 2};
  for (int r = 0; r <= 2; ++r) {
    for (int c = 0; c <= 1; ++c) {
      Polynomial<Rational> f(shape);
      f.at(r, c) = 1;
      const Rational u(2, 7), v(3, 7);
      const Rational along_u = c == 0 ? Rational(1 - u) : u;
      const Rational along_v = r == 0   ? Rational((1 - v) * (1 - v))
                               : r == 1 ? Rational(2 * v * (1 - v))
                                        : Rational(v * v);
      INFO("row " << r << ", column " << c);
      CHECK(evaluate(f, {u, v}) == along_u * along_v);
    }
  }
}

TEST_CASE("corner coefficients are the values at the corners, counter-clockwise") {
  using Parameters = std::vector<std::vector<Rational>>;
  const Parameters segment{{0}, {1}};
  const Parameters triangle{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Parameters square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::uint64_t seed = seed_or(201);
  Random random(seed);
  for (const Shape shape : all_shapes(5)) {
    const Polynomial<Rational> f = random_polynomial(random, shape);
    const Parameters& corners = shape.domain == Domain::segment    ? segment
                                : shape.domain == Domain::triangle ? triangle
                                                                   : square;
    const auto indices = corner_indices(shape);
    INFO("seed " << seed << ", " << show(shape));
    REQUIRE(indices.size() == corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (f.coefficients.at(indices[k]) != explicit_value(f, corners[k])) FAIL("corner " << k);
      if (evaluate(f, corners[k]) != f.coefficients[indices[k]]) FAIL("evaluate at corner " << k);
    }
  }
}

TEST_CASE("product_shape adds degrees and refuses different domains") {
  CHECK(product_shape({Domain::square, 2, 3}, {Domain::square, 1, 4}) == Shape{Domain::square, 3, 7});
  CHECK(product_shape({Domain::triangle, 2, 0}, {Domain::triangle, 3, 0}) == Shape{Domain::triangle, 5, 0});
  CHECK_THROWS_AS(product_shape({Domain::square, 2, 3}, {Domain::triangle, 2, 0}), std::invalid_argument);
  CHECK_THROWS_AS(product_shape({Domain::segment, 2, 0}, {Domain::triangle, 2, 0}), std::invalid_argument);
}

TEST_CASE("a polynomial refuses a wrong number of coefficients or parameters") {
  for (const Shape shape : all_shapes(3)) {
    INFO(show(shape));
    const std::size_t count = coefficient_count(shape);
    CHECK_NOTHROW(Polynomial<Rational>(shape, std::vector<Rational>(count)));
    CHECK_THROWS_AS(Polynomial<Rational>(shape, std::vector<Rational>(count + 1)), std::invalid_argument);
    CHECK_THROWS_AS(Polynomial<Rational>(shape, std::vector<Rational>(count - 1)), std::invalid_argument);
    const Polynomial<Rational> f(shape);
    for (std::size_t k = 0; k <= 4; ++k) {
      if (k == parameter_count(shape.domain)) continue;
      CHECK_THROWS_AS(evaluate(f, std::vector<Rational>(k)), std::invalid_argument);
    }
  }
}
