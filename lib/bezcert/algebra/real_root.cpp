#include "bezcert/algebra/real_root.hpp"

#include "bezcert/bernstein/halve.hpp"
#include "bezcert/bernstein/multinomial.hpp"

#include <algorithm>

namespace bezcert {

// f(lower + (upper-lower) t) = sum a_k t^k, and t = s / (1 + s) turns it into the
// numerator sum a_k s^k (1+s)^(n-k), whose coefficients are the scaled Bernstein coefficients.
std::vector<Integer> bernstein_over(const Univariate& f, const Rational& lower, const Rational& upper) {
  const std::size_t count = f.coefficients.size();
  // One denominator q: lower = p/q, upper - lower = w/q; q^n f(x) = sum c_k (p + w t)^k q^(n-k).
  const Rational width = upper - lower;
  const Integer q = lcm(Integer(denominator(lower)), Integer(denominator(width)));
  const Integer p = Integer(numerator(lower)) * (q / denominator(lower));
  const Integer w = Integer(numerator(width)) * (q / denominator(width));
  std::vector<Integer> a(f.coefficients);
  Integer factor = 1;
  for (std::size_t k = count; k-- > 0;) {
    a[k] *= factor;
    factor *= q;
  }
  // Taylor shift by p (a(x) -> a(x + p)), then x = w t.
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t k = count - 1; k-- > i;) a[k] += p * a[k + 1];
  }
  factor = 1;
  for (std::size_t k = 0; k < count; ++k) {
    a[k] *= factor;
    factor *= w;
  }
  // Power to Bernstein without division: b_j = sum_k a_k C(n-k, j-k), the scaled coefficients.
  const int n = static_cast<int>(count) - 1;
  std::vector<Integer> result(count, 0);
  for (int k = 0; k <= n; ++k) {
    if (a[static_cast<std::size_t>(k)].is_zero()) continue;
    Integer c = 1;  // C(n-k, j-k)
    for (int j = k; j <= n; ++j) {
      result[static_cast<std::size_t>(j)] += a[static_cast<std::size_t>(k)] * c;
      c = c * (n - j) / (j - k + 1);
    }
  }
  // Without the binomials, times n!-free common multiple: halving needs plain coefficients.
  Integer multiple = 1;
  for (int j = 1; j < n; ++j) multiple = lcm(multiple, binomial(n, j));
  for (int j = 0; j <= n; ++j) result[static_cast<std::size_t>(j)] *= multiple / binomial(n, j);
  return result;
}

int sign_changes(const std::vector<Integer>& values) {
  int changes = 0, last = 0;
  for (const Integer& value : values) {
    const int s = value.sign();
    if (s == 0) continue;
    if (last != 0 && s != last) ++changes;
    last = s;
  }
  return changes;
}

namespace {

// Roots in the open interval, in ascending order. Intervals without sign changes are dropped at once, so that
// few are kept however deep the search goes: coefficients grow by the degree in bits with every halving.
void isolate(const Univariate& f, std::vector<Integer> bernstein, const Rational& lower,
             const Rational& upper, std::vector<RealRoot>& roots) {
  struct Task {
    std::vector<Integer> bernstein;  // empty: `lower` is a root
    Rational lower, upper;
  };
  std::vector<Task> stack;
  stack.push_back({std::move(bernstein), lower, upper});
  while (!stack.empty()) {
    const Task task = std::move(stack.back());
    stack.pop_back();
    if (task.bernstein.empty()) {
      roots.push_back({f, task.lower, task.lower});
      continue;
    }
    const int changes = sign_changes(task.bernstein);
    if (changes == 0) continue;
    if (changes == 1 && !task.bernstein.front().is_zero() && !task.bernstein.back().is_zero()) {
      roots.push_back({f, task.lower, task.upper});
      continue;
    }
    const Rational middle = (task.lower + task.upper) / 2;
    auto [left, right] = halve(task.bernstein);
    const bool root_at_middle = right.front().is_zero();
    if (sign_changes(right) > 0) {
      shorten(right);
      stack.push_back({std::move(right), middle, task.upper});
    }
    if (root_at_middle) stack.push_back({{}, middle, middle});
    if (sign_changes(left) > 0) {
      shorten(left);
      stack.push_back({std::move(left), task.lower, middle});
    }
  }
}

}  // namespace

void RealRoot::refine() {
  if (is_rational()) return;
  const Rational middle = (lower + upper) / 2;
  const int at_middle = sign_at(polynomial, middle);
  if (at_middle == 0) {
    lower = upper = middle;
  } else if (at_middle == sign_at(polynomial, lower)) {
    lower = middle;
  } else {
    upper = middle;
  }
}

void RealRoot::refine_to(const Rational& width) {
  while (upper - lower > width) refine();
}

std::vector<RealRoot> roots_in(const Univariate& f, const Rational& lower, const Rational& upper) {
  std::vector<RealRoot> roots;
  if (f.degree() <= 0) return roots;
  const std::vector<Integer> bernstein = bernstein_over(f, lower, upper);
  const bool at_upper = bernstein.back().is_zero();
  if (bernstein.front().is_zero()) roots.push_back({f, lower, lower});
  isolate(f, bernstein, lower, upper, roots);
  if (at_upper) roots.push_back({f, upper, upper});
  return roots;
}

std::vector<Gap> gaps_between_roots(const Univariate& f, const Rational& lower, const Rational& upper) {
  std::vector<RealRoot> marks = roots_in(f, lower, upper);
  marks.insert(marks.begin(), RealRoot{Univariate(), lower, lower});
  marks.push_back({Univariate(), upper, upper});
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
    RealRoot& a = marks[i];
    RealRoot& b = marks[i + 1];
    if (a.is_rational() && b.is_rational() && a.lower == b.lower) continue;
    while (!(a.upper < b.lower)) {
      a.refine();
      b.refine();
    }
    const Rational quarter = (b.lower - a.upper) / 4;
    gaps.push_back({a.upper, b.lower, simplest_between(a.upper + quarter, b.lower - quarter)});
  }
  return gaps;
}

Rational simplest_between(const Rational& lower, const Rational& upper) {
  if (lower.sign() <= 0 && upper.sign() >= 0) return 0;
  if (upper.sign() < 0) return -simplest_between(-upper, -lower);
  const Integer whole = floor(lower);
  if (Rational(whole) == lower) return lower;
  if (Rational(Integer(whole + 1)) <= upper) return Rational(Integer(whole + 1));
  return Rational(whole) + 1 / simplest_between(1 / (upper - Rational(whole)), 1 / (lower - Rational(whole)));
}

Rational root_of_linear(const Univariate& f) { return Rational(-f.coefficients[0], f.coefficients[1]); }

RealRoot rational_root(const Rational& x) {
  return {Univariate({Integer(-numerator(x)), Integer(denominator(x))}), x, x};
}

RealRoot with_minimal_polynomial(RealRoot root) {
  if (root.is_rational()) return rational_root(root.lower);
  for (auto& [factor, multiplicity] : irreducible_factors(root.polynomial)) {
    // A factor vanishes at the root exactly if its sign changes over the interval.
    if (sign_at(factor, root.lower) == sign_at(factor, root.upper)) continue;
    root.polynomial = factor;
    if (factor.degree() == 1) root.lower = root.upper = root_of_linear(factor);
    return root;
  }
  throw std::logic_error("with_minimal_polynomial: no factor has the root");
}

}  // namespace bezcert
