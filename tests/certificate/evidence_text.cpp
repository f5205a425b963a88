// One text a value (docs/certificate-format.md, "Text"); the expected ones are written by hand.
#include "bezcert/certificate/evidence_text.hpp"
#include "algebra/polynomials.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("polynomials have one text") {
  CHECK(text_of_polynomial(Univariate()) == "0");
  CHECK(text_of_polynomial(poly({-3})) == "-3");
  CHECK(text_of_polynomial(poly({0, 0, 7})) == "0,0,7");
  CHECK(text_of_rational_polynomial({}) == "0");
  CHECK(text_of_rational_polynomial({Rational(0), Rational(0)}) == "0");
  CHECK(text_of_rational_polynomial({Rational(2), Rational(4)}) == "2,4");
  CHECK(text_of_rational_polynomial({Rational(1, 2), Rational(-2, 3), Rational(0)}) == "3,-4/6");
  CHECK(text_of_rational_polynomial({Rational(2, 4), Rational(3, 2)}) == "1,3/2");
  CHECK(text_of_polynomial2(Bivariate()) == "0");
  CHECK(text_of_polynomial2(poly2({poly({1, -2}), Univariate(), poly({0, 5})})) == "1,-2;0;0,5");
}

TEST_CASE("limits are those of checkers, halved") {
  CHECK(within_limits("columns u 1"));
  CHECK(within_limits(std::string(631305, '9')));
  CHECK_FALSE(within_limits(std::string(631306, '9')));
  std::string many;
  for (int i = 0; i < (1 << 20); ++i) many += "0,1,2,3,4,5,6,7,";
  CHECK(within_limits(many));
  CHECK_FALSE(within_limits(many + many + "1"));
}
