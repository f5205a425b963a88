// The zeros of polynomials on the triangle and the square, where they are known; and under the symmetries of
// the domain, which exchange the variable that is eliminated, the edges and the columns.
#include "bezcert/algebra/zero_set.hpp"
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

const Strips whole = {{0, 1}};

struct Symmetry {
  Bivariate u, v;
};

std::vector<Symmetry> symmetries(Domain domain) {
  const Bivariate w = line2(1, -1, -1), u1 = line2(1, -1, 0), v1 = line2(1, 0, -1);
  if (domain == Domain::triangle) return {{U, V}, {V, U}, {U, w}, {w, U}, {V, w}, {w, V}};
  return {{U, V}, {V, U}, {u1, V}, {V, u1}, {U, v1}, {v1, U}, {u1, v1}, {v1, u1}};
}

Bivariate substituted(const Bivariate& h, const Symmetry& s) {
  Bivariate result;
  for (std::size_t k = h.by_v.size(); k-- > 0;) {
    Bivariate row;
    for (std::size_t i = h.by_v[k].coefficients.size(); i-- > 0;) {
      row = row * s.u + poly2({Univariate({h.by_v[k].coefficients[i]})});
    }
    result = result * s.v + row;
  }
  return result;
}

Rational bound(Domain domain, const Rational& other) {
  return domain == Domain::triangle ? Rational(1 - other) : Rational(1);
}

bool root_holds(const RealRoot& root) {
  if (root.polynomial.is_zero()) return true;
  const RationalPolynomial f(root.polynomial.coefficients);
  if (root.is_rational()) return f(root.lower).is_zero();
  return sign(f(root.lower)) * sign(f(root.upper)) < 0;
}

using Known = std::vector<std::array<double, 2>>;

// Whether h vanishes there, in the closed domain: exactly if a coordinate is rational, else near one of the
// known zeros.
void check_zero(const Bivariate& h, Domain domain, const PlanarPoint& at, const Known& known) {
  CAPTURE(at.u.lower, at.u.upper, at.v.lower, at.v.upper);
  REQUIRE(root_holds(at.u));
  REQUIRE(root_holds(at.v));
  REQUIRE(at.u.upper - at.u.lower <= power_of_two(-40));
  REQUIRE(at.v.upper - at.v.lower <= power_of_two(-40));
  if (at.is_rational()) {
    REQUIRE(value_at(h, at.u.lower, at.v.lower).is_zero());
    REQUIRE(at.u.lower >= 0);
    REQUIRE(at.v.lower >= 0);
    REQUIRE(at.v.lower <= bound(domain, at.u.lower));
    REQUIRE(at.u.lower <= 1);
  } else if (at.u.is_rational() || at.v.is_rational()) {
    const bool fixed_u = at.u.is_rational();
    const Bivariate turned = fixed_u ? h : swapped(h);
    const Rational x = fixed_u ? at.u.lower : at.v.lower;
    const RealRoot& free = fixed_u ? at.v : at.u;
    std::vector<Rational> line;
    for (const Univariate& c : turned.by_v) line.push_back(RationalPolynomial(c.coefficients)(x));
    const RationalPolynomial f(line);
    const Rational low = std::max(free.lower, Rational(0)), high = std::min(free.upper, bound(domain, x));
    REQUIRE(low <= high);
    if (!f.is_zero()) REQUIRE(count_roots(f, low, high) > 0);
  }
  if (known.empty()) return;
  const double u = at.u.lower.convert_to<double>(), v = at.v.lower.convert_to<double>();
  bool near = false;
  for (const auto& [a, b] : known) near |= std::hypot(u - a, v - b) < 1e-9;
  REQUIRE(near);
}

struct Expected {
  int dimension = -1;
  bool changes_sign = false;
  /// All zeros, if there are finitely many.
  Known zeros;
};

void check_cell(const Bivariate& h, Domain domain, const ZeroSet& zeros) {
  const Bivariate turned = zeros.column_is_u ? h : swapped(h);
  REQUIRE(zeros.cell.first < zeros.cell.second);
  REQUIRE(zeros.cell.first >= 0);
  REQUIRE(zeros.cell.second <= 1);
  int with_change = 0;
  for (int k = 1; k < 8; ++k) {
    const Rational x = zeros.cell.first + (zeros.cell.second - zeros.cell.first) * Rational(k, 8);
    std::vector<Rational> line;
    for (const Univariate& c : turned.by_v) line.push_back(RationalPolynomial(c.coefficients)(x));
    const RationalPolynomial f(line);
    const Rational top = bound(domain, x);
    // A simple root inside the column is a change of sign.
    const int ends = (f(0).is_zero() ? 1 : 0) + (f(top).is_zero() ? 1 : 0);
    if (without_multiple_roots(f).degree() == f.degree() && count_roots(f, 0, top) > ends) ++with_change;
  }
  REQUIRE(with_change >= 6);
}

// In all symmetric positions the same answer.
void check(const std::string& what, const Bivariate& h, Domain domain, const Expected& expected) {
  int position = 0;
  for (const Symmetry& symmetry : symmetries(domain)) {
    const Bivariate turned = substituted(h, symmetry);
    INFO(what << " on the " << (domain == Domain::triangle ? "triangle" : "square") << ", position "
              << position);
    // Zeros (a, b) of h(A(u, v), B(u, v)): where (A, B)(u, v) = (a, b). Found by trying all symmetries.
    Known known;
    for (const auto& [a, b] : expected.zeros) {
      for (const Symmetry& back : symmetries(domain)) {
        const auto image = [&](const Bivariate& f, double x, double y) {
          return f.by_v.empty() ? 0.0 : value_at(f, exact(x), exact(y)).convert_to<double>();
        };
        const double u = image(back.u, a, b), v = image(back.v, a, b);
        if (std::hypot(image(symmetry.u, u, v) - a, image(symmetry.v, u, v) - b) < 1e-12)
          known.push_back({u, v});
      }
    }
    const ZeroSet zeros = zero_set(turned, domain, whole, whole);
    REQUIRE(zeros.dimension == expected.dimension);
    REQUIRE(zeros.changes_sign == expected.changes_sign);
    REQUIRE(zeros.zeros.empty() == (expected.dimension < 0));
    for (const PlanarPoint& zero : zeros.zeros) check_zero(turned, domain, zero, known);
    if (zeros.changes_sign) check_cell(turned, domain, zeros);
    ++position;
  }
}

// c ((u - a/d)^2 + (v - b/d)^2) - r, over d^2: (d u - a)^2 + (d v - b)^2 - r.
Bivariate circle(long d, long a, long b, long r) {
  return square(line2(-a, d, 0)) + square(line2(-b, 0, d)) - constant2(r);
}

constexpr Domain triangle = Domain::triangle, quadrilateral = Domain::square;

}  // namespace

TEST_CASE("circles inside, around, across, tangent to edges and beside corners") {
  // Centre (1/4, 1/4) = (8/32, 8/32), radii in 1/32.
  check("circle inside", circle(32, 8, 8, 4), triangle, {1, true, {}});
  check("circle inside", circle(32, 8, 8, 4), quadrilateral, {1, true, {}});
  check("circle tangent to two edges from inside", circle(4, 1, 1, 1), triangle, {1, true, {}});
  check("circle tangent to two edges from inside", circle(4, 1, 1, 1), quadrilateral, {1, true, {}});
  check("circle across the edges", circle(4, 1, 1, 2), triangle, {1, true, {}});
  check("circle around the domain", circle(4, 1, 1, 100), triangle, {-1, false, {}});
  check("circle around the domain", circle(4, 1, 1, 100), quadrilateral, {-1, false, {}});
  // Through all corners of the square: centre (1/2, 1/2), radius^2 1/2.
  check("circle around, through the corners", circle(2, 1, 1, 2), quadrilateral,
        {0, false, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}});
  // Centre (-1/2, 1/3), radius 1/2: touches u = 0 from outside at (0, 1/3).
  check("circle tangent from outside", circle(6, -3, 2, 9), triangle, {0, false, {{0, 1.0 / 3}}});
  check("circle tangent from outside", circle(6, -3, 2, 9), quadrilateral, {0, false, {{0, 1.0 / 3}}});
  // Centre (1, 1), radius^2 1/2: touches u + v = 1 at (1/2, 1/2).
  check("circle tangent to the hypotenuse", circle(2, 2, 2, 2), triangle, {0, false, {{0.5, 0.5}}});
  check("circle beside the corner (0, 0)", circle(1, -1, -1, 2), triangle, {0, false, {{0, 0}}});
  check("circle beside the corner (0, 0)", circle(1, -1, -1, 2), quadrilateral, {0, false, {{0, 0}}});
  check("circle beside the corner (1, 0)", circle(1, 2, -1, 2), triangle, {0, false, {{1, 0}}});
  check("circle outside", circle(10, -10, -10, 199), triangle, {-1, false, {}});
  check("circle just into the corner", circle(10, -10, -10, 201), triangle, {1, true, {}});
  // A tiny circle, radius 2^-40, far from dyadic points: centre (1/3, 1/5).
  const Integer size = Integer(1) << 80;
  const Bivariate tiny = poly2({Univariate({size})}) * (circle(15, 5, 3, 0)) - constant2(225);
  check("tiny circle", tiny, triangle, {1, true, {}});
  check("tiny circle", tiny, quadrilateral, {1, true, {}});
  const Bivariate none = poly2({Univariate({size})}) * (circle(15, 5, 3, 0)) - constant2(-225);
  check("no circle", none, triangle, {-1, false, {}});
}

TEST_CASE("lines, parabolas, edges and polynomials in one variable") {
  check("line through the inside", line2(-1, 3, 1), triangle, {1, true, {}});
  check("line through the inside", line2(-1, 3, 1), quadrilateral, {1, true, {}});
  check("line beside a corner", line2(0, 1, 2), triangle, {0, false, {{0, 0}}});
  check("line beside a corner", line2(0, 1, 2), quadrilateral, {0, false, {{0, 0}}});
  check("line outside", line2(1, 1, 2), triangle, {-1, false, {}});
  check("edge u", U, triangle, {1, false, {}});
  check("edge u", U, quadrilateral, {1, false, {}});
  check("edge 1 - u - v", line2(1, -1, -1), triangle, {1, false, {}});
  check("diagonal", line2(1, -1, -1), quadrilateral, {1, true, {}});
  check("u = 1 at one corner", line2(1, -1, 0), triangle, {0, false, {{1, 0}}});
  check("u = 1", line2(1, -1, 0), quadrilateral, {1, false, {}});
  check("u = 1/3", line2(-1, 3, 0), triangle, {1, true, {}});
  check("u = 1/sqrt 2", poly2({poly({-1, 0, 2})}), triangle, {1, true, {}});
  check("u = 1/sqrt 2", poly2({poly({-1, 0, 2})}), quadrilateral, {1, true, {}});
  check("u^2 = 2", poly2({poly({-2, 0, 1})}), quadrilateral, {-1, false, {}});
  check("u^2 + 1", poly2({poly({1, 0, 1})}), triangle, {-1, false, {}});
  check("v^3 = 1/4", poly2({poly({-1}), poly({}), poly({}), poly({4})}), triangle, {1, true, {}});
  check("parabola v = u^2 + 1/5", constant2(5) * (V - square(U)) - constant2(1), triangle, {1, true, {}});
  check("parabola v = u^2 + 1/5", constant2(5) * (V - square(U)) - constant2(1), quadrilateral,
        {1, true, {}});
  check("parabola tangent to an edge", V - square(line2(-1, 2, 0)), quadrilateral, {1, true, {}});
  check("parabola tangent from outside", V + square(line2(-1, 2, 0)), quadrilateral, {0, false, {{0.5, 0}}});
  check("parabola tangent from outside at 1/3", V + square(line2(-1, 3, 0)), triangle,
        {0, false, {{1.0 / 3, 0}}});
  // Tangent at an irrational point: v + (2 u^2 - 1)^2.
  check("quartic tangent from outside", V + square(poly2({poly({-1, 0, 2})})), triangle,
        {0, false, {{std::sqrt(0.5), 0}}});
  check("hyperbola 8 u v = 1", constant2(8) * U * V - constant2(1), triangle, {1, true, {}});
  check("hyperbola tangent to the hypotenuse", constant2(4) * U * V - constant2(1), triangle,
        {0, false, {{0.5, 0.5}}});
  check("hyperbola outside", constant2(3) * U * V - constant2(1), triangle, {-1, false, {}});
}

TEST_CASE("isolated zeros: sums of squares, acnodes, Motzkin's polynomial") {
  check("rational point", square(line2(-1, 3, 0)) + square(line2(-1, 0, 5)), triangle,
        {0, false, {{1.0 / 3, 0.2}}});
  check("rational point", square(line2(-1, 3, 0)) + square(line2(-1, 0, 5)), quadrilateral,
        {0, false, {{1.0 / 3, 0.2}}});
  check("rational point outside the triangle", square(line2(-2, 3, 0)) + square(line2(-2, 0, 5)), triangle,
        {-1, false, {}});
  check("rational point on the hypotenuse", square(line2(-2, 3, 0)) + square(line2(-1, 0, 3)), triangle,
        {0, false, {{2.0 / 3, 1.0 / 3}}});
  check("corner", square(U) + square(V), triangle, {0, false, {{0, 0}}});
  check("corner", square(U) + square(V), quadrilateral, {0, false, {{0, 0}}});
  const double r = std::sqrt(0.125);
  const Bivariate root8 = poly2({poly({-1, 0, 8})});
  check("irrational point", square(root8) + square(U - V), triangle, {0, false, {{r, r}}});
  check("irrational u, rational v", square(root8) + square(line2(-1, 0, 3)), triangle,
        {0, false, {{r, 1.0 / 3}}});
  check("two fields", square(root8) + square(constant2(64) * square(V) * V - constant2(3)), triangle,
        {0, false, {{r, std::cbrt(3) / 4}}});
  check("two fields", square(root8) + square(constant2(64) * square(V) * V - constant2(3)), quadrilateral,
        {0, false, {{r, std::cbrt(3) / 4}}});
  // Two conjugate zeros.
  check("conjugate points", square(poly2({poly({1, -8, 8})})) + square(line2(0, -1, 8)), triangle,
        {0, false, {{0.5 - r, (0.5 - r) / 8}, {0.5 + r, (0.5 + r) / 8}}});
  // A field of degree 4: u^2 + v^2 = 1/4, 16 u v = 1.
  const double sum = std::sqrt(0.375), gap = std::sqrt(0.125);
  check("quartic field",
        square(constant2(4) * (square(U) + square(V)) - constant2(1)) +
            square(constant2(16) * U * V - constant2(1)),
        triangle, {0, false, {{(sum + gap) / 2, (sum - gap) / 2}, {(sum - gap) / 2, (sum + gap) / 2}}});
  // Several zeros over one u: at v = 1/5 and v = 1/2.
  check("two over one column", square(root8) + square(line2(-1, 0, 5) * line2(-1, 0, 2)), triangle,
        {0, false, {{r, 0.2}, {r, 0.5}}});
  // Over u = 1/3 the fibre has, besides the isolated zero, a simple root outside the domain: a cubic with an
  // acnode at (1/3, 1/4) and its branch at v < 0: (3u-1)^2 + (4v-1)^2 (1 + v) has the branch v <= -1.
  const Bivariate acnode = square(line2(-1, 3, 0)) + square(line2(-1, 0, 4)) * line2(1, 0, 1);
  check("acnode, its branch outside", acnode, triangle, {0, false, {{1.0 / 3, 0.25}}});
  check("acnode, its branch outside", acnode, quadrilateral, {0, false, {{1.0 / 3, 0.25}}});
  // The branch inside: at v >= 3/4, the acnode is not needed for the answer.
  const Bivariate inside = square(line2(-1, 3, 0)) - square(line2(-1, 0, 4)) * line2(-3, 0, 4);
  check("acnode and its branch", inside, quadrilateral, {1, true, {}});
  // The branch touches the top edge of the square, and nowhere else: v >= 1.
  const Bivariate touching = square(line2(-1, 3, 0)) + square(line2(-1, 0, 4)) * line2(1, 0, -1);
  check("acnode, its branch touches the edge", touching, quadrilateral,
        {0, false, {{1.0 / 3, 0.25}, {1.0 / 3, 1}}});
  check("acnode, its branch outside the triangle", touching, triangle, {0, false, {{1.0 / 3, 0.25}}});
  // Motzkin at x = 3 u, y = 3 v: x^4 y^2 + x^2 y^4 - 3 x^2 y^2 + 1.
  const Bivariate x2 = constant2(9) * square(U), y2 = constant2(9) * square(V);
  const Bivariate motzkin = square(x2) * y2 + x2 * square(y2) - constant2(3) * x2 * y2 + constant2(1);
  check("Motzkin", motzkin, triangle, {0, false, {{1.0 / 3, 1.0 / 3}}});
  check("Motzkin", motzkin, quadrilateral, {0, false, {{1.0 / 3, 1.0 / 3}}});
  const Bivariate x4 = square(line2(-2, 4, 0)), y4 = square(line2(-2, 0, 4));
  const Bivariate four = square(x4) * y4 + x4 * square(y4) - constant2(3) * x4 * y4 + constant2(1);
  check("Motzkin with four zeros", four, quadrilateral,
        {0, false, {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}});
  check("Motzkin above 0", motzkin * constant2(1000000) + constant2(1), triangle, {-1, false, {}});
  check("Motzkin below 0", motzkin * constant2(1000000) - constant2(1), triangle, {1, true, {}});
  // Order 4: a tacnode-like isolated point.
  check("order four", square(square(line2(-1, 3, 0))) + square(line2(-1, 0, 3)), triangle,
        {0, false, {{1.0 / 3, 1.0 / 3}}});
}

TEST_CASE("only the columns of the strips are searched, and narrow strips are enough") {
  const Bivariate h = square(line2(-1, 3, 0)) + square(line2(-1, 0, 5));
  const Rational a = power_of_two(-40), third(1, 3), fifth(1, 5);
  const Strips near_u = {{0, Rational(1, 8)}, {third - a, third + a}}, near_v = {{fifth - a, fifth + a}};
  const Strips none_u = {{0, third - a}, {third + a, 1}}, none_v = {{0, fifth - a}, {fifth + a, 1}};
  for (const Domain domain : {triangle, quadrilateral}) {
    CHECK(zero_set(h, domain, near_u, near_v).dimension == 0);
    CHECK(zero_set(h, domain, none_u, none_v).dimension == -1);
    CHECK(zero_set(swapped(h), domain, near_v, near_u).dimension == 0);
  }
  // The zero at the end of a strip.
  CHECK(zero_set(h, triangle, {{third, 1}}, {{fifth, 1}}).dimension == 0);
  CHECK(zero_set(h, triangle, {{0, third}}, {{0, fifth}}).dimension == 0);
  // A circle of radius 1/16 around (1/4, 1/4): only a sliver of it.
  const Bivariate round = circle(32, 8, 8, 4);
  const Rational left(3, 16);
  const ZeroSet sliver = zero_set(round, triangle, {{left - a, left + a}}, {{left - a, left + a}});
  CHECK(sliver.dimension == 1);
  CHECK(sliver.changes_sign);
  check_cell(round, triangle, sliver);
  CHECK(sliver.cell.first >= left - a);
  CHECK(sliver.cell.second <= left + a);
  CHECK(zero_set(round, triangle, {{0, left - a}}, {{0, left - a}}).dimension == -1);
}

TEST_CASE("merged joins intervals that touch") {
  const Strips found = merged({{Rational(1, 2), Rational(3, 4)},
                               {0, Rational(1, 4)},
                               {Rational(1, 4), Rational(1, 3)},
                               {Rational(5, 8), Rational(6, 8)},
                               {Rational(7, 8), 1}});
  CHECK(found == Strips{{0, Rational(1, 3)}, {Rational(1, 2), Rational(3, 4)}, {Rational(7, 8), 1}});
  CHECK(merged({}).empty());
}

TEST_CASE("random polynomials: the answer does not depend on the position and fits a grid of signs") {
  const std::uint64_t seed = seed_or(131);
  Random random(seed);
  int counts[3] = {0, 0, 0}, changes = 0, total = 0;
  for (int i = 0; i < 400; ++i) {
    const Domain domain = random.chance(50) ? triangle : quadrilateral;
    Bivariate f = random_bivariate(random, static_cast<int>(random.integer(0, 3)),
                                   static_cast<int>(random.integer(0, 3)), 4);
    if (random.chance(30)) f = square(f) + square(random_bivariate(random, 1, 1, 4));
    if (f.is_zero()) continue;
    for (const auto& [h, multiplicity] : irreducible_factors(f)) {
      INFO("seed " << seed << " case " << i << " domain " << (domain == triangle ? "triangle" : "square")
                   << " degrees " << h.degree_u() << " " << h.degree_v());
      for (const Univariate& row : h.by_v) UNSCOPED_INFO(to_string(row, "u"));
      const ZeroSet zeros = zero_set(h, domain, whole, whole);
      for (const PlanarPoint& zero : zeros.zeros) check_zero(h, domain, zero, {});
      bool positive = false, negative = false, touched = false;
      constexpr int n = 16;
      for (int a = 0; a <= n; ++a) {
        for (int b = 0; b <= n && (domain == quadrilateral || a + b <= n); ++b) {
          const int s = sign(value_at(h, Rational(a, n), Rational(b, n)));
          positive |= s > 0;
          negative |= s < 0;
          touched |= s == 0;
        }
      }
      if (positive && negative) REQUIRE(zeros.changes_sign);
      if (touched) REQUIRE(zeros.dimension >= 0);
      if (zeros.changes_sign) {
        REQUIRE(zeros.dimension == 1);
        check_cell(h, domain, zeros);
      }
      for (const Symmetry& symmetry : symmetries(domain)) {
        const ZeroSet other = zero_set(substituted(h, symmetry), domain, whole, whole);
        REQUIRE(other.dimension == zeros.dimension);
        REQUIRE(other.changes_sign == zeros.changes_sign);
      }
      ++counts[zeros.dimension + 1];
      ++total;
      if (zeros.changes_sign) ++changes;
    }
  }
  INFO("seed " << seed << " none " << counts[0] << " points " << counts[1] << " curves " << counts[2]);
  CHECK(counts[0] > 50);
  CHECK(counts[1] > 10);
  CHECK(counts[2] > 100);
  CHECK(changes > 100);
}
