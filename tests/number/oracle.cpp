// The judge itself: double_oracle.hpp against facts of IEEE 754 that need no code.
#include "double_oracle.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("oracle: the value of a double is read from its bits") {
  CHECK(value_of(0.0) == 0);
  CHECK(value_of(-0.0) == 0);
  CHECK(value_of(1.0) == 1);
  CHECK(value_of(-0.75) == Rational(-3, 4));
  CHECK(value_of(smallest_double) == dyadic(1, -1074));
  CHECK(value_of(largest_double) == dyadic(1, 1024) - dyadic(1, 971));
  CHECK(value_of(std::numeric_limits<double>::min()) == dyadic(1, -1022));
}

TEST_CASE("oracle: the doubles around a rational") {
  const Around third = around(Rational(1, 3));
  CHECK(same_bits(third.below, 0x1.5555555555555p-2));
  CHECK(same_bits(third.above, 0x1.5555555555556p-2));
  const Around minus = around(Rational(-1, 3));
  CHECK(same_bits(minus.below, -0x1.5555555555556p-2));
  CHECK(same_bits(minus.above, -0x1.5555555555555p-2));
  CHECK(around(dyadic(1, -1075)).below == 0);
  CHECK(same_bits(around(dyadic(1, -1075)).above, smallest_double));
  CHECK(same_bits(around(dyadic(1, 1024)).below, largest_double));
  CHECK(around(dyadic(1, 1024)).above == infinity);
  CHECK(around(Rational(5)).below == 5);
  CHECK(around(Rational(5)).above == 5);
}

TEST_CASE("oracle: nearest double with ties to even") {
  CHECK(nearest_double(dyadic(1, 53) + 1) == 0x1p53);
  CHECK(nearest_double(dyadic(1, 53) + 3) == 0x1.0000000000002p53);
  CHECK(nearest_double(dyadic(1, -1075)) == 0.0);
  CHECK(nearest_double(dyadic(3, -1076)) == smallest_double);
  CHECK(nearest_double(dyadic(1, 1024) - dyadic(1, 970)) == std::nullopt);
  CHECK(nearest_double(dyadic(1, 1024) - dyadic(1, 970) - 1) == largest_double);
  CHECK(nearest_double(Rational(-1, 3)) == -0x1.5555555555555p-2);
}
