// Random elements, and exact transformations of elements with a known effect on the verdict.
#pragma once

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/element/element.hpp"
#include "bezcert/element/parameter.hpp"
#include "random_input.hpp"

#include <array>
#include <string>

namespace bezcert::test {

/// An element in the Bernstein basis as plain rationals: easy to transform and to print.
struct RawElement {
  Shape shape;
  std::vector<Rational> x, y, w;  ///< w is empty for a polynomial element

  Element build() const {
    return Element(shape, Basis::bernstein, {ExactVector(x), ExactVector(y)},
                   w.empty() ? ExactVector() : ExactVector(w));
  }
  std::string text() const {
    std::string result = shape.domain == Domain::triangle ? "triangle " : "square ";
    result += std::to_string(shape.degree(0)) + " " + std::to_string(shape.degree(1)) + ":";
    for (std::size_t i = 0; i < x.size(); ++i) {
      result +=
          " (" + to_string(x[i]) + "," + to_string(y[i]) + (w.empty() ? "" : "," + to_string(w[i])) + ")";
    }
    return result;
  }
};

/// The identity map of a shape, its control net scaled to integers: column and row times `unit`.
inline RawElement straight(Shape shape, long unit) {
  RawElement result{shape, {}, {}, {}};
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      result.x.emplace_back(c * unit);
      result.y.emplace_back(r * unit);
    }
  }
  return result;
}

struct Recipe {
  int max_degree = 5;
  bool quadrilaterals = true;
  bool rationals = true;
};

/// A straight net, perturbed by up to none, some or much of its spacing, sheared, and sometimes mirrored:
/// injective, folded, reversed and exactly degenerate elements all are frequent.
inline RawElement random_element(Random& random, const Recipe& recipe) {
  const bool quad = recipe.quadrilaterals && random.chance(30);
  const int p = static_cast<int>(random.integer(1, recipe.max_degree));
  const int q = quad ? static_cast<int>(random.integer(1, std::min(recipe.max_degree, 3))) : 0;
  constexpr long unit = 12;
  RawElement e = straight({quad ? Domain::square : Domain::triangle, quad ? std::min(p, 3) : p, q}, unit);
  const std::array<long, 5> sizes = {2, 4, 7, 12, 24};
  const long size = sizes[static_cast<std::size_t>(random.integer(0, 4))];
  for (auto* values : {&e.x, &e.y}) {
    for (Rational& value : *values) value += random.integer(-size, size);
  }
  const long shear = random.integer(-2, 2);
  for (std::size_t i = 0; i < e.x.size(); ++i) e.x[i] += shear * e.y[i];
  if (random.chance(15)) {
    for (Rational& value : e.x) value = -value;
  }
  if (random.chance(10)) {  // flattened: degenerate or reversed corners
    for (Rational& value : e.y) value = Rational(floor(value / unit) * unit);
  }
  if (recipe.rationals && random.chance(50)) {
    for (std::size_t i = 0; i < e.x.size(); ++i)
      e.w.push_back(Rational(random.integer(1, 8), random.integer(1, 4)));
  }
  return e;
}

/// x -> a x + b y + e, y -> c x + d y + f.
inline RawElement affine(RawElement element, const std::array<Rational, 6>& m) {
  for (std::size_t i = 0; i < element.x.size(); ++i) {
    const Rational x = element.x[i];
    const Rational y = element.y[i];
    element.x[i] = m[0] * x + m[1] * y + m[4];
    element.y[i] = m[2] * x + m[3] * y + m[5];
  }
  return element;
}

/// The same element with corner 1 as corner 0 and so on: same orientation, same image.
inline RawElement rotate_corners(const RawElement& e) {
  RawElement result = e;
  const Shape s = e.shape;
  if (s.domain == Domain::square) result.shape = Shape::square(s.degree(1), s.degree(0));
  for (int r = 0; r < row_count(s); ++r) {
    for (int c = 0; c < column_count(s, r); ++c) {
      const std::size_t from = coefficient_index(s, r, c);
      // Triangle: exponents (i, j, k) -> (j, k, i). Square: (u, v) -> (v, 1 - u).
      const std::size_t to = s.domain == Domain::triangle
                                 ? coefficient_index(s, s.degree(0) - r - c, r)
                                 : coefficient_index(result.shape, s.degree(0) - c, r);
      result.x[to] = e.x[from];
      result.y[to] = e.y[from];
      if (!e.w.empty()) result.w[to] = e.w[from];
    }
  }
  return result;
}

/// Exchanges u and v: the orientation turns over.
inline RawElement swap_parameters(const RawElement& e) {
  RawElement result = e;
  const Shape s = e.shape;
  if (s.domain == Domain::square) result.shape = Shape::square(s.degree(1), s.degree(0));
  for (int r = 0; r < row_count(s); ++r) {
    for (int c = 0; c < column_count(s, r); ++c) {
      const std::size_t from = coefficient_index(s, r, c);
      const std::size_t to = coefficient_index(result.shape, c, r);
      result.x[to] = e.x[from];
      result.y[to] = e.y[from];
      if (!e.w.empty()) result.w[to] = e.w[from];
    }
  }
  return result;
}

inline RawElement scale_weights(RawElement e, const Rational& factor) {
  for (Rational& weight : e.w) weight *= factor;
  return e;
}

/// w_ijk times a^i b^j c^k (triangle) or b^column c^row (square): the same image, reparametrised.
/// Precondition: the element has weights.
inline RawElement reparametrise(RawElement e, const Rational& a, const Rational& b, const Rational& c) {
  const Shape s = e.shape;
  for (int row = 0; row < row_count(s); ++row) {
    for (int column = 0; column < column_count(s, row); ++column) {
      Rational factor = power(b, column) * power(c, row);
      if (s.domain == Domain::triangle) factor *= power(a, s.degree(0) - row - column);
      e.w[coefficient_index(s, row, column)] *= factor;
    }
  }
  return e;
}

/// The same map with one degree more.
inline RawElement elevate_element(const RawElement& e) {
  std::vector<Rational> w = e.w.empty() ? std::vector<Rational>(e.x.size(), Rational(1)) : e.w;
  const auto lifted = [&](const std::vector<Rational>& values) {
    std::vector<Rational> homogeneous;
    for (std::size_t i = 0; i < values.size(); ++i) homogeneous.push_back(values[i] * w[i]);
    return elevate(Polynomial<Rational>(e.shape, homogeneous));
  };
  const Polynomial<Rational> x = lifted(e.x);
  const Polynomial<Rational> y = lifted(e.y);
  const Polynomial<Rational> weights = lifted(std::vector<Rational>(e.x.size(), Rational(1)));
  RawElement result{x.shape, {}, {}, {}};
  for (std::size_t i = 0; i < x.coefficients.size(); ++i) {
    result.x.push_back(x.coefficients[i] / weights.coefficients[i]);
    result.y.push_back(y.coefficients[i] / weights.coefficients[i]);
    if (!e.w.empty()) result.w.push_back(weights.coefficients[i]);
  }
  return result;
}

/// A random parameter of the closed domain with small denominators.
inline Parameter random_parameter(Random& random, Domain domain) {
  const long n = random.integer(1, 40);
  if (domain == Domain::square) {
    return {domain, {Rational(random.integer(0, n), n), Rational(random.integer(0, n), n)}};
  }
  const long a = random.integer(0, n);
  const long b = random.integer(0, n - a);
  return {domain, {Rational(a, n), Rational(b, n), Rational(n - a - b, n)}};
}

}  // namespace bezcert::test
