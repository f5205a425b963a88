#include "bezcert/decide/injectivity.hpp"

#include "bezcert/bernstein/scale_table.hpp"
#include "bezcert/criterion/orientation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace bezcert {
namespace {

// Bernstein coefficients, up to one positive factor a column, of the columns of W^2 J in one basis.
template <class T>
struct Columns {
  std::vector<T> ux, uy, vx, vy;
};

// Differences of neighbours along u or v (triangle: towards corner 1 or 2), divided by the degree.
template <class T>
Polynomial<T> derivative(Shape shape, const std::vector<T>& values, int direction) {
  Polynomial<T> result(detail::lowered(shape, direction));
  for (int r = 0; r < row_count(result.shape); ++r) {
    for (int c = 0; c < column_count(result.shape, r); ++c) {
      const std::size_t next =
          direction == 0 ? coefficient_index(shape, r, c + 1) : coefficient_index(shape, r + 1, c);
      result.at(r, c) = values[next] - values[coefficient_index(shape, r, c)];
    }
  }
  return result;
}

template <class T>
Polynomial<T> scaled(Polynomial<T> f) {
  to_scaled(f);
  return f;
}

// One column of W^2 J: (x_u w - x w_u, y_u w - y w_u), or (x_u, y_u); on the square elevated by one degree in
// the direction of the derivative, so that both columns have the same basis.
template <class T>
std::pair<std::vector<T>, std::vector<T>> column(const Net<T>& net, int direction) {
  const bool square = net.shape.domain == Domain::square;
  const auto along = [&](const std::vector<T>& values) { return derivative(net.shape, values, direction); };
  if (!net.rational() && !square)
    return {along(net.coordinates[0]).coefficients, along(net.coordinates[1]).coefficients};

  const Polynomial<T> w = net.rational() ? scaled(Polynomial<T>(net.shape, net.weights)) : Polynomial<T>();
  const Polynomial<T> w_along = net.rational() ? scaled(along(net.weights)) : Polynomial<T>();
  const auto component = [&](const std::vector<T>& values) {
    Polynomial<T> f = scaled(along(values));
    if (net.rational()) {
      f = convolve(f, w);
      const Polynomial<T> g = convolve(scaled(Polynomial<T>(net.shape, values)), w_along);
      for (std::size_t i = 0; i < g.coefficients.size(); ++i) f.coefficients[i] -= g.coefficients[i];
    }
    if (square) {
      const Shape step = direction == 0 ? Shape::square(1, 0) : Shape::square(0, 1);
      f = convolve(f, Polynomial<T>(step, {T(1), T(1)}));
    }
    from_scaled(f);
    return f.coefficients;
  };
  return {component(net.coordinates[0]), component(net.coordinates[1])};
}

template <class T>
Columns<T> columns(const Net<T>& net) {
  auto [ux, uy] = column(net, 0);
  auto [vx, vy] = column(net, 1);
  return {std::move(ux), std::move(uy), std::move(vx), std::move(vy)};
}

template <class T>
T mixed(const Columns<T>& m, std::size_t i, std::size_t j) {
  const T once = m.ux[i] * m.vy[j] - m.uy[i] * m.vx[j];
  if (i == j) return once;
  return once + (m.ux[j] * m.vy[i] - m.uy[j] * m.vx[i]);
}

// Whether the mixed determinant of i and j is as the hull condition asks.
bool is_allowed(int sign, std::size_t i, std::size_t j) { return sign > 0 || (sign == 0 && i != j); }

// Intervals first, all in one go; integers for the pairs that they leave open.
bool jacobian_hull(const Forms& forms) {
  std::vector<std::pair<std::size_t, std::size_t>> open;
  if (forms.filter() == Filter::on) {
    const RoundUp up;
    const Columns<Interval> m = columns(forms.interval(up).net);
    for (std::size_t i = 0; i < m.ux.size(); ++i) {
      for (std::size_t j = i; j < m.ux.size(); ++j) {
        const std::optional<int> certain = certain_sign(mixed(m, i, j));
        if (!certain) {
          open.emplace_back(i, j);
        } else if (!is_allowed(*certain, i, j)) {
          return false;
        }
      }
    }
    if (open.empty()) return true;
  }
  const Columns<Integer> m = columns(forms.exact().net);
  if (forms.filter() == Filter::off) {
    for (std::size_t i = 0; i < m.ux.size(); ++i) {
      for (std::size_t j = i; j < m.ux.size(); ++j) open.emplace_back(i, j);
    }
  }
  return std::all_of(open.begin(), open.end(), [&](const auto& pair) {
    return is_allowed(sign(mixed(m, pair.first, pair.second)), pair.first, pair.second);
  });
}

bool derivative_is_affine_on_segments(const Element& element) {
  if (element.rational()) return false;
  return element.degree() <= (element.is_triangle() ? 2 : 1);
}

}  // namespace

InjectivityProof prove_injective(const Forms& forms) {
  if (derivative_is_affine_on_segments(forms.element())) return InjectivityProof::midpoint;
  if (jacobian_hull(forms)) return InjectivityProof::jacobian_hull;
  if (orientation_condition(forms).status == Status::proved) return InjectivityProof::orientation;
  return InjectivityProof::none;
}

}  // namespace bezcert
