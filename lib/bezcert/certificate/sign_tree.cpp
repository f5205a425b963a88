#include "bezcert/certificate/sign_tree.hpp"

#include "bezcert/algebra/real_root.hpp"
#include "bezcert/bernstein/halve.hpp"
#include "bezcert/bernstein/scale_table.hpp"
#include "bezcert/element/bisect.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <algorithm>

namespace bezcert {
namespace {

bool none_negative(const std::vector<Integer>& values) {
  return std::all_of(values.begin(), values.end(), [](const Integer& c) { return c.sign() >= 0; });
}

std::size_t words_in(const std::vector<Integer>& values) {
  std::size_t words = values.size();
  for (const Integer& value : values) words += mpz_size(value.backend().data());
  return words;
}

}  // namespace

Polynomial<Integer> to_bernstein(const Bivariate& f, Domain domain) {
  int total = 0;
  for (std::size_t k = 0; k < f.by_v.size(); ++k) {
    if (!f.by_v[k].is_zero()) total = std::max(total, f.by_v[k].degree() + static_cast<int>(k));
  }
  const bool triangle = domain == Domain::triangle;
  const int p = triangle ? total : std::max(f.degree_u(), 0);
  const int q = triangle ? 0 : f.degree_v();
  Polynomial<Integer> result(Shape(domain, p, q));
  // u^i v^k times a power of 1 = xi_0 + u + v, or of 1 = (1-u) + u and 1 = (1-v) + v, expanded: scaled
  // coefficients.
  for (int k = 0; k <= f.degree_v(); ++k) {
    const Univariate& row = f.by_v[static_cast<std::size_t>(k)];
    for (int i = 0; i <= row.degree(); ++i) {
      const Integer& a = row.coefficients[static_cast<std::size_t>(i)];
      if (a.is_zero()) continue;
      const int rest_v = (triangle ? p - i : q) - k;
      for (int r = 0; r <= rest_v; ++r) {
        const Integer in_v = a * binomial(rest_v, r);
        const int rest_u = triangle ? rest_v - r : p - i;
        for (int c = 0; c <= rest_u; ++c) result.at(k + r, i + c) += in_v * binomial(rest_u, c);
      }
    }
  }
  from_scaled(result);
  return result;
}

bool coefficients_show(const Polynomial<Integer>& f, Strictness wanted) {
  if (wanted == Strictness::strict) {
    for (const std::size_t i : corner_indices(f.shape)) {
      if (f.coefficients[i].sign() <= 0) return false;
    }
  }
  return none_negative(f.coefficients);
}

std::optional<std::string> sign_tree(const Polynomial<Integer>& f, Strictness wanted, TreeLimits limits) {
  struct Task {
    Polynomial<Integer> f;
    int depth;
  };
  const auto corners = corner_indices(f.shape);
  const auto additions = static_cast<std::size_t>(f.shape.degree(0) + f.shape.degree(1)) / 2 + 1;
  std::vector<Task> stack;
  stack.push_back({f, 0});
  std::string bits;
  std::size_t pieces = 1, work = 0;
  while (!stack.empty()) {
    Task task = std::move(stack.back());
    stack.pop_back();
    if (coefficients_show(task.f, wanted)) {
      bits += '0';
      continue;
    }
    for (const std::size_t i : corners) {
      const int s = task.f.coefficients[i].sign();
      if (s < 0 || (s == 0 && wanted == Strictness::strict)) return std::nullopt;
    }
    work += additions * words_in(task.f.coefficients);
    pieces += 2;
    if (task.depth >= limits.depth || pieces > limits.pieces || work > limits.work) return std::nullopt;
    bits += '1';
    auto [first, second] = bisect(task.f, factor_to_cut(task.f.shape.domain, task.depth));
    shorten(first.coefficients);
    shorten(second.coefficients);
    stack.push_back({std::move(second), task.depth + 1});
    stack.push_back({std::move(first), task.depth + 1});
  }
  return bits;
}

std::optional<std::string> sign_tree(const Forms& forms, int direction, Strictness wanted,
                                     TreeLimits limits) {
  JacobianTree tree(forms);
  std::vector<JacobianTree::Piece> stack = {JacobianTree::root};
  std::string bits;
  while (!stack.empty()) {
    const JacobianTree::Piece piece = stack.back();
    stack.pop_back();
    const PieceSigns signs = tree.signs(piece);
    const bool strict = direction > 0 ? tree.proves_positive(signs) : tree.proves_negative(signs);
    const bool weak = direction > 0 ? signs.none_negative : signs.none_positive;
    if (wanted == Strictness::strict ? strict : weak) {
      bits += '0';
      continue;
    }
    for (std::size_t k = 0; k < tree.corner_count(); ++k) {
      const int s = direction * signs.corner[k];
      if (s < 0 || (s == 0 && wanted == Strictness::strict)) return std::nullopt;
    }
    if (tree.depth(piece) >= limits.depth || !tree.may_split(limits.pieces)) return std::nullopt;
    bits += '1';
    const auto [first, second] = tree.split(piece);
    stack.push_back(second);
    stack.push_back(first);
  }
  return bits;
}

bool positive_by_rows(const Polynomial<Integer>& f, std::size_t pieces) {
  std::vector<Polynomial<Integer>> stack = {f};
  std::size_t seen = 1;
  while (!stack.empty()) {
    const Polynomial<Integer> piece = std::move(stack.back());
    stack.pop_back();
    for (const std::size_t corner : corner_indices(piece.shape)) {
      if (piece.coefficients[corner].sign() <= 0) return false;
    }
    if (coefficients_show(piece, Strictness::strict)) continue;
    seen += 2;
    if (seen > pieces) return false;
    auto [lower, upper] = bisect(piece, 1);
    shorten(lower.coefficients);
    shorten(upper.coefficients);
    stack.push_back(std::move(upper));
    stack.push_back(std::move(lower));
  }
  return true;
}

bool positive_on_segment(const Univariate& f, std::size_t pieces) {
  std::vector<std::vector<Integer>> stack = {bernstein_over(f, 0, 1)};
  std::size_t seen = 1;
  while (!stack.empty()) {
    const std::vector<Integer> values = std::move(stack.back());
    stack.pop_back();
    if (values.front().sign() <= 0 || values.back().sign() <= 0) return false;
    if (none_negative(values)) continue;
    seen += 2;
    if (seen > pieces) return false;
    auto [left, right] = halve(values);
    shorten(left);
    shorten(right);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return true;
}

}  // namespace bezcert
