// What a block computes of an element, over any number type: Lanes, or StaticBound for the error bounds.
//
// Control points are relative to the first one. With a_i the Bernstein coefficients of x_u and b_j those of
// x_v (differences of control points; rational: of W X_u - X W_u and W X_v - X W_v, times W^2 those of x):
//
// 1. The Bernstein coefficients of det J (rational: of degree_factor N) and their extremes. Polynomial:
//    det J is degree_factor times the product x_u x x_v, whose scaled coefficients are sums of cross products
//    a_i x b_j; by uniqueness they are those of N in jacobian.md. Rational: N = F_0 . (F_1 x F_2), expanded
//    by the minors [r s] = W_r X_s - X_r W_s (and with Y) of two sub-nets F_r, F_s that the columns need as
//    well: as W = sum xi_r W_r and X_u / n = X_1 - X_0,
//      (W X_u - X W_u) / n = sum xi_r ([r 1] - [r 0]) = (xi_0 + xi_1) [0 1] + xi_2 ([0 2] - [1 2]),
//      (W X_v - X W_v) / n = sum xi_r ([r 2] - [r 0]) = (xi_0 + xi_2) [0 2] + xi_1 ([1 2] + [0 1]).
//
// 2. Cone. For any two vectors a, b: (a_i x b_j)(a x b) = P_i S_j - Q_i R_j with P_i = a_i x b,
//    Q_i = a x a_i, R_j = b_j x b, S_j = a x b_j (the Pluecker relation; exact for whatever doubles a, b
//    are). Let p, s be lower bounds of all P_i, S_j, and q, r upper bounds of all |Q_i|, |R_j|. If p, s > 0
//    and p s > q r, then all (a_i x b_j)(a x b) > 0. As some a_i x b_j is a corner coefficient of N (up to a
//    positive factor), which is > 0 by 1, a x b > 0 and all a_i x b_j > 0. Then all mixed terms a_i x b_j +
//    a_j x b_i of the Jacobian's hull are > 0: the condition of jacobian_hull holds. On the square
//    jacobian_hull takes both columns in one basis: its a's and b's are convex combinations of these, so it
//    holds there as well. This takes one pass instead of all pairs.
//
// 3. Mixed. All pairs a_i x b_j + a_j x b_i, for elements that 2 leaves open (not on the square).
#pragma once

#include "bezcert/batch/block.hpp"

namespace bezcert::batch {

/// What comes out, each with its bound if T is StaticBound.
template <class T>
struct Extent {
  T lowest{}, highest{};  ///< of the coefficients of det J (rational: of degree_factor N)
  T corner[4]{};
  T p{}, q{}, r{}, s{};
};

/// P: the degree (square: in both directions) if known at compile time, or 0.
template <class T, Kind kind, int P>
class Kernel {
 public:
  static constexpr bool is_square = kind == Kind::square;
  static constexpr bool is_rational = kind == Kind::rational_triangle;
  static constexpr int corner_count = is_square ? 4 : 3;
  static constexpr int cap = P > 0 ? P : max_block_degree;
  static constexpr int triangle_size(int n) { return (n + 1) * (n + 2) / 2; }
  static constexpr int point_cap = is_square ? (cap + 1) * (cap + 1) : triangle_size(cap);
  static constexpr int column_cap = is_square     ? cap * (cap + 1)
                                    : is_rational ? triangle_size(2 * cap - 1)
                                                  : triangle_size(cap - 1);
  static constexpr int homogeneous_cap = is_rational ? point_cap : 1;

  /// Nodes or control points as given, relative to the first; weights of rational elements.
  T node_x[point_cap], node_y[point_cap], weight[homogeneous_cap];

  explicit Kernel(const BlockTable& table) : table_(table) {}

  BEZCERT_INLINE int degree() const { return P > 0 ? P : table_.p; }
  BEZCERT_INLINE int degree_v() const { return !is_square ? 0 : P > 0 ? P : table_.q; }
  BEZCERT_INLINE int point_count() const {
    return is_square ? (degree() + 1) * (degree_v() + 1) : triangle_size(degree());
  }

  BEZCERT_INLINE void run(Extent<T>& result, bool cone) {
    control_points();
    if constexpr (is_rational) {
      homogeneous();
      rational_forms(result, cone);
    } else {
      polynomial_columns();
      polynomial_determinant(result);
    }
    if (cone) find_cone(result);
  }

  /// The smallest mixed term. Precondition: run with `cone`; not on the square.
  BEZCERT_INLINE T mixed() const {
    const int count = column_count_u();
    T lowest = cross(0, 0);
    for (int i = 0; i < count; ++i) {
      for (int j = i; j < count; ++j) lowest = smaller(lowest, cross(i, j) + cross(j, i));
    }
    return lowest;
  }

 private:
  /// Position of row r, column c in a triangle of degree n, or in a square with n + 1 columns.
  BEZCERT_INLINE static int at(int n, int r, int c) {
    return is_square ? r * (n + 1) + c : r * (n + 1) - r * (r - 1) / 2 + c;
  }
  BEZCERT_INLINE static int most(int a, int b) { return a > b ? a : b; }
  BEZCERT_INLINE static int least(int a, int b) { return a < b ? a : b; }

  BEZCERT_INLINE int column_count_u() const {
    return is_square     ? degree() * (degree_v() + 1)
           : is_rational ? triangle_size(2 * degree() - 1)
                         : triangle_size(degree() - 1);
  }
  BEZCERT_INLINE int column_count_v() const {
    return is_square ? (degree() + 1) * degree_v() : column_count_u();
  }

  BEZCERT_INLINE void control_points() {
    if (!table_.lagrange) {
      x_ = node_x;
      y_ = node_y;
      return;
    }
    for (int i = 0; i < point_count(); ++i) {
      const int end = table_.row_start[i + 1];
      int k = table_.row_start[i];
      T x = node_x[table_.column[k]] * table_.value[k];
      T y = node_y[table_.column[k]] * table_.value[k];
      for (++k; k < end; ++k) {
        x = x + node_x[table_.column[k]] * table_.value[k];
        y = y + node_y[table_.column[k]] * table_.value[k];
      }
      point_x_[i] = x;
      point_y_[i] = y;
    }
    x_ = point_x_;
    y_ = point_y_;
  }

  BEZCERT_INLINE void homogeneous() {
    for (int i = 0; i < point_count(); ++i) {
      point_x_[i] = x_[i] * weight[i];
      point_y_[i] = y_[i] * weight[i];
    }
    x_ = point_x_;
    y_ = point_y_;
  }

  // Differences of neighbours: along u, then along v (triangle: towards corner 1, corner 2).
  BEZCERT_INLINE void differences(const T* from, T* along_u, T* along_v) const {
    const int n = degree();
    if constexpr (is_square) {
      const int m = degree_v();
      for (int r = 0; r <= m; ++r) {
        for (int c = 0; c < n; ++c) along_u[at(n - 1, r, c)] = from[at(n, r, c + 1)] - from[at(n, r, c)];
      }
      for (int r = 0; r < m; ++r) {
        for (int c = 0; c <= n; ++c) along_v[at(n, r, c)] = from[at(n, r + 1, c)] - from[at(n, r, c)];
      }
    } else {
      for (int r = 0; r < n; ++r) {
        for (int c = 0; c < n - r; ++c) {
          along_u[at(n - 1, r, c)] = from[at(n, r, c + 1)] - from[at(n, r, c)];
          along_v[at(n - 1, r, c)] = from[at(n, r + 1, c)] - from[at(n, r, c)];
        }
      }
    }
  }

  BEZCERT_INLINE void polynomial_columns() {
    differences(x_, ax_, bx_);
    differences(y_, ay_, by_);
  }

  BEZCERT_INLINE T cross(int i, int j) const { return ax_[i] * by_[j] - ay_[i] * bx_[j]; }

  // One more coefficient of det J.
  BEZCERT_INLINE void add(Extent<T>& result, int index, int corner, const T& value) const {
    if (index == 0) {
      // The first is corner 0; in degree 0 it is all of them.
      result.lowest = result.highest = value;
      for (int k = 0; k < corner_count; ++k) result.corner[k] = value;
      return;
    }
    result.lowest = smaller(result.lowest, value);
    result.highest = larger(result.highest, value);
    if (corner >= 0) result.corner[corner] = value;
  }

  // The corner at row r, column c of degrees n (and m), or -1.
  BEZCERT_INLINE static int corner_at(int n, int m, int r, int c) {
    if (is_square) {
      if (r != 0 && r != m) return -1;
      return c == 0 ? (r == 0 ? 0 : 3) : c == n ? (r == 0 ? 1 : 2) : -1;
    }
    return c == 0 ? (r == 0 ? 0 : r == n ? 2 : -1) : c == n ? 1 : -1;
  }

  BEZCERT_INLINE void polynomial_determinant(Extent<T>& result) const {
    // Scaled coefficients: those of the factors are multiplied by multinomials, products are divided by them.
    T ux[column_cap], uy[column_cap], vx[column_cap], vy[column_cap];
    for (int i = 0; i < column_count_u(); ++i) {
      ux[i] = ax_[i] * table_.along_u[i];
      uy[i] = ay_[i] * table_.along_u[i];
    }
    for (int i = 0; i < column_count_v(); ++i) {
      vx[i] = bx_[i] * table_.along_v[i];
      vy[i] = by_[i] * table_.along_v[i];
    }
    const auto term = [&](int u, int v) { return ux[u] * vy[v] - uy[u] * vx[v]; };
    T sums[is_square ? 4 * cap * cap : triangle_size(2 * cap - 2)];
    const int n = degree(), m = degree_v();
    if constexpr (is_square) {
      product({n - 1, m}, {n, m - 1}, term, sums);
      finish(result, 2 * n - 1, 2 * m - 1, sums);
    } else {
      product({n - 1, 0}, {n - 1, 0}, term, sums);
      finish(result, 2 * n - 2, 0, sums);
    }
  }

  // The coefficients of det J from scaled ones, in degrees n (and m).
  BEZCERT_INLINE void finish(Extent<T>& result, int n, int m, const T* sums) const {
    int i = 0;
    for (int r = 0; r <= (is_square ? m : n); ++r) {
      for (int c = 0; c <= (is_square ? n : n - r); ++c, ++i) {
        add(result, i, corner_at(n, m, r, c), sums[i] * table_.determinant[i]);
      }
    }
  }

  struct Degrees {
    int p, q;
  };

  // A product in scaled coefficients: to coefficient (r + s, c + d) goes term(position of (r, c), position of
  // (s, d)). The inner loops have constant length, so that nothing depends on short loops' ends.
  template <class Term>
  BEZCERT_INLINE static void product(Degrees f, Degrees g, Term term, T* result) {
    const int n = f.p + g.p;
    const int size = is_square ? (n + 1) * (f.q + g.q + 1) : triangle_size(n);
    for (int i = 0; i < size; ++i) result[i] = T{};
    int u = 0;
    for (int r = 0; r <= (is_square ? f.q : f.p); ++r) {
      for (int c = 0; c <= (is_square ? f.p : f.p - r); ++c, ++u) {
        int v = 0;
        for (int s = 0; s <= (is_square ? g.q : g.p); ++s) {
          T* to = result + at(n, r + s, c);
          for (int d = 0; d <= (is_square ? g.p : g.p - s); ++d, ++v) to[d] = to[d] + term(u, v);
        }
      }
    }
  }

  // One minor f other - g h of degree 2 (n-1), in scaled coefficients.
  BEZCERT_INLINE void minor(const T* f, const T* g, const T* h, const T* other, T* result) const {
    const int n = degree() - 1;
    product(
        {n, 0}, {n, 0}, [&](int u, int v) { return f[u] * other[v] - g[u] * h[v]; }, result);
  }

  BEZCERT_INLINE void rational_forms(Extent<T>& result, bool cone) {
    // The sub-nets F_0, F_1, F_2, in scaled coefficients.
    const int n = degree() - 1;
    T fx[3][triangle_size(cap - 1)], fy[3][triangle_size(cap - 1)], fw[3][triangle_size(cap - 1)];
    int i = 0;
    for (int r = 0; r <= n; ++r) {
      for (int c = 0; c <= n - r; ++c, ++i) {
        for (int k = 0; k < 3; ++k) {
          const int from = at(n + 1, r + (k == 2), c + (k == 1));
          fx[k][i] = x_[from] * table_.along_u[i];
          fy[k][i] = y_[from] * table_.along_u[i];
          fw[k][i] = weight[from] * table_.along_u[i];
        }
      }
    }
    constexpr int size = triangle_size(2 * cap - 2);
    T x01[size], x02[size], x12[size], y01[size], y02[size], y12[size], xy12[size];
    minor(fw[1], fx[1], fw[2], fx[2], x12);
    minor(fw[1], fy[1], fw[2], fy[2], y12);
    minor(fx[1], fy[1], fx[2], fy[2], xy12);
    // F_1 x F_2 = (Y_1 W_2 - W_1 Y_2, W_1 X_2 - X_1 W_2, X_1 Y_2 - Y_1 X_2) = (-y12, x12, xy12).
    T sums[triangle_size(3 * cap - 3)];
    product(
        {n, 0}, {2 * n, 0},
        [&](int u, int v) { return fw[0][u] * xy12[v] + (fy[0][u] * x12[v] - fx[0][u] * y12[v]); }, sums);
    finish(result, 3 * n, 0, sums);
    if (!cone) return;
    minor(fw[0], fx[0], fw[1], fx[1], x01);
    minor(fw[0], fx[0], fw[2], fx[2], x02);
    minor(fw[0], fy[0], fw[1], fy[1], y01);
    minor(fw[0], fy[0], fw[2], fy[2], y02);
    rational_columns(x01, x02, x12, ax_, bx_);
    rational_columns(y01, y02, y12, ay_, by_);
  }

  // The columns from the minors [0 1], [0 2], [1 2]: multiplication by xi_r moves scaled coefficients by one.
  BEZCERT_INLINE void rational_columns(const T* m01, const T* m02, const T* m12, T* a, T* b) const {
    const int n = 2 * degree() - 2;
    int i = 0;
    for (int r = 0; r <= n + 1; ++r) {
      for (int c = 0; c <= n + 1 - r; ++c, ++i) {
        const bool has0 = r + c <= n, has1 = c > 0, has2 = r > 0;
        const int from0 = at(n, r, c), from1 = at(n, r, c - 1), from2 = at(n, r - 1, c);
        T u{}, v{};
        if (has0) {
          u = m01[from0];
          v = m02[from0];
        }
        if (has1) {
          u = u + m01[from1];
          v = v + (m12[from1] + m01[from1]);
        }
        if (has2) {
          u = u + (m02[from2] - m12[from2]);
          v = v + m02[from2];
        }
        a[i] = u * table_.columns[i];
        b[i] = v * table_.columns[i];
      }
    }
  }

  BEZCERT_INLINE void find_cone(Extent<T>& result) const {
    const auto total = [](const T* values, int count) {
      T sum = values[0];
      for (int i = 1; i < count; ++i) sum = sum + values[i];
      return as_exact(sum);
    };
    const int count_u = column_count_u(), count_v = column_count_v();
    const T ax = total(ax_, count_u), ay = total(ay_, count_u);
    const T bx = total(bx_, count_v), by = total(by_, count_v);
    for (int i = 0; i < count_u; ++i) {
      const T p = ax_[i] * by - ay_[i] * bx;
      const T q = absolute(ax * ay_[i] - ay * ax_[i]);
      result.p = i == 0 ? p : smaller(result.p, p);
      result.q = i == 0 ? q : larger(result.q, q);
    }
    for (int j = 0; j < count_v; ++j) {
      const T r = absolute(bx_[j] * by - by_[j] * bx);
      const T s = ax * by_[j] - ay * bx_[j];
      result.r = j == 0 ? r : larger(result.r, r);
      result.s = j == 0 ? s : smaller(result.s, s);
    }
  }

  const BlockTable& table_;
  const T* x_ = nullptr;
  const T* y_ = nullptr;
  T point_x_[point_cap], point_y_[point_cap];
  T ax_[column_cap], ay_[column_cap], bx_[column_cap], by_[column_cap];
};

}  // namespace bezcert::batch
