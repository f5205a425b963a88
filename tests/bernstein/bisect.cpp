// element/bisect.hpp: halves of polynomials on the pieces of newest vertex bisection.
#include "bernstein/explicit_sum.hpp"

#include "bezcert/element/bisect.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

const Rational half(1, 2);

int direction_count(Shape shape) { return shape.domain == Domain::square ? 2 : 1; }

Rational two_to(int exponent) {
  Rational result = 1;
  for (int k = 0; k < exponent; ++k) result *= 2;
  return result;
}

/// The parameter of the whole that a parameter of the first or second half stands for.
std::vector<Rational> in_whole(Domain domain, const std::vector<Rational>& at, int direction, bool second) {
  if (domain == Domain::triangle) {
    // (C, A, M) and (B, C, M) with M = (A + B) / 2, in coordinates with respect to (A, B, C).
    if (!second) return {at[1] + half * at[2], half * at[2], at[0]};
    return {half * at[2], at[0] + half * at[2], at[1]};
  }
  auto result = at;
  const auto d = static_cast<std::size_t>(direction);
  result[d] = half * at[d] + (second ? half : Rational(0));
  return result;
}

}  // namespace

TEST_CASE("halves of integer polynomials are the restrictions, times the stated power of two") {
  const std::uint64_t seed = seed_or(241);
  Random random(seed);
  long cases = 0;
  for (const Shape shape : all_shapes(7)) {
    for (int direction = 0; direction < direction_count(shape); ++direction) {
      const Polynomial<Integer> f = random_integer_polynomial(random, shape);
      const auto [first, second] = bisect(f, direction);
      const int shift = bisection_shift<Integer>(shape, direction);
      INFO("seed " << seed << ", " << show(shape) << ", direction " << direction);
      CHECK(shift == (shape.domain == Domain::square && direction == 1 ? shape.degree(1) : shape.degree(0)));
      if (first.shape != shape || second.shape != shape) FAIL("shape");
      for (int k = 0; k < 4; ++k) {
        const auto at = random_parameter(random, shape.domain);
        const auto expected = [&](bool in_second) {
          return Rational(two_to(shift) *
                          explicit_value(f, in_whole(shape.domain, at, direction, in_second)));
        };
        if (explicit_value(first, at) != expected(false)) FAIL("first half at " << show(at));
        if (explicit_value(second, at) != expected(true)) FAIL("second half at " << show(at));
        ++cases;
      }
    }
  }
  CHECK(cases == 4 * (8 + 8 + 64 * 2));
}

TEST_CASE("halves are the parts of split at 1/2, with the corners of a triangle turned") {
  const std::uint64_t seed = seed_or(242);
  Random random(seed);
  for (const Shape shape : all_shapes(6)) {
    for (int direction = 0; direction < direction_count(shape); ++direction) {
      const Polynomial<Integer> f = random_integer_polynomial(random, shape);
      const auto [first, second] = bisect(f, direction);
      const auto [lower, upper] = split(as_rational(f), half, direction);
      const Rational factor = two_to(bisection_shift<Integer>(shape, direction));
      INFO("seed " << seed << ", " << show(shape) << ", direction " << direction);
      for (int r = 0; r < row_count(shape); ++r) {
        for (int c = 0; c < column_count(shape, r); ++c) {
          const Rational a(first.at(r, c));
          const Rational b(second.at(r, c));
          if (shape.domain != Domain::triangle) {
            if (a != factor * lower.at(r, c) || b != factor * upper.at(r, c))
              FAIL("row " << r << ", column " << c);
            continue;
          }
          // Exponents (i, c, r) belong to (C, A, M) of the first half, to (B, C, M) of the second; the parts
          // of split are over (A, M, C) and (M, B, C), where row = exponent of the third corner, column of
          // the second.
          const int i = shape.degree(0) - r - c;
          if (a != factor * lower.at(i, r)) FAIL("first half, row " << r << ", column " << c);
          if (b != factor * upper.at(c, i)) FAIL("second half, row " << r << ", column " << c);
        }
      }
    }
  }
}

TEST_CASE("halves of interval polynomials contain the exact halves, without shift, and stay narrow") {
  const std::uint64_t seed = seed_or(243);
  Random random(seed);
  const RoundUp up;
  long inexact = 0, exact_halves = 0;
  for (const Shape shape : all_shapes(7)) {
    for (int direction = 0; direction < direction_count(shape); ++direction) {
      CHECK(bisection_shift<Interval>(shape, direction) == 0);
      for (const long size : {1000L, 1L << 52, 1L << 62}) {
        const Polynomial<Integer> f = random_integer_polynomial(random, shape, size);
        Polynomial<Interval> g(shape);
        for (std::size_t m = 0; m < f.coefficients.size(); ++m)
          g.coefficients[m] = to_interval(f.coefficients[m]);
        const auto exact = bisect(f, direction);
        const auto intervals = bisect(g, direction);
        const Rational factor = two_to(bisection_shift<Integer>(shape, direction));
        INFO("seed " << seed << ", " << show(shape) << ", direction " << direction << ", size " << size);
        const auto check = [&](const Polynomial<Interval>& half_interval,
                               const Polynomial<Integer>& half_exact) {
          if (half_interval.shape != shape) FAIL("shape");
          for (std::size_t m = 0; m < half_exact.coefficients.size(); ++m) {
            const Rational value = Rational(half_exact.coefficients[m]) / factor;
            const Rational low(half_interval.coefficients[m].inf());
            const Rational high(half_interval.coefficients[m].sup());
            if (value < low || high < value) FAIL("coefficient " << m);
            if ((high - low) * (1L << 40) > size) FAIL("wide at " << m);
            (low == high ? exact_halves : inexact) += 1;
          }
        };
        check(intervals.first, exact.first);
        check(intervals.second, exact.second);
      }
    }
  }
  CHECK(inexact > 1000);
  CHECK(exact_halves > 1000);
}

TEST_CASE("bisecting twice keeps the rotation: the second cut starts at the middle of the first") {
  // Over (A, B, C) the linear polynomials xi_0, xi_1, xi_2 name the corners.
  const Shape linear = Shape::triangle(1);
  const auto corners_after = [&](bool first_cut, bool second_cut) {
    std::vector<std::vector<Rational>> corners(3);
    for (std::size_t k = 0; k < 3; ++k) {
      Polynomial<Integer> xi(linear);
      xi.coefficients[k] = 1;
      const auto halves = bisect(xi, 0);
      const auto quarters = bisect(first_cut ? halves.second : halves.first, 0);
      const Polynomial<Integer>& piece = second_cut ? quarters.second : quarters.first;
      for (std::size_t c = 0; c < 3; ++c) corners[c].push_back(Rational(piece.coefficients[c]) / 4);
    }
    return corners;
  };
  const std::vector<Rational> a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1}, m{half, half, 0};
  const std::vector<Rational> middle_ca{half, 0, half}, middle_bc{0, half, half};
  using Corners = std::vector<std::vector<Rational>>;
  CHECK(corners_after(false, false) == Corners{m, c, middle_ca});  // of (C, A, M)
  CHECK(corners_after(false, true) == Corners{a, m, middle_ca});
  CHECK(corners_after(true, false) == Corners{m, b, middle_bc});  // of (B, C, M)
  CHECK(corners_after(true, true) == Corners{c, m, middle_bc});
}
