// Random control nets of stated kinds.
#pragma once

#include "element/direct_map.hpp"

namespace bezcert::test {

enum class Points { small_integers, near_identity, doubles, fractions };
enum class Weights { none, equal, small_integers, doubles, fractions };

inline constexpr Points all_points[] = {Points::small_integers, Points::near_identity, Points::doubles,
                                        Points::fractions};
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
    net.x.push_back(Rational(c * scale) / shape.p);
    net.y.push_back(Rational(r * scale) / (shape.domain == Domain::triangle ? shape.p : shape.q));
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
      case Points::doubles: return Rational(random.any_double(-4, 4));
      case Points::fractions: return fraction(-3, 3);
    }
    return 0;
  };
  for (std::size_t m = 0; m < net.x.size(); ++m) {
    net.x[m] = coordinate(net.x[m], shape.p);
    net.y[m] = coordinate(net.y[m], shape.domain == Domain::triangle ? shape.p : shape.q);
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

inline Points random_points(Random& random) { return all_points[random.integer(0, 3)]; }
inline Weights random_weights(Random& random) { return all_weights[random.integer(0, 4)]; }

/// Triangles of degrees 1..triangle_degree and squares of all degrees 1..square_degree.
inline std::vector<Shape> element_shapes(int triangle_degree, int square_degree) {
  std::vector<Shape> shapes;
  for (int n = 1; n <= triangle_degree; ++n) shapes.push_back({Domain::triangle, n, 0});
  for (int p = 1; p <= square_degree; ++p) {
    for (int q = 1; q <= square_degree; ++q) shapes.push_back({Domain::square, p, q});
  }
  return shapes;
}

}  // namespace bezcert::test
