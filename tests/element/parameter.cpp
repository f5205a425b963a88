// parameter.hpp: points of domains by barycentric and affine coordinates.
#include "bezcert/element/parameter.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace bezcert;

namespace {

using Values = std::vector<Rational>;

}  // namespace

TEST_CASE("a parameter shows barycentric values of simplices and one value of a segment") {
  const Rational u(1, 2), v(1, 3), w(1, 7);
  const Parameter triangle = Parameter::at(Domain::triangle, {u, v});
  CHECK(triangle.values() == Values{Rational(1, 6), u, v});
  CHECK(to_string(triangle) == "(1/6, 1/2, 1/3)");
  const Parameter square = Parameter::at(Domain::square, {u, v});
  CHECK(square.values() == Values{u, v});
  CHECK(to_string(square) == "(1/2, 1/3)");
  // Three values of a hexahedron are no triangle's; a prism's triangle comes first.
  CHECK(Parameter::at(Domain(1, 1, 1), {u, v, w}).values() == Values{u, v, w});
  CHECK(Parameter::at(Domain(2, 1), {u, v, w}).values() == Values{Rational(1, 6), u, v, w});
  CHECK(Parameter::at(Domain(3), {u, v, w}).values() == Values{Rational(1, 42), u, v, w});
  for (const Domain domain : {Domain::triangle, Domain::square}) {
    const Parameter at = Parameter::at(domain, {u, v});
    CHECK(at.affine() == Values{u, v});
    CHECK(at == Parameter(domain, at.values()));
  }
  for (const Domain domain : {Domain(3), Domain(2, 1), Domain(1, 1, 1)}) {
    CHECK(Parameter::at(domain, {u, v, w}).affine() == Values{u, v, w});
  }
}

TEST_CASE("whether a parameter is inside, on each side of the domain") {
  const auto inside = [](Domain domain, const Rational& u, const Rational& v) {
    return Parameter::at(domain, {u, v}).is_inside();
  };
  for (const Domain domain : {Domain::triangle, Domain::square}) {
    CHECK(inside(domain, 0, 0));
    CHECK(inside(domain, 1, 0));
    CHECK(inside(domain, 0, 1));
    CHECK(inside(domain, Rational(1, 2), Rational(1, 2)));
    CHECK_FALSE(inside(domain, Rational(-1, 9), Rational(1, 2)));
    CHECK_FALSE(inside(domain, Rational(1, 2), Rational(-1, 9)));
    CHECK_FALSE(inside(domain, Rational(10, 9), 0));
    CHECK_FALSE(inside(domain, 0, Rational(10, 9)));
  }
  CHECK_FALSE(inside(Domain::triangle, Rational(1, 2), Rational(5, 9)));
  CHECK(inside(Domain::square, Rational(1, 2), Rational(5, 9)));
}

TEST_CASE("a parameter refuses values that are of no point") {
  CHECK_THROWS_AS(Parameter(Domain::triangle, {1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Parameter(Domain::triangle, {0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Parameter(Domain::square, {0, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Parameter::at(Domain::triangle, {0, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Parameter::at(Domain::square, {0}), std::invalid_argument);
}
