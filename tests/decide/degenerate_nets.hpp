// Random nets of degrees 2 to 4, many of them degenerate on purpose.
#pragma once

#include "random_element.hpp"

#include <map>
#include <optional>
#include <string>

namespace bezcert::test {

/// A polynomial in s and t: the factor of s^i t^k by (i, k).
using Powers = std::map<std::pair<int, int>, Rational>;

inline Powers operator+(Powers f, const Powers& g) {
  for (const auto& [exponents, c] : g) f[exponents] += c;
  return f;
}
inline Powers operator*(const Powers& f, const Powers& g) {
  Powers result;
  for (const auto& [a, x] : f) {
    for (const auto& [b, y] : g) result[{a.first + b.first, a.second + b.second}] += x * y;
  }
  return result;
}
inline Powers constant_powers(const Rational& c) { return {{{0, 0}, c}}; }
inline Powers linear(const Rational& a, const Rational& s, const Rational& t) {
  return {{{0, 0}, a}, {{1, 0}, s}, {{0, 1}, t}};
}

/// The integral over t from 0.
inline Powers integral(const Powers& g) {
  Powers result;
  for (const auto& [e, c] : g) result[{e.first, e.second + 1}] = c / Rational(e.second + 1);
  return result;
}

/// Bernstein coefficients: s^a t^b has j!/(j-a)! k!/(k-b)! (n-a-b)!/n! at (j, k) of the triangle.
inline std::vector<Rational> bernstein_coefficients(Shape shape, const Powers& f) {
  const auto falling = [](int n, int k) {
    Rational result = 1;
    for (int i = 0; i < k; ++i) result *= n - i;
    return result;
  };
  std::vector<Rational> result;
  for (int k = 0; k < row_count(shape); ++k) {
    for (int j = 0; j < column_count(shape, k); ++j) {
      Rational sum = 0;
      for (const auto& [e, c] : f) {
        const auto [a, b] = e;
        const Rational below = shape.domain == Domain::triangle
                                   ? falling(shape.degree(0), a + b)
                                   : Rational(falling(shape.degree(0), a) * falling(shape.degree(1), b));
        if (!c.is_zero()) sum += c * falling(j, a) * falling(k, b) / below;
      }
      result.push_back(sum);
    }
  }
  return result;
}

/// A net and what is known of it by construction.
struct TestNet {
  RawElement element;
  std::string kind;
  std::optional<int> dimension;  ///< of the zero set, if it is degenerate (or was, before a mirror)
  bool positive = false;         ///< det J > 0
  bool nonnegative = false;      ///< det J >= 0
  bool injective = false;        ///< if regular, then injective
  bool mirrored = false;
};

inline TestNet without_facts(RawElement element, std::string kind) {
  TestNet net;
  net.element = std::move(element);
  net.kind = std::move(kind);
  return net;
}

inline Shape random_shape(Random& random, int degree) {
  if (random.chance(70)) return Shape::triangle(degree);
  return Shape::square(degree, static_cast<int>(random.integer(2, degree)));
}

inline void random_weights(Random& random, RawElement& e) {
  for (std::size_t i = 0; i < e.x.size(); ++i) e.w.emplace_back(random.integer(1, 4));
}

inline Rational random_fraction(Random& random) {
  constexpr std::array<long, 6> denominators = {3, 5, 7, 6, 4, 9};
  const long d = denominators[static_cast<std::size_t>(random.integer(0, 5))];
  return Rational(random.integer(0, d), d);
}

/// Small integers anywhere.
inline TestNet small_net(Random& random) {
  RawElement e = straight(random_shape(random, static_cast<int>(random.integer(2, 4))), 1);
  const long size = random.integer(1, 4);
  for (auto* values : {&e.x, &e.y}) {
    for (Rational& value : *values) value = random.integer(-size, size);
  }
  if (random.chance(30)) random_weights(random, e);
  return without_facts(std::move(e), "small");
}

/// A straight net of small spacing, some of its points moved.
inline TestNet grid_net(Random& random) {
  RawElement e = straight(random_shape(random, static_cast<int>(random.integer(2, 4))), random.integer(1, 4));
  const int share = static_cast<int>(random.integer(10, 90));
  for (auto* values : {&e.x, &e.y}) {
    for (Rational& value : *values) {
      if (random.chance(share)) value += random.integer(-1, 1);
    }
  }
  if (random.chance(40)) random_weights(random, e);
  if (random.chance(10)) e = swap_parameters(e);
  return without_facts(std::move(e), "grid");
}

/// Points that fall together: at a corner, along an edge, anywhere; or all on a line or a parabola.
inline TestNet collapsed_net(Random& random) {
  TestNet net = grid_net(random);
  net.kind = "collapsed";
  RawElement& e = net.element;
  const Shape s = e.shape;
  const auto copy = [&](std::size_t to, std::size_t from) {
    e.x[to] = e.x[from];
    e.y[to] = e.y[from];
  };
  switch (random.integer(0, 4)) {
    case 0: copy(0, 1); break;
    case 1:
      for (int c = 1; c <= s.degree(0); ++c) copy(coefficient_index(s, 0, c), 0);
      break;
    case 2:
      for (int k = 0; k < 3; ++k) {
        const long last = static_cast<long>(e.x.size()) - 1;
        copy(static_cast<std::size_t>(random.integer(0, last)),
             static_cast<std::size_t>(random.integer(0, last)));
      }
      break;
    case 3: {  // the tangents at corner 0 in one line
      const std::size_t above = coefficient_index(s, 1, 0);
      const Rational factor = random.integer(-1, 2);
      e.x[above] = e.x[0] + factor * (e.x[1] - e.x[0]);
      e.y[above] = e.y[0] + factor * (e.y[1] - e.y[0]);
      break;
    }
    default: {
      const long a = random.integer(-2, 2);
      for (std::size_t i = 0; i < e.x.size(); ++i) e.y[i] = a * e.x[i] + 1;
      net.dimension = 2;
    }
  }
  return net;
}

/// x = s, y = integral of g dt + h(s): det J = g, and the map is injective wherever it is regular.
inline TestNet prescribed_net(Random& random) {
  const int n = static_cast<int>(random.integer(2, 4));
  const bool triangle = random.chance(60);
  const Shape shape = triangle ? Shape::triangle(n) : Shape::square(n, n);
  TestNet net;
  net.injective = true;
  const Rational p = random_fraction(random);
  const Rational q = triangle ? random_fraction(random) * (1 - p) : random_fraction(random);
  const bool inside = p > 0 && q > 0 && (triangle ? p + q < 1 : p < 1 && q < 1);
  const auto line = [&] {  // through (p, q)
    long b = 0, c = 0;
    while (b == 0 && c == 0) {
      b = random.integer(-3, 3);
      c = random.integer(-3, 3);
    }
    return linear(-b * p - c * q, b, c);
  };
  Powers g;
  if (n == 2) {
    g = linear(random.integer(0, 2), random.integer(-2, 3), random.integer(-2, 3));
    if (!triangle) g[{2, 0}] = random.integer(-1, 2);
  } else {
    const Powers first = line(), second = line();
    switch (random.integer(0, triangle ? 2 : 4)) {
      case 0:
        g = first * first;
        net.nonnegative = true;
        if (inside) net.dimension = 1;
        break;
      case 1: {
        g = first * first + second * second;
        net.nonnegative = true;
        const Rational b1 = first.at({1, 0}), c1 = first.at({0, 1}), b2 = second.at({1, 0}),
                       c2 = second.at({0, 1});
        if (inside || b1 * c2 != b2 * c1) net.dimension = b1 * c2 == b2 * c1 ? 1 : 0;
        break;
      }
      case 2: g = first * second; break;
      default: {
        // A quadratic in s: zeros at square roots.
        Powers quadratic = {{{2, 0}, random.integer(-6, 6)},
                            {{1, 0}, random.integer(-6, 6)},
                            {{0, 0}, random.integer(-2, 2)}};
        net.nonnegative = true;
        const Powers vertical = linear(-q, 0, 1);
        if (n == 4 && random.chance(50)) {
          g = quadratic * quadratic + vertical * vertical;
          const bool is_zero =
              quadratic[{2, 0}].is_zero() && quadratic[{1, 0}].is_zero() && quadratic[{0, 0}].is_zero();
          net.dimension = is_zero ? 1 : 0;
        } else if (n == 4) {
          quadratic[{0, 1}] = -random.integer(1, 5);
          g = quadratic * quadratic;  // along a parabola
        } else {
          g = linear(-p * q, 0, 0) + Powers{{{1, 1}, 1}};  // along a hyperbola
          g = g * g;
          if (inside) net.dimension = 1;
        }
      }
    }
    if (n == 4 && triangle) {
      switch (random.integer(0, 3)) {
        case 0: break;
        case 1: g = g * linear(1, random.integer(0, 2), random.integer(0, 3)); break;
        case 2:
          g = g * (random.chance(50) ? linear(0, 0, 1) : linear(1, -1, -1));
          net.dimension = 1;  // an edge, whatever the other factor does
          break;
        default:
          g = g * linear(random.integer(-1, 2), random.integer(-2, 2), random.integer(-2, 2));
          net.nonnegative = false;
          net.dimension.reset();
      }
    }
  }
  if (random.chance(40)) {
    constexpr std::array<int, 4> digits = {1, 3, 6, 12};
    const Rational shift = 1 / power(10, digits[static_cast<std::size_t>(random.integer(0, 3))]);
    const bool up = random.chance(50);
    g = g + constant_powers(up ? shift : Rational(-shift));
    net.positive = up && net.nonnegative;
    net.nonnegative = net.positive;
    net.dimension.reset();
  }
  Powers y = integral(g);
  for (int k = 1; k <= n; ++k) y[{k, 0}] += random.integer(-2, 2);
  net.element = {shape, bernstein_coefficients(shape, {{{1, 0}, 1}}), bernstein_coefficients(shape, y), {}};
  net.kind = "prescribed";
  return net;
}

/// z -> f(z) with a complex polynomial f, z = s + i t or another such: det J = |f'|^2, isolated zeros.
inline TestNet conformal_net(Random& random) {
  const int n = static_cast<int>(random.integer(2, 4));
  const Shape shape = random.chance(70) ? Shape::triangle(n) : Shape::square(n, n);
  // Coefficients of the derivative, as pairs (real, imaginary).
  using Complex = std::pair<Rational, Rational>;
  const auto times = [](const Complex& a, const Complex& b) {
    return Complex{a.first * b.first - a.second * b.second, a.first * b.second + a.second * b.first};
  };
  std::vector<Complex> slope = {{1, 0}};
  const auto multiply_by = [&](const std::vector<Complex>& factor) {
    std::vector<Complex> result(slope.size() + factor.size() - 1, {0, 0});
    for (std::size_t i = 0; i < slope.size(); ++i) {
      for (std::size_t j = 0; j < factor.size(); ++j) {
        const Complex c = times(slope[i], factor[j]);
        result[i + j].first += c.first;
        result[i + j].second += c.second;
      }
    }
    slope = std::move(result);
  };
  while (static_cast<int>(slope.size()) < n) {
    if (static_cast<int>(slope.size()) + 2 <= n && random.chance(50)) {
      // (z - c)^2 - a: square roots.
      const Rational re = random_fraction(random) / 2, im = random_fraction(random) / 2;
      const Complex square = times({re, im}, {re, im});
      multiply_by({{square.first - Rational(random.integer(-2, 2), 16),
                    square.second - Rational(random.integer(-1, 1), 16)},
                   {-2 * re, -2 * im},
                   {1, 0}});
    } else {
      const Rational re = random_fraction(random);
      multiply_by({{-re, -random_fraction(random) * (1 - re) + (random.chance(30) ? 1 : 0)}, {1, 0}});
    }
  }
  Powers x, y, power_re = constant_powers(1), power_im;
  const Powers re = linear(0, 1, 0), im = linear(0, 0, 1);
  for (std::size_t k = 0; k < slope.size(); ++k) {
    const Powers next_re = power_re * re + constant_powers(-1) * power_im * im;
    power_im = power_re * im + power_im * re;
    power_re = next_re;
    const Rational a = slope[k].first / Rational(static_cast<long>(k) + 1),
                   b = slope[k].second / Rational(static_cast<long>(k) + 1);
    x = x + constant_powers(a) * power_re + constant_powers(-b) * power_im;
    y = y + constant_powers(a) * power_im + constant_powers(b) * power_re;
  }
  TestNet net;
  net.element = {shape, bernstein_coefficients(shape, x), bernstein_coefficients(shape, y), {}};
  net.kind = "conformal";
  net.nonnegative = true;
  net.dimension = 0;
  return net;
}

/// One of all those, then perhaps turned, mirrored, sheared or made rational.
inline TestNet test_net(Random& random) {
  const long choice = random.integer(1, 100);
  TestNet net = choice <= 15   ? small_net(random)
                : choice <= 40 ? grid_net(random)
                : choice <= 55 ? collapsed_net(random)
                : choice <= 85 ? prescribed_net(random)
                               : conformal_net(random);
  RawElement& e = net.element;
  if (e.w.empty() && random.chance(12) &&
      (e.shape.domain == Domain::triangle ? e.shape.degree(0) <= 3 : e.shape.degree(0) <= 2)) {
    e.w.assign(e.x.size(), Rational(1));
    const auto factor = [&] { return Rational(random.integer(1, 3)); };
    e = reparametrise(e, factor(), factor(), factor());
  }
  if (random.chance(30)) e = rotate_corners(e);
  if (random.chance(30)) {
    std::array<Rational, 6> m;
    for (Rational& value : m) value = random.integer(-2, 2);
    if (m[0] * m[3] - m[1] * m[2] > 0) e = affine(e, m);
  }
  if (random.chance(15)) {
    e = random.chance(50) ? swap_parameters(e) : affine(e, {-1, 0, 0, 1, 0, 0});
    net.mirrored = true;
  }
  return net;
}

}  // namespace bezcert::test
