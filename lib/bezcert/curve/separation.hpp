// How two Bezier pieces lie to each other: sufficient conditions on their control points.
//
// All are sign conditions on cross and dot products of differences of control points; the curve lies in the
// convex hull of its control points because the weights are positive.
#pragma once

#include "bezcert/curve/dyadic_curve.hpp"
#include "bezcert/curve/vector.hpp"

namespace bezcert {

/// From control point i of a to control point j of b, times their weights.
template <class T>
Vector2<T> between(const CurveNet<T>& a, std::size_t i, const CurveNet<T>& b, std::size_t j) {
  return {b.x[j] * a.w[i] - a.x[i] * b.w[j], b.y[j] * a.w[i] - a.y[i] * b.w[j]};
}

/// Whether some line through the origin has all vectors strictly on one side: one of them has all others
/// to its left within less than half a turn.
template <class T>
bool in_open_half_plane(const std::vector<Vector2<T>>& vectors) {
  for (const Vector2<T>& first : vectors) {
    bool is_first = sign_of(dot(first, first)) > 0;
    for (const Vector2<T>& other : vectors) {
      if (!is_first) break;
      if (&other == &first) continue;
      const int turn = sign_of(cross(first, other));
      is_first = turn > 0 || (turn == 0 && sign_of(dot(first, other)) > 0);
    }
    if (is_first) return true;
  }
  return false;
}

/// The piece is strictly monotone in some direction, so it does not meet itself: its control vectors lie in
/// an open half-plane. (c'(t) is a positive combination of p_j - p_i, i < j, sums of control vectors.)
template <class T>
bool is_monotone(const CurveNet<T>& a) {
  std::vector<Vector2<T>> vectors;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) vectors.push_back(between(a, i, a, i + 1));
  return in_open_half_plane(vectors);
}

/// a ends where b begins, and a line through that point has the rest of a strictly on one side and the
/// rest of b strictly on the other: they meet nowhere else.
template <class T>
bool part_at_joint(const CurveNet<T>& a, const CurveNet<T>& b) {
  std::vector<Vector2<T>> vectors;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) vectors.push_back(between(a, i, b, 0));
  for (std::size_t j = 1; j < b.size(); ++j) vectors.push_back(between(b, 0, b, j));
  return in_open_half_plane(vectors);
}

/// The hulls are disjoint: a line through two control points of a has a on its closed left side and b
/// strictly to the right. (Of two disjoint convex polygons, a side of one of them separates: ask both ways.)
template <class T>
bool side_separates(const CurveNet<T>& a, const CurveNet<T>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (i == j) continue;
      const Vector2<T> side = between(a, i, a, j);
      bool separates = true;
      for (std::size_t k = 0; k < b.size() && separates; ++k) {
        separates = sign_of(cross(side, between(a, i, b, k))) < 0;
      }
      for (std::size_t k = 0; k < a.size() && separates; ++k) {
        if (k != i && k != j) separates = sign_of(cross(side, between(a, i, a, k))) >= 0;
      }
      if (separates) return true;
    }
  }
  return false;
}

/// Whether an end point of a is an end point of b.
template <class T>
bool ends_meet(const CurveNet<T>& a, std::size_t end_a, const CurveNet<T>& b, std::size_t end_b) {
  const Vector2<T> gap = between(a, end_a, b, end_b);
  return sign_of(gap.x) == 0 && sign_of(gap.y) == 0;
}

/// b certainly crosses a. With t from the first to the last point of a: a is monotone along t and lies, as b
/// does, in the slab between the normals of t through its end points (b strictly inside); b begins strictly
/// on one side of all of a and ends strictly on the other. Then a, prolonged straight along t at both
/// ends, parts the plane, b cannot meet the prolongations, and so it meets a.
template <class T>
bool certainly_crosses(const CurveNet<T>& a, const CurveNet<T>& b) {
  const std::size_t last = a.size() - 1;
  const Vector2<T> t = between(a, 0, a, last);
  for (std::size_t i = 0; i < last; ++i) {
    if (sign_of(dot(t, between(a, i, a, i + 1))) <= 0) return false;
  }
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (sign_of(dot(t, between(a, 0, b, k))) <= 0) return false;
    if (sign_of(dot(t, between(b, k, a, last))) <= 0) return false;
  }
  const auto side_of_all = [&](std::size_t end) {
    const int side = sign_of(cross(t, between(a, 0, b, end)));
    for (std::size_t i = 1; i <= last && side != 0; ++i) {
      if (sign_of(cross(t, between(a, i, b, end))) != side) return 0;
    }
    return side;
  };
  const int begins = side_of_all(0);
  return begins != 0 && side_of_all(b.size() - 1) == -begins;
}

}  // namespace bezcert
