// Common zeros on a line u = alpha where they are known in closed form.
#include "bezcert/algebra/fiber.hpp"
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// 1/sqrt 2, by 2 x^2 - 1; 1/cbrt 4 by 4 x^3 - 1; and 1/3.
RealRoot root2() { return {poly({-1, 0, 2}), Rational(1, 2), 1}; }
RealRoot cube_root() { return {poly({-1, 0, 0, 4}), Rational(1, 2), 1}; }
RealRoot third() { return {poly({-1, 3}), Rational(1, 3), Rational(1, 3)}; }

const Univariate zero, one = poly({1}), alpha_itself = poly({0, 1}), one_minus_alpha = poly({1, -1});

int count(const RealRoot& alpha, const std::vector<Bivariate>& f, const Univariate& low,
          const Univariate& high, bool included) {
  Fiber fiber(alpha, f);
  return fiber.count(low, high, included ? Fiber::Ends::included : Fiber::Ends::excluded);
}

void check_encloses(const RealRoot& root, double value) {
  CAPTURE(root.lower, root.upper, value);
  CHECK(root.lower <= root.upper);
  CHECK(root.upper - root.lower <= power_of_two(-45));
  CHECK(std::abs(root.lower.convert_to<double>() - value) < 1e-12);
}

const Rational width = power_of_two(-45);

}  // namespace

TEST_CASE("a fibre counts the roots between ends that depend on alpha") {
  // (v - u) (v - 2u) (3v - 1): at 1/sqrt 2 the roots 0.707, 1.414, 0.333.
  const Bivariate f = (V - U) * (V - U - U) * line2(-1, 0, 3);
  CHECK(count(root2(), {f}, zero, one, true) == 2);
  CHECK(count(root2(), {f}, zero, one, false) == 2);
  CHECK(count(root2(), {f}, zero, poly({2}), true) == 3);
  CHECK(count(root2(), {f}, zero, one_minus_alpha, true) == 0);
  CHECK(count(root2(), {f}, zero, alpha_itself, true) == 2);
  CHECK(count(root2(), {f}, zero, alpha_itself, false) == 1);
  CHECK(count(root2(), {f}, alpha_itself, poly({0, 2}), true) == 2);
  CHECK(count(root2(), {f}, alpha_itself, poly({0, 2}), false) == 0);
  // 2 alpha = 4 alpha^3 in the field: the same end written otherwise.
  CHECK(count(root2(), {f}, alpha_itself, poly({0, 0, 0, 4}), true) == 2);
  CHECK(count(root2(), {f}, alpha_itself, poly({0, 0, 0, 4}), false) == 0);
  // At 1/3 two of the roots are one.
  CHECK(count(third(), {f}, zero, one, true) == 2);
  CHECK(count(third(), {f}, alpha_itself, one, true) == 2);
  CHECK(count(third(), {f}, alpha_itself, one, false) == 1);
}

TEST_CASE("multiple roots count once, also those that are multiple only over alpha") {
  const Bivariate f = square(V - U) * line2(-1, 0, 3) * square(line2(-1, 0, 3));
  CHECK(count(root2(), {f}, zero, one, true) == 2);
  // v^2 - 2 u^2 v + (u^2 - 1/4): at 1/sqrt 2 it is (v - 1/2)^2.
  const Bivariate g =
      constant2(4) * square(V) - constant2(8) * square(U) * V + constant2(4) * square(U) - constant2(1);
  CHECK(count(root2(), {g}, zero, one, true) == 1);
  CHECK(count(root2(), {g}, zero, one, false) == 1);
  Fiber fiber(root2(), {g});
  const RealRoot v = fiber.smallest(zero, one, Fiber::Ends::excluded, width);
  CHECK(v.is_rational());
  CHECK(v.lower == Rational(1, 2));
}

TEST_CASE("common zeros of several polynomials") {
  const Bivariate f = (V - U) * line2(-1, 0, 3), g = (V - U) * line2(-1, 0, 2);
  CHECK(count(root2(), {f, g}, zero, one, true) == 1);
  CHECK(count(root2(), {f, line2(-1, 0, 3)}, zero, one, true) == 1);
  CHECK(count(root2(), {f, line2(-1, 0, 2)}, zero, one, true) == 0);
  // Common only over this alpha: v = u and v = 1/(2u) meet at 1/sqrt 2.
  const Bivariate reciprocal = constant2(2) * U * V - constant2(1);
  CHECK(count(root2(), {V - U, reciprocal}, zero, one, true) == 1);
  CHECK(count(cube_root(), {V - U, reciprocal}, zero, one, true) == 0);
  // A polynomial that vanishes on the line says nothing.
  const Bivariate vanishing = poly2({poly({-1, 0, 2})}) * (V + constant2(5));
  CHECK(count(root2(), {vanishing, f}, zero, one, true) == 2);
  CHECK(count(root2(), {f, vanishing}, zero, one, true) == 2);
  CHECK(Fiber(root2(), {vanishing}).is_whole_line());
  CHECK(Fiber(root2(), {vanishing, vanishing}).is_whole_line());
  CHECK_FALSE(Fiber(root2(), {vanishing, f}).is_whole_line());
  CHECK_FALSE(Fiber(cube_root(), {vanishing}).is_whole_line());
  // No zero, or a constant.
  CHECK(count(root2(), {square(V) + U}, zero, one, true) == 0);
  CHECK(count(root2(), {U}, zero, one, true) == 0);
}

TEST_CASE("leading coefficients that vanish over alpha") {
  const Bivariate f = poly2({poly({-1, 0, 2})}) * square(V) * V + V - U;
  CHECK(count(root2(), {f}, zero, one, true) == 1);
  Fiber fiber(root2(), {f});
  check_encloses(fiber.smallest(zero, one, Fiber::Ends::included, width), std::sqrt(0.5));
}

TEST_CASE("the smallest root encloses the known value") {
  {
    Fiber fiber(root2(), {square(V) - U});  // 2^(-1/4)
    REQUIRE(fiber.count(zero, one, Fiber::Ends::included) == 1);
    check_encloses(fiber.smallest(zero, one, Fiber::Ends::included, width), std::pow(2, -0.25));
  }
  {
    Fiber fiber(cube_root(), {square(V) - U});  // 4^(-1/6), and its negative outside
    REQUIRE(fiber.count(zero, one, Fiber::Ends::included) == 1);
    REQUIRE(fiber.count(poly({-1}), one, Fiber::Ends::included) == 2);
    check_encloses(fiber.smallest(zero, one, Fiber::Ends::included, width), std::pow(4, -1.0 / 6));
    check_encloses(fiber.smallest(poly({-1}), one, Fiber::Ends::included, width), -std::pow(4, -1.0 / 6));
  }
  {
    // v^3 = 2 u^3 at 1/cbrt 4: v = 1/cbrt 2; linear common divisor with v = 2 u^2.
    Fiber fiber(cube_root(), {square(V) * V - constant2(2) * square(U) * U, V - constant2(2) * square(U)});
    REQUIRE(fiber.count(zero, one, Fiber::Ends::excluded) == 1);
    check_encloses(fiber.smallest(zero, one, Fiber::Ends::excluded, width), std::cbrt(0.5));
  }
  {
    // Rational alpha: irrational and rational roots.
    Fiber fiber(third(), {(square(V) - U) * line2(-2, 0, 3)});  // 0.577, 2/3
    REQUIRE(fiber.count(zero, one, Fiber::Ends::included) == 2);
    check_encloses(fiber.smallest(zero, one, Fiber::Ends::included, width), std::sqrt(1.0 / 3));
    // Above 3/5 only the rational one is left; ends that are roots count or not.
    const RealRoot second = fiber.smallest(poly({0, 2}), one, Fiber::Ends::included, width);
    CHECK((second.is_rational() && second.lower == Rational(2, 3)));
    REQUIRE(fiber.count(poly({0, 2}), one, Fiber::Ends::excluded) == 0);
    Fiber other(third(), {line2(-2, 0, 3) * line2(-3, 0, 4)});
    REQUIRE(other.count(poly({0, 2}), one, Fiber::Ends::excluded) == 1);
    CHECK(other.smallest(poly({0, 2}), one, Fiber::Ends::excluded, width).lower == Rational(3, 4));
  }
}

TEST_CASE("the smallest root with ends, and next to another root") {
  const Bivariate f = (V - U) * line2(-1, -4, 4) * line2(-9, 0, 10);  // alpha, alpha + 1/4, 9/10
  {
    Fiber fiber(root2(), {f});
    REQUIRE(fiber.count(alpha_itself, one, Fiber::Ends::included) == 3);
    REQUIRE(fiber.count(alpha_itself, one, Fiber::Ends::excluded) == 2);
    check_encloses(fiber.smallest(alpha_itself, one, Fiber::Ends::included, width), std::sqrt(0.5));
    check_encloses(fiber.smallest(alpha_itself, one, Fiber::Ends::excluded, width), 0.9);
    check_encloses(fiber.smallest(zero, alpha_itself, Fiber::Ends::included, width), std::sqrt(0.5));
    REQUIRE(fiber.count(zero, alpha_itself, Fiber::Ends::excluded) == 0);
    const RealRoot last =
        fiber.smallest(poly({0, 0, 0, 0, 3}), one, Fiber::Ends::included, width);  // from 3/4 on
    check_encloses(last, 0.9);
    CHECK(last.lower <= Rational(9, 10));
    CHECK(last.upper >= Rational(9, 10));
  }
  for (const int bits : {20, 60, 100}) {
    // alpha and alpha + 2^-bits: isolated from each other, whatever the width asked for.
    const Rational gap = power_of_two(-bits);
    const Integer size = Integer(1) << bits;
    const Bivariate shifted = poly2({Univariate({size}) * (V - U).by_v[0] - poly({1}), Univariate({size})});
    Fiber fiber(root2(), {(V - U) * shifted});
    CAPTURE(bits);
    REQUIRE(fiber.count(zero, one, Fiber::Ends::excluded) == 2);
    REQUIRE(fiber.count(alpha_itself, one, Fiber::Ends::excluded) == 1);
    const RealRoot v = fiber.smallest(zero, one, Fiber::Ends::excluded, width);
    CHECK(v.upper - v.lower <= width);
    // 2 x^2 = 1 at alpha: alpha lies in the interval, alpha + gap does not.
    CHECK(2 * v.lower * v.lower <= 1);
    CHECK(2 * v.upper * v.upper >= 1);
    CHECK((2 * (v.upper - gap) * (v.upper - gap) < 1 || 2 * (v.lower - gap) * (v.lower - gap) > 1));
    const RealRoot next = fiber.smallest(alpha_itself, one, Fiber::Ends::excluded, width);
    CHECK(2 * (next.lower - gap) * (next.lower - gap) <= 1);
    CHECK(2 * (next.upper - gap) * (next.upper - gap) >= 1);
    CHECK((2 * next.lower * next.lower > 1 || 2 * next.upper * next.upper < 1));
  }
}
