// The bounds of `subdivision` hold and are as narrow as asked for.
#include "bezcert/element/forms.hpp"
#include "bezcert/element/map.hpp"
#include "bezcert/criterion/subdivision.hpp"

#include "random_element.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("sampled det J lies in the bounds, which are as narrow as asked") {
  const std::uint64_t seed = seed_or(12);
  Random random(seed);
  int narrow = 0;
  int rational = 0;
  for (int i = 0; i < 400; ++i) {
    const RawElement raw = random_element(random, {.max_degree = 4});
    const Element element = raw.build();
    const Forms forms(element);
    SubdivisionOptions options;
    options.relative_width = Rational(1, random.integer(2, 200));
    options.pieces = 3000;
    const Verdict verdict = subdivision(forms, options);
    INFO("seed " << seed << " case " << i << " " << raw.text());
    REQUIRE(verdict.bounds);
    const Rational min_lower = to_rational(verdict.bounds->min_lower),
                   min_upper = to_rational(verdict.bounds->min_upper);
    const Rational max_lower = to_rational(verdict.bounds->max_lower),
                   max_upper = to_rational(verdict.bounds->max_upper);
    REQUIRE(min_lower <= min_upper);
    REQUIRE(max_lower <= max_upper);
    REQUIRE(min_upper <= max_upper);
    // Exact values at many parameters, by the direct formula.
    for (int k = 0; k < 20; ++k) {
      const Rational value =
          evaluate_map(element, random_parameter(random, element.shape().domain)).determinant;
      REQUIRE(min_lower <= value);
      REQUIRE(value <= max_upper);
    }
    if (verdict.status == Status::inconclusive) continue;
    const Rational largest = std::max(abs(min_upper), abs(max_lower));
    const Rational width = options.relative_width * largest;
    if (min_upper - min_lower <= width && max_upper - max_lower <= width) ++narrow;
    if (element.rational()) ++rational;
  }
  INFO("seed " << seed);
  CHECK(narrow > 350);
  CHECK(rational > 80);
}

TEST_CASE("known extreme values lie in the bounds") {
  // x = u + u^2, y = v on the unit square (degree 2 x 1): det J = 1 + 2u, from 1 to 3.
  const RawElement raw{
      Shape::square(2, 1), {0, Rational(1, 2), 2, 0, Rational(1, 2), 2}, {0, 0, 0, 1, 1, 1}, {}};
  const Element element = raw.build();
  SubdivisionOptions options;
  options.relative_width = Rational(1, 1000);
  const Verdict verdict = subdivision(Forms(element), options);
  REQUIRE(verdict.status == Status::proved);
  CHECK(to_rational(verdict.bounds->min_lower) <= 1);
  CHECK(to_rational(verdict.bounds->min_upper) >= 1);
  CHECK(to_rational(verdict.bounds->max_lower) <= 3);
  CHECK(to_rational(verdict.bounds->max_upper) >= 3);
  CHECK(to_rational(verdict.bounds->min_lower) > Rational(997, 1000));
  CHECK(to_rational(verdict.bounds->max_upper) < Rational(3004, 1000));
}

TEST_CASE("the width must be positive") {
  const Element element = straight(Shape::triangle(1), 1).build();
  SubdivisionOptions options;
  options.relative_width = 0;
  CHECK_THROWS_AS(subdivision(Forms(element), options), std::invalid_argument);
}
