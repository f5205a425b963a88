#include "bezcert/certificate/pair_evidence.hpp"

#include "bezcert/bernstein/multinomial.hpp"
#include "bezcert/certificate/direction.hpp"
#include "bezcert/certificate/separating_resultant.hpp"
#include "bezcert/curve/separation.hpp"
#include "bezcert/decide/boundary.hpp"

#include <algorithm>
#include <cmath>

namespace bezcert {
namespace {

// n as a vector over the numbers of a net.
template <class T>
Vector2<T> as_vector(const Direction& n) {
  return {number_from_integer<T>(n.x), number_from_integer<T>(n.y)};
}

// `m`: n . P_i increases strictly.
template <class T>
bool increases(const CurveNet<T>& net, const Direction& direction) {
  const Vector2<T> n = as_vector<T>(direction);
  for (std::size_t i = 0; i + 1 < net.size(); ++i) {
    if (sign_of(dot(n, between(net, i, net, i + 1))) <= 0) return false;
  }
  return true;
}

// `s`: n . A < n . B for all control points.
template <class T>
bool separates(const CurveNet<T>& a, const CurveNet<T>& b, const Direction& direction) {
  const Vector2<T> n = as_vector<T>(direction);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (sign_of(dot(n, between(a, i, b, j))) <= 0) return false;
    }
  }
  return true;
}

// `j`, one half of it: with Q the control point `joint`, n . (P - Q) >= 0 for the others, at the other end
// strictly.
template <class T>
bool leaves(const CurveNet<T>& net, std::size_t joint, const Direction& direction) {
  const Vector2<T> n = as_vector<T>(direction);
  for (std::size_t i = 0; i < net.size(); ++i) {
    if (i == joint) continue;
    const int sign = sign_of(dot(n, between(net, joint, net, i)));
    const bool is_end = i == 0 || i + 1 == net.size();
    if (sign < 0 || (is_end && sign == 0)) return false;
  }
  return true;
}

Direction opposite(const Direction& n) { return {-n.x, -n.y}; }

// m 2^exponent: doubles with a wider range. Truncated, so the same in all rounding modes.
struct WideDouble {
  double m = 0;
  long exponent = 0;
};

WideDouble wide(const Integer& value) {
  WideDouble result;
  result.m = mpz_get_d_2exp(&result.exponent, value.backend().data());
  return result;
}

// Exact vectors as doubles over one common power of two.
std::vector<Vector2<double>> rounded(const std::vector<Vector2<WideDouble>>& vectors) {
  long most = std::numeric_limits<long>::min();
  for (const auto& v : vectors) {
    for (const WideDouble& c : {v.x, v.y}) {
      if (c.m != 0) most = std::max(most, c.exponent);
    }
  }
  const auto value = [&](const WideDouble& c) {
    constexpr long least = -900;  // far from underflow, whose rounding depends on the mode
    return c.m == 0 || c.exponent - most < least ? 0.0 : std::ldexp(c.m, static_cast<int>(c.exponent - most));
  };
  std::vector<Vector2<double>> result;
  result.reserve(vectors.size());
  for (const auto& v : vectors) result.push_back({value(v.x), value(v.y)});
  return result;
}

// The control points of a net from control point 0 of `origin`, in doubles, appended.
void append_points(const CurveNet<Integer>& origin, const CurveNet<Integer>& net,
                   std::vector<Vector2<WideDouble>>& points) {
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Vector2<Integer> to = between(origin, 0, net, i);
    const WideDouble x = wide(to.x), y = wide(to.y), w = wide(net.w[i]);
    points.push_back({{x.m / w.m, x.exponent - w.exponent}, {y.m / w.m, y.exponent - w.exponent}});
  }
}

// The larger side of the box of points[first] ... points[last - 1].
double extent(const std::vector<Vector2<double>>& points, std::size_t first, std::size_t last) {
  const auto from = points.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = points.begin() + static_cast<std::ptrdiff_t>(last);
  const auto x = std::minmax_element(from, to, [](const auto& p, const auto& q) { return p.x < q.x; });
  const auto y = std::minmax_element(from, to, [](const auto& p, const auto& q) { return p.y < q.y; });
  return std::max(x.second->x - x.first->x, y.second->y - y.first->y);
}

std::vector<AskedVector<double>> rounded(const std::vector<AskedVector<Integer>>& vectors) {
  std::vector<Vector2<WideDouble>> values;
  values.reserve(vectors.size());
  for (const auto& asked : vectors) values.push_back({wide(asked.v.x), wide(asked.v.y)});
  const std::vector<Vector2<double>> doubles = rounded(values);
  std::vector<AskedVector<double>> result;
  result.reserve(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) result.push_back({doubles[i], vectors[i].strict});
  return result;
}

// Where resultants are tried.
enum class Resultants { at_tangent_joints, everywhere };

// Writes SELF and PAIR, piece by piece. Every function returns false when a limit is reached.
class PairWriter {
 public:
  using Piece = DyadicCurve::Piece;

  PairWriter(const PairLimits& limits, Resultants resultants) : limits_(limits), resultants_(resultants) {}

  std::string& text() { return text_; }

  bool self(DyadicCurve& curve, Piece piece) {
    if (!take(curve, piece)) return false;
    if (const auto n = monotone(curve, piece)) {
      write(" m ", *n);
      return true;
    }
    const auto [first, second] = curve.halves(piece);
    text_ += " h";
    return self(curve, first) && self(curve, second) && pair(curve, first, curve, second, {true, false});
  }

  bool pair(DyadicCurve& a, Piece piece_a, DyadicCurve& b, Piece piece_b, Joints joints) {
    if (!take(a, piece_a) || !take(b, piece_b)) return false;
    const CurveNet<Integer>&net_a = a.exact(piece_a), &net_b = b.exact(piece_b);
    bool halve_a = a.depth(piece_a) <= b.depth(piece_b);
    if (joints.end_to_begin != joints.begin_to_end) {
      const std::size_t end_a = joints.end_to_begin ? net_a.size() - 1 : 0;
      const std::size_t end_b = joints.end_to_begin ? 0 : net_b.size() - 1;
      if (const auto n = parting(a, piece_a, end_a, b, piece_b, end_b)) {
        write(" j ", *n);
        return true;
      }
    } else if (!joints.end_to_begin) {
      std::vector<Vector2<WideDouble>> wide_points;
      append_points(net_a, net_a, wide_points);
      append_points(net_a, net_b, wide_points);
      const std::vector<Vector2<double>> points = rounded(wide_points);
      if (const auto n = separating(a, piece_a, b, piece_b, points)) {
        write(" s ", *n);
        return true;
      }
      halve_a = extent(points, 0, net_a.size()) >= extent(points, net_a.size(), points.size());
    }
    if (resultant_may_help(a, piece_a, b, piece_b, joints) && resultant_separates(net_a, net_b, joints)) {
      text_ += " r";
      return true;
    }
    if (halve_a) {
      const auto [first, second] = a.halves(piece_a);
      text_ += " a";
      return pair(a, first, b, piece_b, {false, joints.begin_to_end}) &&
             pair(a, second, b, piece_b, {joints.end_to_begin, false});
    }
    const auto [first, second] = b.halves(piece_b);
    text_ += " b";
    return pair(a, piece_a, b, first, {joints.end_to_begin, false}) &&
           pair(a, piece_a, b, second, {false, joints.begin_to_end});
  }

 private:
  void write(const char* rule, const Direction& n) {
    text_ += rule;
    text_ += text_of(n);
  }

  bool take(const DyadicCurve& curve, Piece piece) {
    return ++pieces_ <= limits_.pieces && curve.depth(piece) <= limits_.depth;
  }

  std::optional<Direction> monotone(DyadicCurve& curve, Piece piece) {
    const CurveNet<Integer>& net = curve.exact(piece);
    std::vector<AskedVector<Integer>> vectors;
    for (std::size_t i = 0; i + 1 < net.size(); ++i) vectors.push_back({between(net, i, net, i + 1), true});
    return find_direction(
        rounded(vectors), [&] { return vectors; },
        [&](const Direction& n) {
          return filtered(curve, piece, curve, piece,
                          [&](const auto& one, const auto&) { return increases(one, n); });
        });
  }

  std::optional<Direction> parting(DyadicCurve& a, Piece piece_a, std::size_t end_a, DyadicCurve& b,
                                   Piece piece_b, std::size_t end_b) {
    std::vector<AskedVector<Integer>> vectors;
    const auto ask = [&](const CurveNet<Integer>& net, std::size_t joint, bool towards) {
      for (std::size_t i = 0; i < net.size(); ++i) {
        if (i == joint) continue;
        const bool is_end = i == 0 || i + 1 == net.size();
        vectors.push_back({towards ? between(net, i, net, joint) : between(net, joint, net, i), is_end});
      }
    };
    ask(a.exact(piece_a), end_a, true);
    ask(b.exact(piece_b), end_b, false);
    return find_direction(
        rounded(vectors), [&] { return vectors; },
        [&](const Direction& n) {
          return filtered(a, piece_a, b, piece_b, [&](const auto& one, const auto& other) {
            return leaves(one, end_a, opposite(n)) && leaves(other, end_b, n);
          });
        });
  }

  std::optional<Direction> separating(DyadicCurve& a, Piece piece_a, DyadicCurve& b, Piece piece_b,
                                      const std::vector<Vector2<double>>& points) {
    const CurveNet<Integer>&net_a = a.exact(piece_a), &net_b = b.exact(piece_b);
    std::vector<AskedVector<double>> vectors;
    vectors.reserve(net_a.size() * net_b.size());
    for (std::size_t i = 0; i < net_a.size(); ++i) {
      for (std::size_t j = 0; j < net_b.size(); ++j) {
        vectors.push_back({points[net_a.size() + j] - points[i], true});
      }
    }
    const auto exact = [&] {
      std::vector<AskedVector<Integer>> result;
      for (std::size_t i = 0; i < net_a.size(); ++i) {
        for (std::size_t j = 0; j < net_b.size(); ++j) {
          result.push_back({between(net_a, i, net_b, j), true});
        }
      }
      return result;
    };
    return find_direction(vectors, exact, [&](const Direction& n) {
      return filtered(a, piece_a, b, piece_b,
                      [&](const auto& one, const auto& other) { return separates(one, other, n); });
    });
  }

  bool resultant_may_help(DyadicCurve& a, Piece piece_a, DyadicCurve& b, Piece piece_b, Joints joints) {
    if (joints.end_to_begin && joints.begin_to_end) return false;
    const CurveNet<Integer>&net_a = a.exact(piece_a), &net_b = b.exact(piece_b);
    const std::size_t last_a = net_a.size() - 1, last_b = net_b.size() - 1;
    if (joints.end_to_begin || joints.begin_to_end) {
      const Vector2<Integer> along_a =
          joints.end_to_begin ? between(net_a, last_a, net_a, last_a - 1) : between(net_a, 0, net_a, 1);
      const Vector2<Integer> along_b =
          joints.end_to_begin ? between(net_b, 0, net_b, 1) : between(net_b, last_b, net_b, last_b - 1);
      if (!cross(along_a, along_b).is_zero() || dot(along_a, along_b).sign() <= 0) return false;
    } else if (resultants_ == Resultants::at_tangent_joints) {
      return false;
    }
    // Large degrees take long.
    constexpr std::size_t effort = 16384;
    const std::size_t degrees = last_a * last_b;
    effort_ += degrees * degrees;
    return effort_ <= effort;
  }

  const PairLimits& limits_;
  Resultants resultants_;
  std::size_t pieces_ = 0;
  std::size_t effort_ = 0;  // of resultants
  std::string text_;
};

// Lines alone do nearly always, and then few pieces do. Curves that run along each other at a small distance
// would take very many, and one resultant.
template <class Write>
std::optional<std::string> written(const PairLimits& limits, Write write) {
  constexpr std::size_t few = 512;
  for (const Resultants resultants : {Resultants::at_tangent_joints, Resultants::everywhere}) {
    PairLimits these = limits;
    if (resultants == Resultants::at_tangent_joints) these.pieces = std::min(limits.pieces, few);
    PairWriter writer(these, resultants);
    if (write(writer)) return writer.text().substr(1);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> self_evidence(DyadicCurve& curve, const PairLimits& limits) {
  return written(limits, [&](PairWriter& writer) { return writer.self(curve, DyadicCurve::whole); });
}

std::optional<std::string> pair_evidence(DyadicCurve& a, DyadicCurve& b, Joints joints,
                                         const PairLimits& limits) {
  return written(limits, [&](PairWriter& writer) {
    return writer.pair(a, DyadicCurve::whole, b, DyadicCurve::whole, joints);
  });
}

std::optional<std::string> boundary_evidence(const Forms& forms) {
  std::deque<DyadicCurve> curves = edge_curves(forms);
  std::string text = "boundary";
  for (DyadicCurve& curve : curves) {
    const auto self = self_evidence(curve);
    if (!self) return std::nullopt;
    text += ' ' + *self;
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t j = i + 1; j < curves.size(); ++j) {
      const auto pair = pair_evidence(curves[i], curves[j], {j == i + 1, i == 0 && j + 1 == curves.size()});
      if (!pair) return std::nullopt;
      text += ' ' + *pair;
    }
  }
  return text;
}

}  // namespace bezcert
