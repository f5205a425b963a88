// The Jacobian numerator of an element by plain expansion in powers of u and v, and a plain subdivision of
// it: nothing of the library's mathematics, only its numbers.
#pragma once

#include "random_element.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bezcert::test {

/// rows[k][i] is the coefficient of u^i v^k; all rows have one length.
struct Table {
  std::vector<std::vector<Integer>> rows;

  Table(std::size_t height, std::size_t width) : rows(height, std::vector<Integer>(width, 0)) {}
  std::size_t height() const { return rows.size(); }
  std::size_t width() const { return rows[0].size(); }

  bool is_zero() const {
    for (const auto& row : rows) {
      for (const Integer& c : row) {
        if (!c.is_zero()) return false;
      }
    }
    return true;
  }
  Rational at(const Rational& u, const Rational& v) const {
    Rational sum = 0;
    for (std::size_t k = rows.size(); k-- > 0;) {
      Rational row = 0;
      for (std::size_t i = width(); i-- > 0;) row = row * u + Rational(rows[k][i]);
      sum = sum * v + row;
    }
    return sum;
  }
};

inline int total_degree(const Table& f) {
  int degree = -1;
  for (std::size_t k = 0; k < f.height(); ++k) {
    for (std::size_t i = 0; i < f.width(); ++i) {
      if (!f.rows[k][i].is_zero()) degree = std::max(degree, static_cast<int>(i + k));
    }
  }
  return degree;
}

inline Table product(const Table& f, const Table& g) {
  Table result(f.height() + g.height() - 1, f.width() + g.width() - 1);
  for (std::size_t a = 0; a < f.height(); ++a) {
    for (std::size_t i = 0; i < f.width(); ++i) {
      if (f.rows[a][i].is_zero()) continue;
      for (std::size_t b = 0; b < g.height(); ++b) {
        for (std::size_t j = 0; j < g.width(); ++j) {
          if (!g.rows[b][j].is_zero()) result.rows[a + b][i + j] += f.rows[a][i] * g.rows[b][j];
        }
      }
    }
  }
  return result;
}

/// f + factor g, of the larger size.
inline Table combined(const Table& f, const Integer& factor, const Table& g) {
  Table result(std::max(f.height(), g.height()), std::max(f.width(), g.width()));
  for (std::size_t k = 0; k < f.height(); ++k) {
    for (std::size_t i = 0; i < f.width(); ++i) result.rows[k][i] += f.rows[k][i];
  }
  for (std::size_t k = 0; k < g.height(); ++k) {
    for (std::size_t i = 0; i < g.width(); ++i) result.rows[k][i] += factor * g.rows[k][i];
  }
  return result;
}

inline Table negated(const Table& f) { return combined(Table(1, 1), -1, f); }

inline Table slope_u(const Table& f) {
  Table result(f.height(), f.width());
  for (std::size_t k = 0; k < f.height(); ++k) {
    for (std::size_t i = 1; i < f.width(); ++i) result.rows[k][i - 1] = f.rows[k][i] * Integer(i);
  }
  return result;
}

inline Table slope_v(const Table& f) {
  Table result(f.height(), f.width());
  for (std::size_t k = 1; k < f.height(); ++k) {
    for (std::size_t i = 0; i < f.width(); ++i) result.rows[k - 1][i] = f.rows[k][i] * Integer(k);
  }
  return result;
}

inline Integer factorial_of(int n) {
  Integer result = 1;
  for (int k = 2; k <= n; ++k) result *= k;
  return result;
}

/// The basis function with (row, column) of shape.hpp, multiplied out.
inline Table basis_table(Shape shape, int row, int column) {
  const bool triangle = shape.domain == Domain::triangle;
  const auto repeated = [](const Table& factor, int times) {
    Table result(1, 1);
    result.rows[0][0] = 1;
    for (int k = 0; k < times; ++k) result = product(result, factor);
    return result;
  };
  Table u(1, 2), v(2, 1), rest_u(1, 2), rest_v(2, 1), rest(2, 2);
  u.rows[0][1] = v.rows[1][0] = 1;
  rest_u.rows[0][0] = rest_v.rows[0][0] = rest.rows[0][0] = 1;
  rest_u.rows[0][1] = rest_v.rows[1][0] = rest.rows[0][1] = rest.rows[1][0] = -1;
  Table powers = product(repeated(u, column), repeated(v, row));
  Integer factor;
  if (triangle) {
    const int other = shape.degree(0) - row - column;
    powers = product(powers, repeated(rest, other));
    factor = factorial_of(shape.degree(0)) / (factorial_of(row) * factorial_of(column) * factorial_of(other));
  } else {
    powers = product(
        powers, product(repeated(rest_u, shape.degree(0) - column), repeated(rest_v, shape.degree(1) - row)));
    factor = factorial_of(shape.degree(0)) / (factorial_of(column) * factorial_of(shape.degree(0) - column)) *
             (factorial_of(shape.degree(1)) / (factorial_of(row) * factorial_of(shape.degree(1) - row)));
  }
  return combined(Table(1, 1), factor, powers);
}

/// A positive multiple of the polynomial with these Bernstein coefficients.
inline Table expanded(Shape shape, const std::vector<Rational>& coefficients) {
  static std::map<Shape, std::vector<Table>> bases;
  auto& basis = bases[shape];
  if (basis.empty()) {
    for (int r = 0; r < row_count(shape); ++r) {
      for (int c = 0; c < column_count(shape, r); ++c) {
        const auto height =
            static_cast<std::size_t>(shape.domain == Domain::triangle ? shape.degree(0) : shape.degree(1)) +
            1;
        basis.push_back(combined(Table(height, static_cast<std::size_t>(shape.degree(0)) + 1), 1,
                                 basis_table(shape, r, c)));
      }
    }
  }
  Integer scale = 1;
  for (const Rational& x : coefficients) scale = lcm(scale, Integer(denominator(x)));
  Table result(basis[0].height(), basis[0].width());
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const Integer scaled = numerator(coefficients[i]) * (scale / denominator(coefficients[i]));
    if (scaled.is_zero()) continue;
    for (std::size_t k = 0; k < basis[i].height(); ++k) {
      for (std::size_t c = 0; c < basis[i].width(); ++c) {
        if (!basis[i].rows[k][c].is_zero()) result.rows[k][c] += scaled * basis[i].rows[k][c];
      }
    }
  }
  return result;
}

/// Without leading zeros, and divided by the common divisor of its coefficients.
inline Table primitive(Table f) {
  const auto is_zero = [](const std::vector<Integer>& row) {
    return std::all_of(row.begin(), row.end(), [](const Integer& c) { return c.is_zero(); });
  };
  while (f.height() > 1 && is_zero(f.rows.back())) f.rows.pop_back();
  const auto last_is_zero = [](const std::vector<Integer>& row) { return row.back().is_zero(); };
  while (f.width() > 1 && std::all_of(f.rows.begin(), f.rows.end(), last_is_zero)) {
    for (auto& row : f.rows) row.pop_back();
  }
  Integer content = 0;
  for (const auto& row : f.rows) {
    for (const Integer& c : row) content = gcd(content, c);
  }
  if (content > 1) {
    for (auto& row : f.rows) {
      for (Integer& c : row) c /= content;
    }
  }
  return f;
}

/// A positive multiple of det J W^3.
inline Table jacobian_table(const RawElement& e) {
  std::vector<Rational> x = e.x, y = e.y;
  for (std::size_t i = 0; i < e.w.size(); ++i) {
    x[i] *= e.w[i];
    y[i] *= e.w[i];
  }
  const Table fx = expanded(e.shape, x), fy = expanded(e.shape, y);
  const Table xu = slope_u(fx), xv = slope_v(fx), yu = slope_u(fy), yv = slope_v(fy);
  const auto cross = [](const Table& a, const Table& b, const Table& c, const Table& d) {
    return combined(product(a, b), -1, product(c, d));
  };
  const Table xy = cross(xu, yv, xv, yu);
  if (e.w.empty()) return primitive(xy);
  const Table fw = expanded(e.shape, e.w), wu = slope_u(fw), wv = slope_v(fw);
  return primitive(
      combined(combined(product(fx, cross(yu, wv, yv, wu)), -1, product(fy, cross(xu, wv, xv, wu))), 1,
               product(fw, xy)));
}

inline bool in_domain(Domain domain, const Rational& u, const Rational& v) {
  if (u < 0 || v < 0) return false;
  return domain == Domain::triangle ? u + v <= 1 : u <= 1 && v <= 1;
}

/// Positive multiples of the Bernstein coefficients, in rows; on the triangle of the total degree.
inline std::vector<std::vector<Integer>> bernstein_rows(const Table& f, Domain domain) {
  const auto falling = [](int n, int k) {
    long result = 1;
    for (int i = 0; i < k; ++i) result *= n - i;
    return result;
  };
  const auto factorial = [&](int n) { return falling(n, n); };
  if (f.width() + f.height() > 22)
    throw std::logic_error("bernstein_rows: the degree is too large for 64 bits");
  std::vector<std::vector<Integer>> result;
  int p = static_cast<int>(f.width()) - 1, q = static_cast<int>(f.height()) - 1;
  if (domain == Domain::triangle) {
    int degree = 0;
    for (int k = 0; k <= q; ++k) {
      for (int i = 0; i <= p; ++i) {
        if (!f.rows[k][i].is_zero()) degree = std::max(degree, i + k);
      }
    }
    // u^a v^b has the coefficient j!/(j-a)! k!/(k-b)! (n-a-b)!/n! at (j, k).
    for (int k = 0; k <= degree; ++k) {
      result.emplace_back();
      for (int j = 0; j + k <= degree; ++j) {
        Integer sum = 0;
        for (int b = 0; b <= std::min(k, q); ++b) {
          for (int a = 0; a <= std::min(j, p); ++a) {
            if (!f.rows[b][a].is_zero())
              sum += f.rows[b][a] * Integer(falling(j, a)) * Integer(falling(k, b)) *
                     Integer(factorial(degree - a - b));
          }
        }
        result.back().push_back(sum);
      }
    }
    return result;
  }
  for (int k = 0; k <= q; ++k) {
    result.emplace_back();
    for (int j = 0; j <= p; ++j) {
      Integer sum = 0;
      for (int b = 0; b <= k; ++b) {
        for (int a = 0; a <= j; ++a) {
          if (!f.rows[b][a].is_zero()) {
            sum += f.rows[b][a] * Integer(falling(j, a) * factorial(p - a)) *
                   Integer(falling(k, b) * factorial(q - b));
          }
        }
      }
      result.back().push_back(sum);
    }
  }
  return result;
}

/// Whether subdivision proves f > 0 (f >= 0 if not `strictly`) on the closed domain with at most `pieces`
/// pieces.
inline bool subdivision_proves_positive(const Table& f, Domain domain, int pieces, bool strictly = true) {
  using Rows = std::vector<std::vector<Integer>>;
  const bool triangle = domain == Domain::triangle;
  // Both halves of every row, times 2^(length of the longest row - 1).
  const auto halves = [](const Rows& rows) {
    std::pair<Rows, Rows> result;
    const std::size_t longest = rows[0].size();
    for (const auto& row : rows) {
      std::vector<Integer> left(row.size()), right = row;
      for (std::size_t level = 0; level < row.size(); ++level) {
        left[level] = right[0] << static_cast<unsigned>(longest - 1 - level);
        for (std::size_t i = 0; i + 1 < row.size() - level; ++i) right[i] += right[i + 1];
      }
      for (std::size_t i = 0; i < row.size(); ++i)
        right[i] <<= static_cast<unsigned>(longest - row.size() + i);
      result.first.push_back(std::move(left));
      result.second.push_back(std::move(right));
    }
    return result;
  };
  // Triangle: the next cut is through the edge that the corners `first` and `second` become corners 0 and 1
  // of.
  const auto turned = [&](const Rows& rows, int first) {
    Rows result;
    if (!triangle) {
      for (std::size_t i = 0; i < rows[0].size(); ++i) {
        result.emplace_back();
        for (const auto& row : rows) result.back().push_back(row[i]);
      }
      return result;
    }
    const std::size_t n = rows.size() - 1;
    for (std::size_t k = 0; k <= n; ++k) {
      result.emplace_back();
      for (std::size_t j = 0; j + k <= n; ++j) {
        const std::size_t i = n - j - k;
        // Left half (a, m, c) -> (c, a, m); right half (m, b, c) -> (b, c, m).
        result.back().push_back(first == 2 ? rows[i][k] : rows[j][i]);
      }
    }
    return result;
  };
  const int lowest = strictly ? 1 : 0;
  std::vector<Rows> open = {bernstein_rows(f, domain)};
  for (int looked = 0; !open.empty(); ++looked) {
    if (looked >= pieces) return false;
    const Rows rows = std::move(open.back());
    open.pop_back();
    bool positive = true;
    for (const auto& row : rows) {
      for (const Integer& c : row) positive &= c.sign() >= lowest;
    }
    if (positive) continue;
    for (const Integer& corner : {rows[0].front(), rows[0].back(), rows.back().front(), rows.back().back()}) {
      if (corner.sign() < lowest) return false;
    }
    const auto [left, right] = halves(rows);
    open.push_back(turned(left, 2));
    open.push_back(turned(right, 1));
  }
  return true;
}

}  // namespace bezcert::test
