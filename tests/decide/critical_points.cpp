#include "critical_points.hpp"

#define CGAL_USE_GMP 1
#define CGAL_USE_MPFR 1
#define CGAL_USE_MPFI 1
#include <CGAL/Gmpz.h>

#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>
#include <CGAL/polynomial_utils.h>

#include <algorithm>

namespace bezcert::test {
namespace {

using Kernel2 = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using Kernel1 = Kernel2::Algebraic_kernel_d_1;
using Poly1 = Kernel1::Polynomial_1;
using Poly2 = Kernel2::Polynomial_2;
using Root1 = Kernel1::Algebraic_real_1;
using Root2 = Kernel2::Algebraic_real_2;
using Corner = std::array<int, 2>;

template <class Bound>
Rational to_rational(const Bound& value) {
  Rational result;
  mpq_set(result.backend().data(), CGAL::Gmpq(value).mpq());
  return result;
}

// f as a polynomial in v (outer) with coefficients in u.
Poly2 bivariate(const Table& f) {
  std::vector<Poly1> outer;
  for (const auto& row : f.rows) {
    std::vector<CGAL::Gmpz> coefficients;
    for (const Integer& c : row) coefficients.emplace_back(c.backend().data());
    outer.emplace_back(coefficients.begin(), coefficients.end());
  }
  return Poly2(outer.begin(), outer.end());
}

class Search {
 public:
  Search(const Table& table, Domain domain) : table_(table), domain_(domain) {}

  LowestSign run() {
    const Poly2 f = bivariate(table_);
    const std::vector<std::pair<Corner, Corner>> edges =
        domain_ == Domain::triangle
            ? std::vector<std::pair<Corner, Corner>>{{{0, 0}, {1, 0}}, {{0, 0}, {0, 1}}, {{0, 1}, {1, 0}}}
            : std::vector<std::pair<Corner, Corner>>{
                  {{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}}};
    for (const auto& [from, to] : edges) {
      look_at_edge(f, from, to);
      if (negative_) return {-1, {}};
    }
    look_inside(f);
    if (negative_) return {-1, {}};
    const int sign = zeros_.empty() ? 1 : 0;
    return {sign, std::move(zeros_)};
  }

 private:
  void look_at(const std::array<Rational, 2>& at) {
    const int s = table_.at(at[0], at[1]).sign();
    negative_ |= s < 0;
    if (s == 0) zeros_.push_back({at, at});
  }

  void look_at_edge(const Poly2& f, const Corner& from, const Corner& to) {
    const auto at = [&](const Rational& t) {
      return std::array{Rational(from[0] + t * (to[0] - from[0])), Rational(from[1] + t * (to[1] - from[1]))};
    };
    const auto coordinate = [&](int i) {  // as a polynomial in t
      const std::array<CGAL::Gmpz, 2> c = {CGAL::Gmpz(from[i]), CGAL::Gmpz(to[i] - from[i])};
      return Poly1(c.begin(), c.end());
    };
    const Poly1 u = coordinate(0), v = coordinate(1);
    Poly1 e(0);
    for (int k = CGAL::degree(f, 1); k >= 0; --k) {
      Poly1 row(0);
      const Poly1 c = CGAL::get_coefficient(f, k);
      for (int i = c.degree(); i >= 0; --i) row = row * u + Poly1(c[i]);
      e = e * v + row;
    }
    look_at(at(0));
    look_at(at(1));
    if (e.is_zero() || e.degree() == 0) {
      look_at(at(Rational(1, 2)));
      return;
    }
    std::vector<std::pair<Root1, Kernel1::Multiplicity_type>> all;
    kernel1_.solve_1_object()(CGAL::make_square_free(e), std::back_inserter(all));
    std::vector<Root1> roots;
    for (const auto& [root, multiplicity] : all) {
      if (root > Root1(0) && root < Root1(1)) roots.push_back(root);
    }
    // Between neighbouring roots, 0 and 1 the sign is constant: one rational point each.
    std::vector<Root1> marks = {Root1(0)};
    marks.insert(marks.end(), roots.begin(), roots.end());
    marks.push_back(Root1(1));
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
      look_at(at(to_rational(kernel1_.bound_between_1_object()(marks[i], marks[i + 1]))));
    }
    for (const Root1& root : roots) {
      const auto bounds = kernel1_.approximate_absolute_1_object()(root, 40);
      const auto a = at(to_rational(bounds.first)), b = at(to_rational(bounds.second));
      zeros_.push_back(
          {{std::min(a[0], b[0]), std::min(a[1], b[1])}, {std::max(a[0], b[0]), std::max(a[1], b[1])}});
    }
  }

  // Signs at the common zeros of a and b that lie in the open domain. Precondition: a and b are coprime.
  void look_at_common_zeros(const Poly2& f, const Poly2& a, const Poly2& b) {
    if (CGAL::total_degree(a) == 0 || CGAL::total_degree(b) == 0) return;
    std::vector<std::pair<Root2, Kernel2::Multiplicity_type>> points;
    kernel_.solve_2_object()(square_free(a), square_free(b), std::back_inserter(points));
    for (const auto& [point, multiplicity] : points) {
      if (!inside(point)) continue;
      const int s = sign_at(f, point);
      if (s == 0) zeros_.push_back(box_of(point));
      negative_ |= s < 0;
      if (negative_) return;
    }
  }

  // CGAL 5.5's sign_at_2 works on the curve p = 0: on the square-free part of p, with a positive leading
  // coefficient. So it is asked for square-free factors only, and multiplicities and the leading sign are put
  // back.
  int sign_at(const Poly2& p, const Root2& point) {
    std::vector<std::pair<Poly2, int>> factors;
    CGAL::square_free_factorize_up_to_constant_factor(p, std::back_inserter(factors));
    int result = static_cast<int>(CGAL::sign(CGAL::innermost_leading_coefficient(p)));
    for (const auto& [factor, multiplicity] : factors) {
      const int s = static_cast<int>(kernel_.sign_at_2_object()(factor, point));
      result *= multiplicity % 2 == 0 ? s * s : s;
    }
    return result;
  }

  Poly2 square_free(const Poly2& f) { return kernel_.make_square_free_2_object()(f); }

  void look_inside(const Poly2& f) {
    const Poly2 fu = CGAL::differentiate(f, 0);
    const Poly2 fv = CGAL::differentiate(f, 1);
    if (fu.is_zero() && fv.is_zero()) return;  // constant: the corners have shown it
    const Poly2 g = CGAL::gcd_up_to_constant_factor(fu, fv);
    if (!fu.is_zero() && !fv.is_zero()) {
      look_at_common_zeros(f, CGAL::integral_division_up_to_constant_factor(fu, g),
                           CGAL::integral_division_up_to_constant_factor(fv, g));
      if (negative_) return;
    }
    if (CGAL::total_degree(g) == 0) return;
    // Factors in u alone are lines u = constant, which reach the boundary.
    const Poly1 content = CGAL::univariate_content_up_to_constant_factor(g);
    const Poly2 primitive = CGAL::integral_division_up_to_constant_factor(g, Poly2(content));
    if (CGAL::degree(primitive, 1) == 0) return;
    const Poly2 h = square_free(primitive);
    look_at_common_zeros(f, h, CGAL::differentiate(h, 1));
  }

  // Whether a point lies in the open domain.
  bool inside(const Root2& point) {
    const Poly2 u = CGAL::shift(Poly2(Poly1(1)), 1, 0);
    const Poly2 v = CGAL::shift(Poly2(Poly1(1)), 1, 1);
    const Poly2 one{Poly1(1)};
    const auto positive = [&](const Poly2& p) { return sign_at(p, point) > 0; };
    if (!positive(u) || !positive(v)) return false;
    if (domain_ == Domain::triangle) return positive(one - u - v);
    return positive(one - u) && positive(one - v);
  }

  // Both coordinates as univariate algebraic numbers: approximate_absolute_y_2 of CGAL 5.5 does not end at
  // some vertical tangents.
  ZeroBox box_of(const Root2& point) {
    const auto x = kernel1_.approximate_absolute_1_object()(kernel_.compute_x_2_object()(point), 40);
    const auto y = kernel1_.approximate_absolute_1_object()(kernel_.compute_y_2_object()(point), 40);
    return {{to_rational(x.first), to_rational(y.first)}, {to_rational(x.second), to_rational(y.second)}};
  }

  const Table& table_;
  Domain domain_;
  Kernel2 kernel_;
  Kernel1 kernel1_;
  bool negative_ = false;
  std::vector<ZeroBox> zeros_;
};

}  // namespace

LowestSign lowest_sign(const Table& f, Domain domain) { return Search(f, domain).run(); }

}  // namespace bezcert::test
