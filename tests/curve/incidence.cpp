// Which points lie on curves, and how far they are from them, where that is known in closed form.
#include "bezcert/curve/incidence.hpp"

#include "bezcert/curve/area.hpp"
#include "bezcert/curve/distance.hpp"
#include "bezcert/curve/winding.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

// (t, t^2).
const CurveNet<Integer> parabola{{0, 1, 2}, {0, 0, 2}, {2, 2, 2}};
// A quarter of the unit circle, (1 - t^2, 2 t) / (1 + t^2).
const CurveNet<Integer> quarter{{1, 1, 0}, {0, 1, 2}, {1, 1, 2}};

}  // namespace

TEST_CASE("points inside a curve, at its ends and off it") {
  CHECK(passes_inside(parabola, {Rational(1, 3), Rational(1, 9)}));
  CHECK_FALSE(passes_inside(parabola, {0, 0}));
  CHECK_FALSE(passes_inside(parabola, {1, 1}));
  CHECK_FALSE(passes_inside(parabola, {2, 4}));
  CHECK_FALSE(passes_inside(parabola, {Rational(1, 3), Rational(1, 10)}));
  CHECK(passes_inside(quarter, {Rational(3, 5), Rational(4, 5)}));
  CHECK_FALSE(passes_inside(quarter, {Rational(-3, 5), Rational(4, 5)}));
  // (t^2, t^2): at 1/2 for an irrational t.
  const CurveNet<Integer> line{{0, 0, 1}, {0, 0, 1}, {1, 1, 1}};
  CHECK(passes_inside(line, {Rational(1, 2), Rational(1, 2)}));
  CHECK(rational_parameters(line, {Rational(1, 2), Rational(1, 2)}, 0).empty());
  CHECK(rational_parameters(line, {Rational(1, 4), Rational(1, 4)}, 0) == std::vector{Rational(1, 2)});
  CHECK(rational_parameters(line, {Rational(1, 4), Rational(1, 4)}, Rational(1, 2)).empty());
}

TEST_CASE("curves that have a piece in common") {
  CHECK(run_together(parabola, part_of(parabola, Rational(1, 2), 2)));
  CHECK(run_together(parabola, reversed(part_of(parabola, -1, Rational(1, 2)))));
  CHECK_FALSE(run_together(parabola, part_of(parabola, 1, 2)));  // one point
  CHECK_FALSE(run_together(parabola, {{0, 1}, {0, 1}, {1, 1}}));
}

// t^2 and t are 1/4 apart at t = 1/2. From (0, 1) to (t, t^2): t^2 + (t^2 - 1)^2 is least, 3/4, at t^2 = 1/2.
TEST_CASE("distances") {
  const CurveNet<Integer> line{{0, 1}, {0, 1}, {1, 1}};
  const DistanceBounds apart = largest_distance(line, parabola);
  CHECK(to_rational(apart.lower) <= Rational(1, 4));
  CHECK(to_rational(apart.upper) >= Rational(1, 4));
  CHECK(to_rational(apart.upper) < Rational(26, 100));
  const Rational nearest = to_rational(distance_bounds(parabola, {0, 1}).upper);
  CHECK(nearest * nearest >= Rational(3, 4));
  CHECK(nearest * nearest < Rational(76, 100));
}

// Beside (t, t^2) the integral of (x dy - y dx) / 2 = (2 t^2 - t^2) / 2 is 1/6; beside the quarter of a
// circle it is pi / 4, between 7853/10000 and 7854/10000.
TEST_CASE("areas") {
  DyadicCurve polynomial(std::nullopt, parabola), rational(std::nullopt, quarter);
  CHECK(area_beside(polynomial, 0).lower == Rational(1, 6));
  CHECK(area_beside(polynomial, 3).is_exact());
  for (const int halvings : {0, 4, 8}) {
    const AreaBounds area = area_beside(rational, halvings);
    CHECK(area.lower < Rational(7854, 10000));
    CHECK(area.upper > Rational(7853, 10000));
    if (halvings == 8) CHECK(area.upper - area.lower < Rational(1, 1000));
  }
}

TEST_CASE("orientation of a chain") {
  const CurveNet<Integer> up{{0, 1}, {0, 0}, {1, 1}}, down{{0, 0}, {2, 0}, {2, 1}};
  std::vector<DyadicCurve> chain;
  for (const CurveNet<Integer>& one : {up, quarter, down}) chain.emplace_back(std::nullopt, one);
  CHECK(orientation(chain) == 1);
  CHECK(winding_number(chain, {Rational(1, 2), Rational(1, 2)}) == 1);
  CHECK(winding_number(chain, {2, 2}) == 0);
  std::vector<DyadicCurve> back;
  for (const CurveNet<Integer>& one : {down, quarter, up}) back.emplace_back(std::nullopt, reversed(one));
  CHECK(orientation(back) == -1);
}

}  // namespace bezcert::test
