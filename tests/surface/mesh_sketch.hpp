// Meshes built in code, and their verdict from the elements up.
#pragma once

#include "bezcert/decide/decide.hpp"
#include "bezcert/report/obstacle_text.hpp"
#include "mesh_parts.hpp"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace bezcert::test {

/// Nodes and elements in the Bernstein basis. Edges are curves between corner nodes: those with control
/// points given by `curve` are shared by all elements at the edge, others are straight.
class MeshSketch {
 public:
  using Node = std::uint32_t;

  Node node(const Rational& x, const Rational& y, const Rational& w = 1) {
    x_.push_back(x);
    y_.push_back(y);
    w_.push_back(w);
    return static_cast<Node>(x_.size() - 1);
  }

  /// Sets the inner control nodes of the edge from a to b.
  void curve(Node a, Node b, std::vector<Node> inner) {
    curves_[{b, a}] = {inner.rbegin(), inner.rend()};
    curves_[{a, b}] = std::move(inner);
  }

  /// Corners counter-clockwise; all edges of this degree (1 to 3). Returns the element's index.
  std::size_t triangle(Node a, Node b, Node c, int p = 1) {
    const std::array<std::vector<Node>, 3> sides = {side(a, b, p), side(b, c, p), side(c, a, p)};
    std::vector<Node> nodes(coefficient_count(Shape::triangle(p)));
    for (int k = 0; k <= p; ++k) {
      const auto at = [&](int row, int column) -> Node& {
        return nodes[coefficient_index(Shape::triangle(p), row, column)];
      };
      const auto i = static_cast<std::size_t>(k);
      at(0, k) = sides[0][i];
      at(k, p - k) = sides[1][i];
      at(p - k, 0) = sides[2][i];
    }
    if (p == 3) {
      // The middle that makes quadratic edges, raised, a quadratic triangle: sum of edge points / 4 - corners
      // / 6.
      Rational x = 0, y = 0;
      for (const auto& one : sides) {
        for (const std::size_t i : {1, 2}) x += x_[one[i]] / 4, y += y_[one[i]] / 4;
        x -= x_[one[0]] / 6;
        y -= y_[one[0]] / 6;
      }
      nodes[coefficient_index(Shape::triangle(3), 1, 1)] = node(x, y);
    }
    return add(Shape::triangle(p), std::move(nodes));
  }

  /// Corners counter-clockwise; degrees p along a b and c d, q along b c and d a. Inner points by Coons'
  /// formula.
  std::size_t quad(Node a, Node b, Node c, Node d, int p = 1, int q = 1) {
    const auto bottom = side(a, b, p), right = side(b, c, q), top = side(d, c, p), left = side(a, d, q);
    std::vector<Node> nodes;
    for (int r = 0; r <= q; ++r) {
      for (int s = 0; s <= p; ++s) {
        const auto i = static_cast<std::size_t>(s), j = static_cast<std::size_t>(r);
        if (r == 0) {
          nodes.push_back(bottom[i]);
        } else if (r == q) {
          nodes.push_back(top[i]);
        } else if (s == 0) {
          nodes.push_back(left[j]);
        } else if (s == p) {
          nodes.push_back(right[j]);
        } else {
          const Rational u(s, p), v(r, q);
          const auto inner = [&](const std::vector<Rational>& at) {
            return Rational((1 - v) * at[bottom[i]] + v * at[top[i]] + (1 - u) * at[left[j]] +
                            u * at[right[j]] - (1 - u) * (1 - v) * at[a] - u * (1 - v) * at[b] -
                            u * v * at[c] - (1 - u) * v * at[d]);
          };
          nodes.push_back(node(inner(x_), inner(y_)));
        }
      }
    }
    return add(Shape::square(p, q), std::move(nodes));
  }

  /// An element of any shape with its nodes in coefficient order.
  std::size_t add(Shape shape, std::vector<Node> nodes) {
    elements_.push_back({shape, std::move(nodes)});
    return elements_.size() - 1;
  }

  /// Gives an element another node in place of one of its own.
  void replace(std::size_t element, Node from, Node to) {
    for (Node& one : elements_[element].second) {
      if (one == from) one = to;
    }
  }
  Rational& x(Node node) { return x_[node]; }
  Rational& y(Node node) { return y_[node]; }
  Rational& weight(Node node) { return w_[node]; }
  std::size_t node_count() const { return x_.size(); }
  const std::vector<std::pair<Shape, std::vector<Node>>>& elements() const { return elements_; }

  /// The mesh, its elements in the given order (all in turn if empty), with points of their own if not
  /// `by_nodes`.
  Mesh build(bool by_nodes = true, const std::vector<std::size_t>& order = {}) const {
    MeshParts mesh;
    mesh.glued_by_nodes = by_nodes;
    bool weighted = false;
    for (const Rational& w : w_) weighted = weighted || w != 1;
    std::vector<Node> used;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const auto& [shape, nodes] = elements_[order.empty() ? i : order[i]];
      mesh.elements.push_back({shape, Basis::bernstein, mesh.connectivity.size()});
      for (const Node one : nodes) {
        mesh.connectivity.push_back(by_nodes ? one : static_cast<Node>(used.size()));
        used.push_back(one);
      }
    }
    if (by_nodes) {
      used.clear();
      for (Node i = 0; i < x_.size(); ++i) used.push_back(i);
    }
    for (const Node one : used) {
      mesh.x.push_back(x_[one]);
      mesh.y.push_back(y_[one]);
      if (weighted) mesh.weights.push_back(w_[one]);
    }
    return mesh.build();
  }

 private:
  std::vector<Node> side(Node a, Node b, int p) {
    const auto found = curves_.find({a, b});
    if (found == curves_.end() || found->second.size() + 1 != static_cast<std::size_t>(p)) {
      std::vector<Node> inner;
      for (int k = 1; k < p; ++k) {
        const Rational t(k, p);
        inner.push_back(node((1 - t) * x_[a] + t * x_[b], (1 - t) * y_[a] + t * y_[b]));
      }
      curve(a, b, inner);
    }
    std::vector<Node> result = {a};
    const auto& inner = curves_[{a, b}];
    result.insert(result.end(), inner.begin(), inner.end());
    result.push_back(b);
    return result;
  }

  std::vector<Rational> x_, y_, w_;
  std::map<std::pair<Node, Node>, std::vector<Node>> curves_;
  std::vector<std::pair<Shape, std::vector<Node>>> elements_;
};

/// A result with the mesh that its surface refers to.
struct Examined : MeshResult {
  std::shared_ptr<const Mesh> mesh;
};

/// The verdict with every element decided first.
inline Examined examine(Mesh given) {
  const auto mesh = std::make_shared<const Mesh>(std::move(given));
  std::vector<ElementState> states;
  for (std::size_t i = 0; i < mesh->elements().size(); ++i) {
    const Element element = mesh->element(i);
    const ElementVerdict verdict = decide(element).verdict;
    states.push_back(verdict == ElementVerdict::injective ? ElementState::injective
                     : is_invalid(verdict)                ? ElementState::invalid
                                                          : ElementState::open);
  }
  return {examine_mesh(*mesh, states), mesh};
}

inline std::string text_of(const Examined& result) {
  std::string text(name(result.verdict));
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    text += "\n  " + std::string(name(obstacle.kind())) + ": " + message(*result.mesh, obstacle);
  }
  return text;
}

/// The first obstacle of the verdict's kind.
inline MeshObstacle first_obstacle(const MeshResult& result) {
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    if (obstacle.kind() == result.verdict) return obstacle;
  }
  return {};
}

inline std::string first_message(const Examined& result) {
  return message(*result.mesh, first_obstacle(result));
}

}  // namespace bezcert::test
