// The definition of the Bernstein form, term by term: f(x) = sum of c_m degree!/m! x^m. Nothing of the
// library's own evaluation; only the order of coefficients is taken from shape.hpp.
#pragma once

#include "random_input.hpp"

#include "bezcert/bernstein/polynomial.hpp"
#include "bezcert/number/rational.hpp"

#include <string>
#include <vector>

namespace bezcert::test {

inline Integer factorial(int n) {
  Integer result = 1;
  for (int k = 2; k <= n; ++k) result *= k;
  return result;
}
inline Integer choose(int n, int k) { return factorial(n) / (factorial(k) * factorial(n - k)); }

/// 1, x, ..., x^n.
inline std::vector<Rational> powers(const Rational& x, int n) {
  std::vector<Rational> result{Rational(1)};
  for (int k = 0; k < n; ++k) result.push_back(result.back() * x);
  return result;
}

/// The basis functions of a shape at a parameter, in coefficient order.
inline std::vector<Rational> basis_values(Shape shape, const std::vector<Rational>& at) {
  std::vector<Rational> values;
  if (shape.domain == Domain::triangle) {
    const auto x = powers(at[0], shape.degree(0));
    const auto y = powers(at[1], shape.degree(0));
    const auto z = powers(at[2], shape.degree(0));
    for (int k = 0; k <= shape.degree(0); ++k) {
      for (int j = 0; j + k <= shape.degree(0); ++j) {
        const int i = shape.degree(0) - j - k;
        const Integer factor = factorial(shape.degree(0)) / (factorial(i) * factorial(j) * factorial(k));
        values.push_back(Rational(factor) * x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)] *
                         z[static_cast<std::size_t>(k)]);
      }
    }
    return values;
  }
  const auto line = [](int n, const Rational& t) {
    const auto left = powers(1 - t, n);
    const auto right = powers(t, n);
    std::vector<Rational> result;
    for (int k = 0; k <= n; ++k) {
      result.push_back(Rational(choose(n, k)) * left[static_cast<std::size_t>(n - k)] *
                       right[static_cast<std::size_t>(k)]);
    }
    return result;
  };
  const auto along_u = line(shape.degree(0), at[0]);
  if (shape.domain == Domain::segment) return along_u;
  for (const Rational& b : line(shape.degree(1), at[1])) {
    for (const Rational& a : along_u) values.push_back(a * b);
  }
  return values;
}

/// The value of a polynomial with rational or integer coefficients.
template <class T>
Rational explicit_value(const Polynomial<T>& f, const std::vector<Rational>& at) {
  const auto basis = basis_values(f.shape, at);
  Rational sum = 0;
  for (std::size_t m = 0; m < basis.size(); ++m) sum += Rational(f.coefficients.at(m)) * basis[m];
  return sum;
}

inline std::size_t parameter_count(Domain domain) {
  return domain == Domain::segment ? 1 : domain == Domain::triangle ? 3 : 2;
}

/// A parameter inside the domain, or of its surroundings (barycentric ones sum to 1 in both cases).
inline std::vector<Rational> random_parameter(Random& random, Domain domain, bool inside = false) {
  const long denominator = random.integer(1, 40);
  const long low = inside ? 0 : -denominator;
  const long high = inside ? denominator : 2 * denominator;
  const auto fraction = [denominator](long p) { return Rational(p) / denominator; };
  const long a = random.integer(low, high);
  if (domain == Domain::segment) return {fraction(a)};
  if (domain == Domain::square) return {fraction(a), fraction(random.integer(low, high))};
  const long b = random.integer(low, inside ? denominator - a : high);
  return {fraction(denominator - a - b), fraction(a), fraction(b)};
}

inline Rational random_coefficient(Random& random) {
  const long p = random.integer(-60, 60);
  return Rational(p) / random.integer(1, 12);
}

inline Polynomial<Rational> random_polynomial(Random& random, Shape shape) {
  Polynomial<Rational> f(shape);
  for (Rational& c : f.coefficients) c = random_coefficient(random);
  return f;
}

inline Polynomial<Integer> random_integer_polynomial(Random& random, Shape shape, long size = 1000) {
  Polynomial<Integer> f(shape);
  for (Integer& c : f.coefficients) c = random.integer(-size, size);
  return f;
}

inline Polynomial<Rational> as_rational(const Polynomial<Integer>& f) {
  Polynomial<Rational> result(f.shape);
  for (std::size_t m = 0; m < f.coefficients.size(); ++m)
    result.coefficients[m] = Rational(f.coefficients[m]);
  return result;
}

/// All segments and triangles of degrees 0..highest, and all squares of degrees 0..highest in u and v.
inline std::vector<Shape> all_shapes(int highest) {
  std::vector<Shape> shapes;
  for (int p = 0; p <= highest; ++p) {
    shapes.push_back(Shape::segment(p));
    shapes.push_back(Shape::triangle(p));
    for (int q = 0; q <= highest; ++q) shapes.push_back(Shape::square(p, q));
  }
  return shapes;
}

inline std::string show(Shape shape) {
  const char* name = shape.domain == Domain::segment    ? "segment"
                     : shape.domain == Domain::triangle ? "triangle"
                                                        : "square";
  return std::string(name) + " " + std::to_string(shape.degree(0)) + "," + std::to_string(shape.degree(1));
}

inline std::string show(const std::vector<Rational>& numbers) {
  std::string text = "(";
  for (const Rational& x : numbers) text += (text.size() > 1 ? ", " : "") + x.str();
  return text + ")";
}

}  // namespace bezcert::test
