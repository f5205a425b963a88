// The subdivision of JacobianTree played again in rationals: corners by the rule in the header, coefficients
// of N by split at 1/2. Nothing of JacobianTree or bisect.
#pragma once

#include "element/random_net.hpp"

#include "bezcert/element/jacobian_tree.hpp"

#include <algorithm>
#include <vector>

namespace bezcert::test {

/// Corners counter-clockwise, and N (times a positive number) over the piece.
struct ReplayedPiece {
  std::vector<Values> corners;
  int depth = 0;
  std::size_t parent = 0;
  Polynomial<Rational> numerator;
  bool leaf = true;
};

inline Values middle(const Values& a, const Values& b) {
  Values result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back((a[k] + b[k]) / 2);
  return result;
}

/// Over corners (A, B, C): the coefficient of exponents (i, j, k) becomes that of (order[0], order[1],
/// order[2]).
inline Polynomial<Rational> turned(const Polynomial<Rational>& f, const std::array<std::size_t, 3>& order) {
  Polynomial<Rational> result(f.shape);
  for (const auto& [r, c] : rows_and_columns(f.shape)) {
    const std::array<int, 3> old{f.shape.degree(0) - r - c, c, r};
    result.at(old[order[2]], old[order[1]]) = f.at(r, c);
  }
  return result;
}

class ReplayedTree {
 public:
  explicit ReplayedTree(const ControlNet& net) {
    const Element element = bernstein_element(net);
    ReplayedPiece root;
    if (element.is_triangle()) {
      root.corners = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    } else {
      root.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    }
    root.numerator = as_rational(jacobian_numerator(exact_net(element).net));
    pieces_.push_back(root);
  }

  const ReplayedPiece& operator[](std::size_t piece) const { return pieces_[piece]; }
  std::size_t size() const { return pieces_.size(); }
  std::vector<std::size_t> leaves() const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (pieces_[k].leaf) result.push_back(k);
    }
    return result;
  }

  /// A triangle (A, B, C) becomes (C, A, M) and (B, C, M); a rectangle is halved in u at even depth, in v at
  /// odd depth, lower half first.
  void split_piece(std::size_t piece) {
    pieces_[piece].leaf = false;
    const ReplayedPiece whole = pieces_[piece];
    const auto& at = whole.corners;
    ReplayedPiece first, second;
    const int direction = at.size() == 3 ? 0 : whole.depth % 2;
    const auto parts = bezcert::split(whole.numerator, Rational(1, 2), direction);
    if (at.size() == 3) {
      const Values m = middle(at[0], at[1]);
      first.corners = {at[2], at[0], m};
      second.corners = {at[1], at[2], m};
      first.numerator = turned(parts.first, {2, 0, 1});    // (A, M, C) -> (C, A, M)
      second.numerator = turned(parts.second, {1, 2, 0});  // (M, B, C) -> (B, C, M)
    } else if (direction == 0) {
      const Values low = middle(at[0], at[1]);
      const Values high = middle(at[3], at[2]);
      first.corners = {at[0], low, high, at[3]};
      second.corners = {low, at[1], at[2], high};
      first.numerator = parts.first;
      second.numerator = parts.second;
    } else {
      const Values left = middle(at[0], at[3]);
      const Values right = middle(at[1], at[2]);
      first.corners = {at[0], at[1], right, left};
      second.corners = {left, right, at[2], at[3]};
      first.numerator = parts.first;
      second.numerator = parts.second;
    }
    for (ReplayedPiece* child : {&first, &second}) {
      child->depth = whole.depth + 1;
      child->parent = piece;
      pieces_.push_back(*child);
    }
  }

  /// The parameter of the domain of a local parameter of a piece.
  Values in_domain(std::size_t piece, const std::vector<Rational>& local) const {
    const auto& at = pieces_[piece].corners;
    const std::vector<Rational> weights =
        at.size() == 3 ? local
                       : std::vector<Rational>{(1 - local[0]) * (1 - local[1]), local[0] * (1 - local[1]),
                                               local[0] * local[1], (1 - local[0]) * local[1]};
    Values result(at[0].size());
    for (std::size_t k = 0; k < at.size(); ++k) {
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += weights[k] * at[k][i];
    }
    return result;
  }

 private:
  std::vector<ReplayedPiece> pieces_;
};

/// Twice the area in (u, v).
inline Rational doubled_area(const std::vector<Values>& corners) {
  Rational sum = 0;
  const std::size_t u = corners.size() == 3 ? 1 : 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Values& a = corners[k];
    const Values& b = corners[(k + 1) % corners.size()];
    sum += a[u] * b[u + 1] - a[u + 1] * b[u];
  }
  return sum;
}

/// A mixture of elements: random, nearly the identity, exactly degenerate ones, those nearly so, huge and
/// tiny ones.
inline ControlNet tree_net(Random& random, int triangle_degree, int square_degree) {
  const auto shapes = element_shapes(triangle_degree, square_degree);
  const Shape shape =
      shapes[static_cast<std::size_t>(random.integer(0, static_cast<long>(shapes.size()) - 1))];
  const Points points = random_points(random);
  ControlNet net = random_net(random, shape, points, random_weights(random));
  if (random.chance(25)) degenerate(random, net);
  if (random.chance(40)) skew(random, net);
  if (random.chance(20)) nudge(random, net);
  if (random.chance(10)) stretch(random, net);
  return net;
}

/// The same cuts in a tree and its replay; the tree's children must be the two last pieces.
inline void split_both(JacobianTree& tree, ReplayedTree& replay, std::size_t piece) {
  const auto [first, second] = tree.split(piece);
  replay.split_piece(piece);
  if (first + 2 != replay.size() || second + 1 != replay.size() || tree.piece_count() != replay.size()) {
    throw std::logic_error("children are not the two last pieces");
  }
}

inline void split_randomly(Random& random, JacobianTree& tree, ReplayedTree& replay, int times) {
  for (int k = 0; k < times; ++k) {
    const auto leaves = replay.leaves();
    split_both(tree, replay,
               leaves[static_cast<std::size_t>(random.integer(0, static_cast<long>(leaves.size()) - 1))]);
  }
}

}  // namespace bezcert::test
