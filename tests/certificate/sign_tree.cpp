// Subdivisions derived by hand, and Bernstein coefficients held against values.
#include "bezcert/certificate/sign_tree.hpp"
#include "algebra/polynomials.hpp"
#include "bezcert/certificate/column_evidence.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("Bernstein coefficients have the polynomial's values") {
  Random random(seed_or(20241));
  for (int round = 0; round < 40; ++round) {
    const Bivariate f = random_bivariate(random, static_cast<int>(random.integer(0, 4)),
                                         static_cast<int>(random.integer(0, 4)), 50);
    for (const Domain domain : {Domain::triangle, Domain::square}) {
      const Polynomial<Integer> b = to_bernstein(f, domain);
      Polynomial<Rational> exact(b.shape);
      for (std::size_t i = 0; i < b.coefficients.size(); ++i)
        exact.coefficients[i] = Rational(b.coefficients[i]);
      const auto at = [&](const Rational& u, const Rational& v) {
        return domain == Domain::triangle ? evaluate(exact, {Rational(1 - u - v), u, v})
                                          : evaluate(exact, {u, v});
      };
      // One positive factor for all.
      Rational factor = 0;
      for (int k = 0; k < 8; ++k) {
        const Rational u = random.rational(-1, 1, 7), v = random.rational(-1, 1, 5);
        const Rational value = value_at(f, u, v);
        if (value.is_zero()) {
          CHECK(at(u, v).is_zero());
          continue;
        }
        if (factor.is_zero()) factor = at(u, v) / value;
        CHECK(at(u, v) == factor * value);
      }
      CHECK(factor >= 0);
    }
  }
}

TEST_CASE("trees are cut depth first") {
  // 8 u^2 - 4 u + 1 has the coefficients 1, -1, 5 on [0, 1]; 1, 0, 1 and 1, 2, 5 on the halves.
  const Bivariate f = poly2({poly({1, -4, 8})});
  const auto tree = [](const Bivariate& g, Domain domain) {
    return sign_tree(to_bernstein(g, domain), Strictness::strict);
  };
  CHECK(tree(f, Domain::square) == "100");
  CHECK(tree(swapped(f), Domain::square) == "1100100");
  // On the triangle, over u: corners 0, 1, 0. First child: 0, 0, 1/2, with coefficients 1, 0, 1. Second: 1,
  // 0, 1/2, where the blossom of (1, 0) is -1; its halves 1/2, 1, 1/2 and 0, 1/2, 1/2.
  CHECK(tree(f, Domain::triangle) == "10100");
  CHECK(tree(constant2(3), Domain::triangle) == "0");
  // A zero on the way, or beside all corners.
  CHECK_FALSE(tree(poly2({poly({1, -4, 4})}), Domain::square));
  CHECK(sign_tree(to_bernstein(poly2({poly({1, -4, 4})}), Domain::square), Strictness::weak) == "100");
  CHECK_FALSE(sign_tree(to_bernstein(poly2({poly({1, -6, 9})}), Domain::square), Strictness::weak));
  CHECK_FALSE(tree(poly2({poly({1, -6, 8})}), Domain::square));
  CHECK_FALSE(sign_tree(to_bernstein(swapped(f), Domain::square), Strictness::strict, {6, 10, 1000000}));
  CHECK_FALSE(sign_tree(to_bernstein(swapped(f), Domain::square), Strictness::strict, {7, 1, 1000000}));
}

TEST_CASE("segments are halved") {
  CHECK(positive_on_segment(poly({1, -4, 8})));
  CHECK(positive_on_segment(poly({1})));
  CHECK_FALSE(positive_on_segment(poly({-1})));
  CHECK_FALSE(positive_on_segment(poly({0, 1})));
  CHECK_FALSE(positive_on_segment(poly({1, -6, 9})));
  CHECK(positive_on_segment(poly({1000000001, -6000000000, 9000000000})));
  CHECK_FALSE(positive_on_segment(poly({1000000001, -6000000000, 9000000000}), 16));
}

TEST_CASE("columns do not show what is not so") {
  // A circle inside the triangle: both signs.
  const Bivariate circle = constant2(16) * (square(line2(-1, 3, 0)) + square(line2(-1, 0, 3))) - constant2(1);
  for (const Domain domain : {Domain::triangle, Domain::square}) {
    for (const Strictness wanted : {Strictness::strict, Strictness::weak}) {
      CHECK_FALSE(column_evidence(circle, domain, wanted));
      CHECK_FALSE(column_evidence(constant2(-1) * circle, domain, wanted));
    }
    // An isolated zero: only weakly.
    const Bivariate touching = square(line2(-1, 3, 0)) + square(line2(-1, 0, 3));
    CHECK_FALSE(column_evidence(touching, domain, Strictness::strict));
    CHECK(column_evidence(touching, domain, Strictness::weak));
    CHECK_FALSE(column_evidence(constant2(-1) * touching, domain, Strictness::weak));
  }
}
