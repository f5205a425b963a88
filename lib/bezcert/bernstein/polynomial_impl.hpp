// Definitions of the templates of polynomial.hpp; include that header instead.
#pragma once

#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>

namespace bezcert {
namespace detail {

// Calls visit(first index, stride, count) for every line of coefficients along one direction of a
// segment or square.
template <class Visit>
void for_each_line(Shape shape, int direction, Visit visit) {
  const auto columns = static_cast<std::size_t>(shape.p) + 1;
  const auto rows = static_cast<std::size_t>(shape.q) + 1;
  if (direction == 0) {
    for (std::size_t r = 0; r < rows; ++r) visit(r * columns, std::size_t{1}, columns);
  } else {
    for (std::size_t c = 0; c < columns; ++c) visit(c, columns, rows);
  }
}

inline Shape lowered(Shape shape, int direction) {
  if (shape.domain == Domain::square && direction == 1) {
    --shape.q;
  } else {
    --shape.p;
  }
  if (shape.p < 0 || shape.q < 0) throw std::invalid_argument("differentiate: the degree is 0");
  return shape;
}

// de Casteljau at t on coefficients[first], [first + stride], ...: the left part replaces them, the right
// part goes to `right` at the same places.
template <class T>
void split_line(std::vector<T>& left, std::vector<T>& right, std::size_t first, std::size_t stride,
                std::size_t count, const T& t) {
  std::vector<T> work(count);
  for (std::size_t i = 0; i < count; ++i) work[i] = left[first + i * stride];
  const T s = T(1) - t;
  for (std::size_t level = 0; level < count; ++level) {
    left[first + level * stride] = work[0];
    right[first + (count - 1 - level) * stride] = work[count - 1 - level];
    for (std::size_t i = 0; i + 1 < count - level; ++i) work[i] = s * work[i] + t * work[i + 1];
  }
}

}  // namespace detail

template <class T>
T evaluate(const Polynomial<T>& f, const std::vector<T>& parameter) {
  const Shape shape = f.shape;
  std::vector<T> c = f.coefficients;
  if (shape.domain == Domain::triangle) {
    if (parameter.size() != 3) throw std::invalid_argument("evaluate: three parameters expected");
    for (Shape level = shape; level.p > 0; --level.p) {
      const Shape next{Domain::triangle, level.p - 1, 0};
      for (int r = 0; r < level.p; ++r) {
        for (int col = 0; col < level.p - r; ++col) {
          c[coefficient_index(next, r, col)] = parameter[0] * c[coefficient_index(level, r, col)] +
                                               parameter[1] * c[coefficient_index(level, r, col + 1)] +
                                               parameter[2] * c[coefficient_index(level, r + 1, col)];
        }
      }
    }
    return c[0];
  }
  const std::size_t expected = shape.domain == Domain::segment ? 1 : 2;
  if (parameter.size() != expected) throw std::invalid_argument("evaluate: wrong number of parameters");
  const auto columns = static_cast<std::size_t>(shape.p) + 1;
  const auto rows = static_cast<std::size_t>(shape.q) + 1;
  const auto collapse = [&c](std::size_t first, std::size_t stride, std::size_t count, const T& t) {
    const T s = T(1) - t;
    for (std::size_t n = count; n > 1; --n) {
      for (std::size_t i = 0; i + 1 < n; ++i) {
        c[first + i * stride] = s * c[first + i * stride] + t * c[first + (i + 1) * stride];
      }
    }
  };
  for (std::size_t r = 0; r < rows; ++r) collapse(r * columns, 1, columns, parameter[0]);
  if (shape.domain == Domain::square) collapse(0, columns, rows, parameter[1]);
  return c[0];
}

template <class T>
Polynomial<T> elevate(const Polynomial<T>& f, int times) {
  Polynomial<T> result = f;
  for (int k = 0; k < times; ++k) {
    const Polynomial<T> g = std::move(result);
    if (g.shape.domain == Domain::triangle) {
      const int degree = g.shape.p + 1;
      result = Polynomial<T>(Shape{Domain::triangle, degree, 0});
      for (int r = 0; r <= degree; ++r) {
        for (int c = 0; c <= degree - r; ++c) {
          T sum(0);
          if (degree - r - c > 0) sum += T(degree - r - c) * g.at(r, c);
          if (c > 0) sum += T(c) * g.at(r, c - 1);
          if (r > 0) sum += T(r) * g.at(r - 1, c);
          result.at(r, c) = sum / T(degree);
        }
      }
      continue;
    }
    const Shape wider{g.shape.domain, g.shape.p + 1, g.shape.q};
    Polynomial<T> along_u(wider);
    for (int r = 0; r <= g.shape.q; ++r) {
      for (int c = 0; c <= wider.p; ++c) {
        T sum(0);
        if (c < wider.p) sum += T(wider.p - c) * g.at(r, c);
        if (c > 0) sum += T(c) * g.at(r, c - 1);
        along_u.at(r, c) = sum / T(wider.p);
      }
    }
    if (g.shape.domain == Domain::segment) {
      result = std::move(along_u);
      continue;
    }
    result = Polynomial<T>(Shape{Domain::square, wider.p, wider.q + 1});
    for (int r = 0; r <= result.shape.q; ++r) {
      for (int c = 0; c <= wider.p; ++c) {
        T sum(0);
        if (r < result.shape.q) sum += T(result.shape.q - r) * along_u.at(r, c);
        if (r > 0) sum += T(r) * along_u.at(r - 1, c);
        result.at(r, c) = sum / T(result.shape.q);
      }
    }
  }
  return result;
}

template <class T>
Polynomial<T> multiply(const Polynomial<T>& f, const Polynomial<T>& g) {
  // B_a B_b = C(a) C(b) / C(a+b) B_(a+b): in coefficients times multinomials this is a convolution.
  const auto scaled = [](const Polynomial<T>& h) {
    const std::vector<Integer> factors = multinomials(h.shape);
    Polynomial<T> result = h;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      result.coefficients[i] = result.coefficients[i] * number_from_integer<T>(factors[i]);
    }
    return result;
  };
  Polynomial<T> result = convolve(scaled(f), scaled(g));
  const std::vector<Integer> factors = multinomials(result.shape);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    result.coefficients[i] = result.coefficients[i] / number_from_integer<T>(factors[i]);
  }
  return result;
}

template <class T>
Polynomial<T> differentiate(const Polynomial<T>& f, int direction) {
  Polynomial<T> result(detail::lowered(f.shape, direction));
  const bool along_rows = direction == 0;
  const T degree(along_rows || f.shape.domain == Domain::triangle ? f.shape.p : f.shape.q);
  for (int r = 0; r < row_count(result.shape); ++r) {
    for (int c = 0; c < column_count(result.shape, r); ++c) {
      const T& next = along_rows ? f.at(r, c + 1) : f.at(r + 1, c);
      result.at(r, c) = degree * (next - f.at(r, c));
    }
  }
  return result;
}

template <class T>
std::pair<Polynomial<T>, Polynomial<T>> split(const Polynomial<T>& f, const T& t, int direction) {
  Polynomial<T> left = f;
  Polynomial<T> right = f;
  if (f.shape.domain == Domain::triangle) {
    for (int r = 0; r <= f.shape.p; ++r) {
      detail::split_line(left.coefficients, right.coefficients, coefficient_index(f.shape, r, 0), 1,
                         static_cast<std::size_t>(f.shape.p - r) + 1, t);
    }
  } else {
    detail::for_each_line(f.shape, direction, [&](std::size_t first, std::size_t stride, std::size_t count) {
      detail::split_line(left.coefficients, right.coefficients, first, stride, count, t);
    });
  }
  return {std::move(left), std::move(right)};
}

template <class T>
std::pair<T, T> range(const Polynomial<T>& f) {
  const auto [lowest, highest] = std::minmax_element(f.coefficients.begin(), f.coefficients.end());
  return {*lowest, *highest};
}

}  // namespace bezcert
