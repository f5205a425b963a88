// polynomial.hpp over intervals: every operation contains the exact one.
#include "bernstein/explicit_sum.hpp"

#include "bezcert/number/interval.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

Polynomial<Interval> enclosure(const Polynomial<Rational>& f) {
  Polynomial<Interval> result(f.shape);
  for (std::size_t m = 0; m < f.coefficients.size(); ++m)
    result.coefficients[m] = to_interval(f.coefficients[m]);
  return result;
}

bool contains(const Interval& interval, const Rational& x) {
  return Rational(interval.inf()) <= x && x <= Rational(interval.sup());
}

bool contains(const Polynomial<Interval>& f, const Polynomial<Rational>& g) {
  if (f.shape != g.shape || f.coefficients.size() != g.coefficients.size()) return false;
  for (std::size_t m = 0; m < g.coefficients.size(); ++m) {
    if (!contains(f.coefficients[m], g.coefficients[m])) return false;
  }
  return true;
}

/// The widest coefficient, to see that the enclosures say something.
Rational width(const Polynomial<Interval>& f) {
  Rational widest = 0;
  for (const Interval& c : f.coefficients) {
    const Rational w = Rational(c.sup()) - Rational(c.inf());
    if (w > widest) widest = w;
  }
  return widest;
}

}  // namespace

TEST_CASE("operations on interval polynomials contain the exact ones and stay narrow") {
  const std::uint64_t seed = seed_or(221);
  Random random(seed);
  const RoundUp up;
  const Rational narrow(1, 1000000);  // coefficients are below 60, degrees below 13: error far below this
  long cases = 0, inexact = 0;
  for (const Shape shape : all_shapes(6)) {
    const Polynomial<Rational> f = random_polynomial(random, shape);
    const Polynomial<Rational> g = random_polynomial(random, shape);
    const Polynomial<Interval> fi = enclosure(f);
    const Polynomial<Interval> gi = enclosure(g);
    const auto at = random_parameter(random, shape.domain, true);
    std::vector<Interval> at_interval;
    for (const Rational& x : at) at_interval.push_back(to_interval(x));
    INFO("seed " << seed << ", " << show(shape) << " at " << show(at));
    const Interval value = evaluate(fi, at_interval);
    if (!contains(value, evaluate(f, at))) FAIL("evaluate");
    if (Rational(value.sup()) - Rational(value.inf()) > narrow) FAIL("evaluate is wide");
    const auto check = [&](const Polynomial<Interval>& intervals, const Polynomial<Rational>& exact,
                           const char* what) {
      if (!contains(intervals, exact)) FAIL(what);
      if (width(intervals) > narrow) FAIL(what << " is wide: " << width(intervals));
      inexact += width(intervals) > 0;
      ++cases;
    };
    check(multiply(fi, gi), multiply(f, g), "multiply");
    check(elevate(fi, 2), elevate(f, 2), "elevate");
    const Rational t = random_parameter(random, Domain::segment, true)[0];
    const int direction = shape.domain == Domain::square ? static_cast<int>(random.integer(0, 1)) : 0;
    const auto [first, second] = split(f, t, direction);
    const auto [first_interval, second_interval] = split(fi, to_interval(t), direction);
    check(first_interval, first, "split, first part");
    check(second_interval, second, "split, second part");
    if ((direction == 1 ? shape.degree(1) : shape.degree(0)) > 0) {
      check(differentiate(fi, direction), differentiate(f, direction), "differentiate");
    }
  }
  CHECK(cases > 63 * 4);
  CHECK(inexact > 150);
}
