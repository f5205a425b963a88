#include "bezcert/algebra/zero_set.hpp"

#include "bezcert/algebra/fiber.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

using Point = std::array<Rational, 2>;

// 1 - x.
RealRoot reflected(const RealRoot& x) {
  Univariate composed;
  const Univariate one_minus({Integer(1), Integer(-1)});
  for (std::size_t k = x.polynomial.coefficients.size(); k-- > 0;) {
    composed = composed * one_minus + Univariate({x.polynomial.coefficients[k]});
  }
  return {composed, 1 - x.upper, 1 - x.lower};
}

struct Edge {
  Point from, to;
};

std::vector<Edge> edges_of(Domain domain) {
  if (domain == Domain::triangle) return {{{0, 0}, {1, 0}}, {{0, 1}, {1, 0}}, {{0, 0}, {0, 1}}};
  return {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}}};
}

PlanarPoint point_on(const Edge& edge, RealRoot t) {
  const auto coordinate = [&](std::size_t i) {
    if (edge.from[i] == edge.to[i]) return rational_root(edge.from[i]);
    return edge.from[i].is_zero() ? t : reflected(t);
  };
  return {coordinate(0), coordinate(1)};
}

// Works in columns u = constant; the caller swaps the variables for the other direction.
class Search {
 public:
  Search(const Bivariate& h, Domain domain) : h_(h), domain_(domain) {}

  ZeroSet run(const Strips& strips) {
    look_at_edges();
    if (result_.dimension == 1) return std::move(result_);
    if (h_.degree_v() == 0) {
      look_at_lines();
      return std::move(result_);
    }
    const Univariate resultant = resultant_v(h_, derivative_v(h_));
    const std::vector<Edge> edges = edges_of(domain_);
    Univariate critical = square_free_part(h_.by_v.back());
    for (const Univariate& factor :
         {resultant, along(h_, edges[0].from, edges[0].to), along(h_, edges[1].from, edges[1].to)}) {
      if (factor.degree() > 0) critical = square_free_part(critical * square_free_part(factor));
    }
    for (const auto& [lower, upper] : strips) {
      look_between(critical, lower, upper);
      if (result_.changes_sign) return std::move(result_);
    }
    if (result_.dimension < 0) look_over_multiple_roots(resultant, strips);
    return std::move(result_);
  }

 private:
  void found(int dimension, PlanarPoint zero) {
    result_.zeros.push_back(std::move(zero));
    result_.dimension = std::max(result_.dimension, dimension);
  }

  Rational top(const Rational& u) const {
    return domain_ == Domain::triangle ? Rational(1 - u) : Rational(1);
  }

  void look_at_edges() {
    for (const Edge& edge : edges_of(domain_)) {
      const Univariate e = along(h_, edge.from, edge.to);
      if (e.is_zero()) {
        found(1, point_on(edge, rational_root(Rational(1, 2))));
        continue;
      }
      for (RealRoot& root : roots_in(square_free_part(e), 0, 1)) {
        RealRoot exact = with_minimal_polynomial(std::move(root));
        exact.refine_to(shown_width());
        found(0, point_on(edge, std::move(exact)));
      }
    }
  }

  // h depends on u alone: the zeros are lines u = root.
  void look_at_lines() {
    for (RealRoot& root : roots_in(h_.by_v[0], 0, 1)) {
      if (root.is_rational() && (root.lower == 0 || root.lower == 1)) continue;  // on an edge
      RealRoot exact = with_minimal_polynomial(std::move(root));
      while (!exact.is_rational() && (exact.lower == 0 || exact.upper == 1)) exact.refine();
      const Rational v = top(exact.upper) / 2;
      result_.changes_sign = true;
      // The neighbouring columns: a cell that the line cuts. Any row crosses it, so the other direction
      // serves.
      result_.column_is_u = false;
      result_.cell = {0, top(exact.upper)};
      exact.refine_to(shown_width());
      found(1, {exact, rational_root(v)});
      return;
    }
  }

  // Samples one column between neighbouring roots of `critical` that lie in the strip.
  void look_between(const Univariate& critical, const Rational& lower, const Rational& upper) {
    for (const Gap& gap : gaps_between_roots(critical, lower, upper)) {
      const Rational& u = gap.sample;
      std::vector<RealRoot> roots = roots_in(at_u(h_, u), 0, top(u));
      if (roots.empty()) continue;
      result_.changes_sign = true;
      result_.cell = {gap.lower, gap.upper};
      RealRoot v = with_minimal_polynomial(std::move(roots.front()));
      v.refine_to(shown_width());
      found(1, {rational_root(u), std::move(v)});
      return;
    }
  }

  // No curve of zeros inside: h has one sign there up to isolated points, at which its gradient vanishes.
  void look_over_multiple_roots(const Univariate& resultant, const Strips& strips) {
    if (resultant.degree() < 2) return;
    const Univariate multiple = gcd(resultant, derivative(resultant));
    if (multiple.degree() < 1) return;
    const Univariate candidates = square_free_part(multiple);
    const Univariate bottom, above = domain_ == Domain::triangle ? Univariate({Integer(1), Integer(-1)})
                                                                 : Univariate({Integer(1)});
    for (const auto& [lower, upper] : strips) {
      for (RealRoot& root : roots_in(candidates, lower, upper)) {
        if (root.is_rational() && (root.lower == 0 || root.lower == 1)) continue;
        Fiber fiber(with_minimal_polynomial(std::move(root)), {h_, derivative_v(h_), derivative_u(h_)});
        if (fiber.is_whole_line()) throw std::logic_error("zero_set: the polynomial is not irreducible");
        if (fiber.count(bottom, above, Fiber::Ends::excluded) == 0) continue;
        RealRoot v = fiber.smallest(bottom, above, Fiber::Ends::excluded, shown_width());
        RealRoot u = fiber.alpha();
        u.refine_to(shown_width());
        found(0, {std::move(u), std::move(v)});
      }
    }
  }

  const Bivariate& h_;
  Domain domain_;
  ZeroSet result_;
};

}  // namespace

Strips merged(Strips intervals) {
  std::sort(intervals.begin(), intervals.end());
  Strips result;
  for (auto& interval : intervals) {
    if (!result.empty() && interval.first <= result.back().second) {
      result.back().second = std::max(result.back().second, interval.second);
    } else {
      result.push_back(std::move(interval));
    }
  }
  return result;
}

int zero_set_degree(const Bivariate& h) {
  const int u = h.degree_u(), v = h.degree_v();
  return u < v ? v * (2 * u - 1) : u * (2 * v - 1);
}

ZeroSet zero_set(const Bivariate& h, Domain domain, const Strips& strips_u, const Strips& strips_v) {
  // Eliminate the variable of the smaller degree: the resultant is smaller, the columns are shorter work.
  if (h.degree_v() <= h.degree_u()) return Search(h, domain).run(strips_u);
  const Bivariate other = swapped(h);
  ZeroSet result = Search(other, domain).run(strips_v);
  result.column_is_u = !result.column_is_u;
  for (PlanarPoint& zero : result.zeros) std::swap(zero.u, zero.v);
  return result;
}

}  // namespace bezcert
