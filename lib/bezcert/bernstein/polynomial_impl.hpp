// Definitions of the templates of polynomial.hpp; include that header instead.
#pragma once

#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>

namespace bezcert {
namespace detail {

// Calls visit(first in `from`, first in `to`, stride) for every copy of a factor's coefficients in two shapes
// that differ in that factor's degree: the j-th coefficient is at first + j * stride.
template <class Visit>
void for_each_copy(Shape from, Shape to, int factor, Visit visit) {
  std::size_t stride = 1;
  for (int f = 0; f < factor; ++f) stride *= coefficient_count(from, f);
  const std::size_t count = coefficient_count(from, factor), to_count = coefficient_count(to, factor);
  const std::size_t end = coefficient_count(from) / count;
  for (std::size_t i = 0; i < end; ++i) {
    const std::size_t outer = i / stride, inner = i % stride;
    visit(outer * stride * count + inner, outer * stride * to_count + inner, stride);
  }
}

// Calls visit(first, stride, count) for every line of coefficients towards corner 1 of a factor.
template <class Visit>
void for_each_line(Shape shape, int factor, Visit visit) {
  for_each_copy(shape, shape, factor, [&](std::size_t first, std::size_t, std::size_t stride) {
    for_each_simplex_line(shape.domain.simplex(factor), shape.degree(factor),
                          [&](std::size_t line, std::size_t count, const auto&) {
                            visit(first + line * stride, stride, count);
                          });
  });
}

// The shape of the derivative by an affine coordinate.
inline Shape lowered(Shape shape, int coordinate) {
  const int factor = factor_of_coordinate(shape.domain, coordinate);
  if (shape.degree(factor) <= 0) throw std::invalid_argument("differentiate: the degree is 0");
  return shape.raised(factor, -1);
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
Polynomial<T> collapse(Polynomial<T> f, int factor, const T* t, int to) {
  const int dimension = f.shape.domain.simplex(factor), degree = f.shape.degree(factor);
  if (degree == to) return f;
  Polynomial<T> result;  // every coefficient is moved into: no zeros are made
  result.shape = f.shape.raised(factor, to - degree);
  result.coefficients.resize(coefficient_count(result.shape));
  std::vector<T>& c = f.coefficients;
  detail::for_each_copy(f.shape, result.shape, factor,
                        [&](std::size_t first, std::size_t result_first, std::size_t stride) {
                          for (int level = degree - 1; level >= to; --level) {
                            for_each_simplex_point(dimension, level, [&](const SimplexPoint& at) {
                              T sum = t[0] * c[first + at.raised[0] * stride];
                              for (int k = 1; k <= dimension; ++k) {
                                const auto corner = static_cast<std::size_t>(k);
                                sum += t[corner] * c[first + at.raised[corner] * stride];
                              }
                              c[first + at.position * stride] = std::move(sum);
                            });
                          }
                          for (std::size_t i = 0; i < simplex_count(dimension, to); ++i) {
                            result.coefficients[result_first + i * stride] = std::move(c[first + i * stride]);
                          }
                        });
  return result;
}

template <class T>
T evaluate(const Polynomial<T>& f, const std::vector<T>& parameter) {
  const Domain domain = f.shape.domain;
  if (parameter.size() != parameter_size(domain)) {
    throw std::invalid_argument("evaluate: the number of parameters does not fit the domain");
  }
  Polynomial<T> rest = f;
  const T* next = parameter.data();
  for (int factor = 0; factor < f.shape.factor_count(); ++factor) {
    if (domain.simplex(factor) == 1) {
      const std::array<T, 2> t{T(1) - *next, *next};
      rest = collapse(std::move(rest), factor, t.data(), 0);
      ++next;
    } else {
      rest = collapse(std::move(rest), factor, next, 0);
      next += domain.simplex(factor) + 1;
    }
  }
  return rest.coefficients[0];
}

template <class T>
Polynomial<T> elevate(const Polynomial<T>& f, int times) {
  Polynomial<T> result = f;
  for (int k = 0; k < times * f.shape.factor_count(); ++k) {
    const int factor = k % f.shape.factor_count();
    const Polynomial<T> g = std::move(result);
    const int dimension = g.shape.domain.simplex(factor), degree = g.shape.degree(factor);
    result = Polynomial<T>(g.shape.raised(factor, 1));
    detail::for_each_copy(g.shape, result.shape, factor,
                          [&](std::size_t from, std::size_t to, std::size_t stride) {
                            for_each_simplex_point(dimension, degree, [&](const SimplexPoint& at) {
                              for (int corner = 0; corner <= dimension; ++corner) {
                                const auto i = static_cast<std::size_t>(corner);
                                result.coefficients[to + at.raised[i] * stride] +=
                                    T(at.exponents[i] + 1) * g.coefficients[from + at.position * stride];
                              }
                            });
                          });
    for (T& c : result.coefficients) c = c / T(degree + 1);
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
Polynomial<T> differentiate(const Polynomial<T>& f, int coordinate) {
  Polynomial<T> result;
  result.shape = detail::lowered(f.shape, coordinate);
  result.coefficients.resize(coefficient_count(result.shape));
  const int factor = factor_of_coordinate(f.shape.domain, coordinate);
  std::size_t corner = static_cast<std::size_t>(coordinate) + 1;
  for (int k = 0; k < factor; ++k) corner -= static_cast<std::size_t>(f.shape.domain.simplex(k));
  const T degree(f.shape.degree(factor));
  detail::for_each_copy(
      f.shape, result.shape, factor, [&](std::size_t from, std::size_t to, std::size_t stride) {
        for_each_simplex_point(f.shape.domain.simplex(factor), result.shape.degree(factor),
                               [&](const SimplexPoint& at) {
                                 result.coefficients[to + at.position * stride] =
                                     degree * (f.coefficients[from + at.raised[corner] * stride] -
                                               f.coefficients[from + at.raised[0] * stride]);
                               });
      });
  return result;
}

template <class T>
std::pair<Polynomial<T>, Polynomial<T>> split(const Polynomial<T>& f, const T& t, int factor) {
  Polynomial<T> left = f;
  Polynomial<T> right = f;
  detail::for_each_line(f.shape, factor, [&](std::size_t first, std::size_t stride, std::size_t count) {
    detail::split_line(left.coefficients, right.coefficients, first, stride, count, t);
  });
  return {std::move(left), std::move(right)};
}

template <class T>
std::pair<T, T> range(const Polynomial<T>& f) {
  const auto [lowest, highest] = std::minmax_element(f.coefficients.begin(), f.coefficients.end());
  return {*lowest, *highest};
}

}  // namespace bezcert
