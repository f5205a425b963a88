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
  CHECK(coefficient_count(Shape::segment(5)) == 6);
  CHECK(coefficient_count(Shape::triangle(3)) == 10);
  CHECK(coefficient_count(Shape::triangle(0)) == 1);
  CHECK(coefficient_count(Shape::square(2, 3)) == 12);
  CHECK(row_count(Shape::square(2, 3)) == 4);
  CHECK(column_count(Shape::square(2, 3), 3) == 3);
  CHECK(row_count(Shape::segment(4)) == 1);
  CHECK(column_count(Shape::triangle(4), 3) == 2);
}

TEST_CASE("row r, column c of a triangle has the exponents (p-r-c, c, r)") {
  // Degree 3 written out: 300 210 120 030 / 201 111 021 / 102 012 / 003.
  const int exponents[10][3] = {{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {2, 0, 1},
                                {1, 1, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}};
  const Shape cubic = Shape::triangle(3);
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
  const Shape shape = Shape::square(1, 2);
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
  CHECK(product_shape(Shape::square(2, 3), Shape::square(1, 4)) == Shape::square(3, 7));
  CHECK(product_shape(Shape::triangle(2), Shape::triangle(3)) == Shape::triangle(5));
  CHECK_THROWS_AS(product_shape(Shape::square(2, 3), Shape::triangle(2)), std::invalid_argument);
  CHECK_THROWS_AS(product_shape(Shape::segment(2), Shape::triangle(2)), std::invalid_argument);
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

TEST_CASE("tetrahedra, hexahedra and prisms are numbered by the same rules") {
  const Domain tetrahedron(3), hexahedron(1, 1, 1), prism(2, 1);
  // C(p + 3, 3); (p + 1)(q + 1)(r + 1); (p + 1)(p + 2)/2 (q + 1).
  CHECK(coefficient_count(Shape(tetrahedron, 4)) == 35);
  CHECK(coefficient_count(Shape(hexahedron, 1, 2, 3)) == 24);
  CHECK(coefficient_count(Shape(prism, 3, 2)) == 30);
  // The exponents of the affine coordinates in coefficient order are counted by rows, and lead back to their
  // places.
  for (const Shape shape :
       {Shape::triangle(3), Shape::square(2, 3), Shape::segment(4), Shape(tetrahedron, 4),
        Shape(hexahedron, 1, 2, 3), Shape(prism, 3, 2), Shape(Domain(1, 2), 2, 3), Shape(tetrahedron, 0)}) {
    std::size_t next = 0;
    const ShapeRows rows(shape);
    for (int layer = 0; layer < rows.layer_count(); ++layer) {
      for (int row = 0; row < rows.row_count(layer); ++row) {
        CHECK(rows.first(row, layer) == next);
        for (int c = 0; c < rows.column_count(row, layer); ++c, ++next) {
          CHECK(coefficient_index(shape, {c, row, layer}) == next);
        }
      }
    }
    CHECK(next == coefficient_count(shape));
  }
  // Corners: a hexahedron's and a prism's bottom is walked around, then its top.
  CHECK(corner_indices(Shape(tetrahedron, 1)) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(corner_indices(Shape(tetrahedron, 2)) == std::vector<std::size_t>{0, 2, 5, 9});
  CHECK(corner_indices(Shape(hexahedron, 1, 1, 1)) == std::vector<std::size_t>{0, 1, 3, 2, 4, 5, 7, 6});
  CHECK(corner_indices(Shape(prism, 2, 1)) == std::vector<std::size_t>{0, 2, 5, 6, 8, 11});
  CHECK(product_shape(Shape(prism, 3, 2), Shape(prism, 1, 4)) == Shape(prism, 4, 6));
}

TEST_CASE("products and operations on tetrahedra, hexahedra and prisms agree with evaluation") {
  const std::uint64_t seed = seed_or(204);
  Random random(seed);
  for (const Shape shape :
       {Shape(Domain(3), 3), Shape(Domain(1, 1, 1), 1, 2, 2), Shape(Domain(2, 1), 2, 2)}) {
    INFO("seed " << seed);
    const Polynomial<Rational> f = random_polynomial(random, shape), g = random_polynomial(random, shape);
    // (u, v, w) = (1/7, 2/7, 3/7): barycentric parameters of simplices of dimension 2 and 3 begin with the
    // rest.
    const Rational u(1, 7), v(2, 7), w(3, 7);
    const bool one_simplex = shape.factor_count() == 1;
    const auto at = [&](const Rational& x) -> std::vector<Rational> {
      if (one_simplex) return {1 - x - v - w, x, v, w};
      if (shape.factor_count() == 2) return {1 - x - v, x, v, w};
      return {x, v, w};
    };
    CHECK(evaluate(multiply(f, g), at(u)) == evaluate(f, at(u)) * evaluate(g, at(u)));
    CHECK(evaluate(elevate(f, 2), at(u)) == evaluate(f, at(u)));
    // The derivative by u of a polynomial of degree at most 3 along u: central differences, extrapolated
    // once.
    const auto slope = [&](const Rational& h) {
      return Rational((evaluate(f, at(u + h)) - evaluate(f, at(u - h))) / (2 * h));
    };
    CHECK(evaluate(differentiate(f, 0), at(u)) == (4 * slope(Rational(1, 2)) - slope(1)) / 3);
  }
}
