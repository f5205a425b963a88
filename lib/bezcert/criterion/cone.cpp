#include "bezcert/criterion/cone.hpp"

#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/curve/vector.hpp"
#include "bezcert/element/forms.hpp"

namespace bezcert {
namespace {

// The net as seen from one edge. Vectors come multiplied by positive factors: homogeneous coordinates are
// X = w p, and omega is the weight of the tip. Every method is an expression in +, -, * over T.
template <class T>
class EdgeView {
 public:
  EdgeView(const Net<T>& net, int edge) : net_(net), edge_(edge) {}

  int degree() const { return net_.shape.degree(0); }

  // Row i away from the edge, place j along it.
  std::size_t index(int i, int j) const {
    Exponents e{};
    e[edge_] = degree() - i - j;
    e[(edge_ + 1) % 3] = j;
    e[(edge_ + 2) % 3] = i;
    return triangle_index(degree(), e);
  }
  Vector2<T> homogeneous(int i, int j) const {
    return {net_.coordinates[0][index(i, j)], net_.coordinates[1][index(i, j)]};
  }
  T weight(int i, int j) const { return net_.rational() ? net_.weights[index(i, j)] : T(1); }
  T tip_weight() const { return weight(degree(), 0); }

  // w_a w_b (p_b - p_a) for any two control points.
  Vector2<T> between(int ai, int aj, int bi, int bj) const {
    const Vector2<T> a = homogeneous(ai, aj);
    const Vector2<T> b = homogeneous(bi, bj);
    if (!net_.rational()) return b - a;
    const T wa = weight(ai, aj);
    const T wb = weight(bi, bj);
    return {b.x * wa - a.x * wb, b.y * wa - a.y * wb};
  }
  Vector2<T> control_vector(int k) const { return between(0, k, 0, k + 1); }
  Vector2<T> direction() const {
    return degree() == 1 ? between(0, 0, 0, 1) : between(1, 0, 1, degree() - 1);
  }

  // 2 omega^2 p'_i = (omega - W_i)(X_0 + X_n) + 2 omega X_i, as both ends have weight omega.
  Vector2<T> auxiliary(int i) const {
    const Vector2<T> first = homogeneous(0, 0);
    const Vector2<T> last = homogeneous(0, degree());
    const Vector2<T> point = homogeneous(0, i);
    const T omega = tip_weight();
    const T missing = omega - weight(0, i);
    const T twice = T(2) * omega;
    return {missing * (first.x + last.x) + twice * point.x, missing * (first.y + last.y) + twice * point.y};
  }
  Vector2<T> auxiliary_vector(int k) const { return auxiliary(k + 1) - auxiliary(k); }
  // 2 omega^2 (p_1i - p'_i).
  Vector2<T> from_auxiliary(int i) const {
    const Vector2<T> point = homogeneous(1, i);
    const T twice = T(2) * tip_weight();
    return Vector2<T>{twice * point.x, twice * point.y} - auxiliary(i);
  }

 private:
  const Net<T>& net_;
  int edge_;
};

// Checks one edge; the first condition that fails, or nothing.
class EdgeCheck {
 public:
  EdgeCheck(const Forms& forms, int edge)
      : forms_(forms), edge_(edge), n_(forms.element().shape().degree(0)) {}

  std::optional<std::string> failure() const {
    for (const auto check : {&EdgeCheck::weights, &EdgeCheck::guardable, &EdgeCheck::cones,
                             &EdgeCheck::rows_parallel, &EdgeCheck::columns_parallel}) {
      if (auto failed = (this->*check)()) return failed;
    }
    return std::nullopt;
  }

 private:
  template <class Expression>
  int sign_of(Expression expression) const {
    return forms_.sign_of([&](const auto& net) { return expression(EdgeView(net, edge_)); });
  }

  static std::string at(int i, int j) {
    std::string text = " at row ";
    text += std::to_string(i);
    text += ", place ";
    return text + std::to_string(j);
  }

  // Condition 2, and Definition 5's normalisation: end weights 1.
  std::optional<std::string> weights() const {
    if (!forms_.element().rational()) return std::nullopt;
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j <= n_ - i; ++j) {
        const bool end = i == 0 && (j == 0 || j == n_);
        if (i == 0 && !end) continue;
        if (sign_of([&](const auto& e) { return e.weight(i, j) - e.tip_weight(); }) != 0) {
          return (end ? "end weights (not equal to the tip's)" : "condition 2 (weight not 1)") + at(i, j);
        }
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> guardable() const {
    for (int k = 0; k < n_; ++k) {
      if (sign_of([&](const auto& e) { return dot(e.direction(), e.control_vector(k)); }) <= 0) {
        return "guardability (control vector " + std::to_string(k) + ")";
      }
      if (sign_of([&](const auto& e) { return dot(e.direction(), e.auxiliary_vector(k)); }) <= 0) {
        return "guardability (auxiliary control vector " + std::to_string(k) + ")";
      }
    }
    return std::nullopt;
  }

  // Condition 3: p_1i in the blue cone of p_i and in the red cone of p'_i.
  std::optional<std::string> cones() const {
    for (int i = 0; i < n_; ++i) {
      bool blue = sign_of([&](const auto& e) { return cross(e.direction(), e.between(0, i, 1, i)); }) > 0;
      bool red = sign_of([&](const auto& e) { return cross(e.direction(), e.from_auxiliary(i)); }) > 0;
      for (int k = 0; k < n_ && blue && red; ++k) {
        blue = sign_of([&](const auto& e) { return cross(e.control_vector(k), e.between(0, i, 1, i)); }) > 0;
        red = sign_of([&](const auto& e) { return cross(e.auxiliary_vector(k), e.from_auxiliary(i)); }) > 0;
      }
      if (!blue) return "condition 3 (blue cone)" + at(1, i);
      if (!red) return "condition 3 (red cone)" + at(1, i);
    }
    return std::nullopt;
  }

  template <class Vector, class Reference>
  bool same_direction(Vector vector, Reference reference) const {
    return sign_of([&](const auto& e) { return cross(vector(e), reference(e)); }) == 0 &&
           sign_of([&](const auto& e) { return dot(vector(e), reference(e)); }) > 0;
  }

  std::optional<std::string> rows_parallel() const {
    for (int i = 1; i < n_; ++i) {
      for (int j = 0; i + j < n_; ++j) {
        if (!same_direction([&](const auto& e) { return e.between(i, j, i, j + 1); },
                            [](const auto& e) { return e.direction(); })) {
          return "condition 4 (row not parallel to d)" + at(i, j);
        }
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> columns_parallel() const {
    for (int i = 1; i < n_; ++i) {
      for (int j = 0; i + j < n_; ++j) {
        if (!same_direction([&](const auto& e) { return e.between(i, j, i + 1, j); },
                            [](const auto& e) { return e.between(0, 0, 1, 0); })) {
          return "condition 5 (not parallel to the left side)" + at(i, j);
        }
      }
    }
    return std::nullopt;
  }

  const Forms& forms_;
  int edge_;
  int n_;
};

// The five conditions for equal weights: then p'_i = p_i, and the red cone is the blue one.
bool holds_plainly(const QuickNet& net, int edge) {
  const int n = net.degree();
  const auto at = [&](int i, int j) {
    Exponents e{};
    e[edge] = n - i - j;
    e[(edge + 1) % 3] = j;
    e[(edge + 2) % 3] = i;
    return triangle_index(n, e);
  };
  const std::size_t from = n == 1 ? at(0, 0) : at(1, 0), to = n == 1 ? at(0, 1) : at(1, n - 1);
  for (int k = 0; k < n; ++k) {
    if (net.forward(from, to, at(0, k), at(0, k + 1)) <= 0) return false;
  }
  for (int i = 0; i < n; ++i) {
    if (net.turn(from, to, at(0, i), at(1, i)) <= 0) return false;
    for (int k = 0; k < n; ++k) {
      if (net.turn(at(0, k), at(0, k + 1), at(0, i), at(1, i)) <= 0) return false;
    }
  }
  const auto same_direction = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return net.turn(a, b, c, d) == 0 && net.forward(a, b, c, d) > 0;
  };
  for (int i = 1; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      if (!same_direction(at(i, j), at(i, j + 1), from, to)) return false;
    }
  }
  for (int i = 1; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      if (!same_direction(at(i, j), at(i + 1, j), at(0, 0), at(1, 0))) return false;
    }
  }
  return true;
}

}  // namespace

Verdict cone(const Forms& forms) {
  Verdict verdict = begin_verdict(cone_info, Status::not_applicable);
  if (!forms.element().is_triangle()) {
    verdict.reason = "stated for triangles";
    return verdict;
  }
  std::string reasons;
  for (int edge = 0; edge < 3; ++edge) {
    const auto failed = EdgeCheck(forms, edge).failure();
    if (!failed) {
      verdict.status = Status::proved;
      return verdict;
    }
    if (edge > 0) reasons += "; ";
    reasons += "edge " + std::to_string(edge) + ": " + *failed;
  }
  verdict.status = Status::inconclusive;
  verdict.reason = reasons;
  return verdict;
}

std::optional<Status> quick_cone(const QuickNet& net) {
  for (int edge = 0; edge < 3; ++edge) {
    if (holds_plainly(net, edge)) return Status::proved;
  }
  return Status::inconclusive;
}

}  // namespace bezcert
