// Random control nets of stated kinds.
#pragma once

#include "element/direct_map.hpp"

#include <cmath>

namespace bezcert::test {

enum class Points { small_integers, near_identity, loose_identity, doubles, fractions };
enum class Weights { none, equal, small_integers, doubles, fractions };

inline constexpr Points all_points[] = {Points::small_integers, Points::near_identity, Points::loose_identity,
                                        Points::doubles, Points::fractions};
inline constexpr Weights all_weights[] = {Weights::none, Weights::equal, Weights::small_integers,
                                          Weights::doubles, Weights::fractions};

inline bool really_rational(const ControlNet& net) {
  for (const Rational& w : net.w) {
    if (w != net.w.front()) return true;
  }
  return false;
}

/// Points of a regular grid over the domain: the identity map, times `scale`.
inline ControlNet identity_net(Shape shape, long scale = 1) {
  ControlNet net;
  net.shape = shape;
  for (const auto& [r, c] : rows_and_columns(shape)) {
    net.x.push_back(Rational(c * scale) / shape.degree(0));
    net.y.push_back(Rational(r * scale) /
                    (shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1)));
  }
  return net;
}

inline ControlNet random_net(Random& random, Shape shape, Points points, Weights weights) {
  ControlNet net = identity_net(shape);
  const auto fraction = [&random](long low, long high) {
    const long q = random.integer(1, 30);
    return Rational(random.integer(low * q, high * q)) / q;
  };
  const auto coordinate = [&](const Rational& grid, int degree) -> Rational {
    switch (points) {
      case Points::small_integers: return Rational(random.integer(-2, 2));
      case Points::near_identity: return grid * (4 * degree) + random.integer(-1, 1);
      case Points::loose_identity: return grid * (2 * degree) + random.integer(-1, 1);
      case Points::doubles: return Rational(random.any_double(-4, 4));
      case Points::fractions: return fraction(-3, 3);
    }
    return 0;
  };
  for (std::size_t m = 0; m < net.x.size(); ++m) {
    net.x[m] = coordinate(net.x[m], shape.degree(0));
    net.y[m] = coordinate(net.y[m], shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1));
  }
  if (weights == Weights::none) return net;
  const Rational common = fraction(1, 4);
  for (std::size_t m = 0; m < net.x.size(); ++m) {
    switch (weights) {
      case Weights::small_integers: net.w.push_back(Rational(random.integer(1, 4))); break;
      case Weights::doubles:
        net.w.push_back(Rational(std::ldexp(static_cast<double>(random.integer(1L << 50, 1L << 53)), -52)));
        break;
      case Weights::fractions: net.w.push_back(fraction(1, 3)); break;
      default: net.w.push_back(common);
    }
  }
  return net;
}

/// The net under a random affine map of determinant not 0 with entries that are no doubles: the sign pattern
/// of N stays (all signs turn if the map reflects), but nothing is exact in double any more.
inline void skew(Random& random, ControlNet& net) {
  const auto entry = [&random] { return Rational(random.integer(-20, 20)) / 21; };
  Rational a, b, c, d;
  while (a * d - b * c == 0) {
    a = entry();
    b = entry();
    c = entry();
    d = entry();
  }
  for (std::size_t m = 0; m < net.x.size(); ++m) {
    const Rational x = net.x[m];
    const Rational y = net.y[m];
    net.x[m] = a * x + b * y + Rational(1, 3);
    net.y[m] = c * x + d * y - Rational(1, 7);
  }
}

/// Moves one coordinate by about 2^-70: far less than doubles resolve.
inline void nudge(Random& random, ControlNet& net) {
  const auto m = static_cast<std::size_t>(random.integer(0, static_cast<long>(net.x.size()) - 1));
  const Rational tiny = Rational(random.integer(-1, 1)) / Rational(Integer(1) << 70);
  (random.chance(50) ? net.x : net.y)[m] += tiny;
}

/// Multiplies all coordinates by a power of two near the ends of the doubles' range: squares overflow or
/// vanish.
inline void stretch(Random& random, ControlNet& net) {
  const long exponent = random.integer(500, 1015);
  const Integer factor = Integer(1) << static_cast<unsigned>(exponent);
  const bool up = random.chance(50);
  for (auto* coordinates : {&net.x, &net.y}) {
    for (Rational& c : *coordinates) c = up ? Rational(c * Rational(factor)) : Rational(c / Rational(factor));
  }
}

/// Makes an element degenerate in one of several ways: a point twice, a corner without tangent, two edges of
/// a corner on a line, or all points on a line.
inline void degenerate(Random& random, ControlNet& net) {
  const auto last = static_cast<long>(net.x.size()) - 1;
  const std::size_t next_row = net.shape.degree(0) + 1U;
  const auto copy_point = [&](std::size_t to, std::size_t from) {
    net.x[to] = net.x[from];
    net.y[to] = net.y[from];
  };
  switch (random.integer(0, 3)) {
    case 0: copy_point(static_cast<std::size_t>(random.integer(0, last)), 0); break;
    case 1: copy_point(1, 0); break;
    case 2:
      net.x[next_row] = 2 * net.x[0] - net.x[1];
      net.y[next_row] = 2 * net.y[0] - net.y[1];
      break;
    default: net.y = net.x;
  }
}

/// An element with det J = g: x = u, y = the integral of g along v from the edge v = 0. Its degree along v is
/// one more than that of g; on a square g must not be constant in u.
inline ControlNet net_with_determinant(const Polynomial<Rational>& g) {
  Shape shape = g.shape;
  shape = shape.raised(shape.factor_count() - 1, 1);
  const int along_v = shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1);
  ControlNet net = identity_net(shape);
  for (const auto& [r, c] : rows_and_columns(shape)) {
    const std::size_t m = coefficient_index(shape, r, c);
    net.y[m] =
        r == 0 ? Rational(0) : Rational(net.y[coefficient_index(shape, r - 1, c)] + g.at(r - 1, c) / along_v);
  }
  return net;
}

/// (a l1^2 + b l2^2 + c) with l1, l2 vanishing together at a point of the domain with small denominators: an
/// isolated zero, or a line of zeros where b = 0, raised or lowered by c.
inline Polynomial<Rational> touching_polynomial(Random& random, Domain domain, const Rational& c) {
  const Shape linear(domain, 1, 1);
  const long denominator = random.integer(2, 8);
  const Rational u = Rational(random.integer(0, denominator)) / denominator;
  const Rational v = domain == Domain::triangle
                         ? Rational((1 - u) * random.integer(0, 2) / 2)
                         : Rational(Rational(random.integer(0, denominator)) / denominator);
  Polynomial<Rational> l1(linear), l2(linear);
  const std::size_t count = coefficient_count(linear);
  for (std::size_t m = 0; m < count; ++m) {
    const bool right = m == 1 || (m == 3 && domain == Domain::square);
    const bool top = m >= 2;
    l1.coefficients[m] = (right ? 1 : 0) - u;
    l2.coefficients[m] = (top ? 1 : 0) - v;
  }
  const Polynomial<Rational> first = multiply(l1, l1);
  const Polynomial<Rational> second = multiply(l2, l2);
  const Rational a(random.integer(1, 3));
  const Rational b(random.integer(0, 3));
  Polynomial<Rational> g = first;
  for (std::size_t m = 0; m < g.coefficients.size(); ++m) {
    g.coefficients[m] = a * first.coefficients[m] + b * second.coefficients[m] + c;
  }
  return g;
}

inline Points random_points(Random& random) { return all_points[random.integer(0, 4)]; }
inline Weights random_weights(Random& random) { return all_weights[random.integer(0, 4)]; }

/// Triangles of degrees 1..triangle_degree and squares of all degrees 1..square_degree.
inline std::vector<Shape> element_shapes(int triangle_degree, int square_degree) {
  std::vector<Shape> shapes;
  for (int n = 1; n <= triangle_degree; ++n) shapes.push_back(Shape::triangle(n));
  for (int p = 1; p <= square_degree; ++p) {
    for (int q = 1; q <= square_degree; ++q) shapes.push_back(Shape::square(p, q));
  }
  return shapes;
}

}  // namespace bezcert::test
