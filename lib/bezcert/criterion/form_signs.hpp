// What conditions ask of the control net of a triangle, answered from the forms of an element: intervals,
// then integers. A condition is a template over this class and QuickNet, which answers the same of fewer
// nets:
//   degree(), rational()      rational: the weights differ;
//   turn(a, b, c, d)          the sign of (p_b - p_a) x (p_d - p_c);
//   forward(a, b, c, d)       the sign of (p_b - p_a) . (p_d - p_c);
//   orientation(a, b, c)      the orientation of three points;
//   equal_weights(a, b)       whether two points have the same weight;
//   auxiliary(edge, j)        p'_j = (1 - w_j) o + w_j p_j, for weights divided by that of the tip, which
//   both
//                             ends must have; o is the middle of the ends. p_j where not rational.
// Points are positions in the net, or what `auxiliary` gives. All signs are exact.
#pragma once

#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/element/forms.hpp"

namespace bezcert {

class FormSigns {
 public:
  /// Keeps a reference. Precondition: a triangle.
  explicit FormSigns(const Forms& forms) : forms_(forms) {}

  int degree() const { return forms_.element().shape().degree(0); }
  bool rational() const { return forms_.element().rational(); }

  int turn(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    return forms_.sign_of([&](const auto& net) { return cross(between(net, a, b), between(net, c, d)); });
  }
  int forward(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    return forms_.sign_of([&](const auto& net) { return dot(between(net, a, b), between(net, c, d)); });
  }
  int orientation(std::size_t a, std::size_t b, std::size_t c) const {
    return forms_.sign_of([&](const auto& net) { return bezcert::orientation(net, a, b, c); });
  }
  bool equal_weights(std::size_t a, std::size_t b) const {
    return !rational() ||
           forms_.sign_of([&](const auto& net) { return net.weights[a] - net.weights[b]; }) == 0;
  }
  std::size_t auxiliary(int edge, int j) const {
    if (!rational()) return edge_index(forms_.element().shape(), edge, 0, j);
    return coefficient_count(forms_.element().shape()) + static_cast<std::size_t>(edge * (degree() + 1) + j);
  }

 private:
  template <class T>
  struct Point {
    T x, y, w;  // homogeneous: w times the point, w > 0
  };

  template <class T>
  static Point<T> point(const Net<T>& net, std::size_t a) {
    const std::vector<T>&x = net.coordinates[0], &y = net.coordinates[1], &w = net.weights;
    if (a < x.size()) return {x[a], y[a], w[a]};
    // With omega the weight of the tip and of both ends, X = w p:
    // 2 omega^2 p'_j = (omega - w_j) (X_0 + X_n) + 2 omega X_j.
    const int n = net.shape.degree(0), place = static_cast<int>(a - x.size()), edge = place / (n + 1);
    const std::size_t first = edge_index(net.shape, edge, 0, 0), last = edge_index(net.shape, edge, 0, n),
                      at = edge_index(net.shape, edge, 0, place % (n + 1));
    const T& omega = w[edge_index(net.shape, edge, n, 0)];
    const T missing = omega - w[at], twice = T(2) * omega;
    return {missing * (x[first] + x[last]) + twice * x[at], missing * (y[first] + y[last]) + twice * y[at],
            twice * omega};
  }

  // p_b - p_a times a positive number.
  template <class T>
  static Vector2<T> between(const Net<T>& net, std::size_t a, std::size_t b) {
    if (!net.rational()) {
      return {net.coordinates[0][b] - net.coordinates[0][a], net.coordinates[1][b] - net.coordinates[1][a]};
    }
    const Point<T> p = point(net, a), q = point(net, b);
    return {q.x * p.w - p.x * q.w, q.y * p.w - p.y * q.w};
  }

  const Forms& forms_;
};

}  // namespace bezcert
