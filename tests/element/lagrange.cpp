// lagrange.hpp: the Bernstein coefficients interpolate the nodal values; elements given by nodes.
#include "element/random_net.hpp"

#include "bezcert/element/jacobian.hpp"
#include "bezcert/element/lagrange.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace bezcert;
using namespace bezcert::test;

namespace {

/// The equispaced node of every coefficient, as a parameter.
std::vector<Values> nodes(Shape shape) {
  std::vector<Values> result;
  for (const auto& [r, c] : rows_and_columns(shape)) {
    const Rational u = Rational(c) / shape.degree(0);
    if (shape.domain == Domain::triangle) {
      const Rational v = Rational(r) / shape.degree(0);
      result.push_back({1 - u - v, u, v});
    } else if (shape.domain == Domain::square) {
      result.push_back({u, Rational(r) / shape.degree(1)});
    } else {
      result.push_back({u});
    }
  }
  return result;
}

Polynomial<Rational> converted(Shape shape, const std::vector<Rational>& nodal) {
  const BasisChange& change = lagrange_to_bernstein(shape);
  Polynomial<Rational> f(shape);
  REQUIRE(change.rows.size() == f.coefficients.size());
  for (std::size_t m = 0; m < change.rows.size(); ++m) {
    Rational sum = 0;
    for (const auto& entry : change.rows[m]) sum += Rational(entry.exact) * nodal.at(entry.column);
    f.coefficients[m] = sum / Rational(change.denominator);
  }
  return f;
}

/// The same element given by the values of its homogeneous map at the nodes.
ControlNet nodal_net(const ControlNet& net) {
  ControlNet result;
  result.shape = net.shape;
  for (const Values& node : nodes(net.shape)) {
    const Homogeneous p = weighted_sum(net, basis_values(net.shape, node));
    result.x.push_back(p.x / p.w);
    result.y.push_back(p.y / p.w);
    if (!net.w.empty()) result.w.push_back(p.w);
  }
  return result;
}

Element lagrange_element(const ControlNet& nodal) {
  return Element(nodal.shape, Basis::lagrange, {ExactVector(nodal.x), ExactVector(nodal.y)},
                 ExactVector(nodal.w));
}

void check_interpolation(Shape shape, Random& random) {
  std::vector<Rational> nodal(coefficient_count(shape));
  for (Rational& x : nodal) x = Rational(random.integer(-1000, 1000));
  const Polynomial<Rational> f = converted(shape, nodal);
  const auto all = nodes(shape);
  for (std::size_t m = 0; m < all.size(); ++m) {
    if (explicit_value(f, all[m]) != nodal[m]) FAIL("node " << show(all[m]));
  }
}

}  // namespace

TEST_CASE("nodal values are interpolated: triangles of degrees 1..10, segments, squares of all degrees") {
  const std::uint64_t seed = seed_or(311);
  Random random(seed);
  for (int n = 1; n <= 10; ++n) {
    INFO("seed " << seed << ", degree " << n);
    check_interpolation(Shape::triangle(n), random);
    check_interpolation(Shape::segment(n), random);
  }
  for (int p = 1; p <= 10; ++p) {
    for (int q = 1; q <= 10; ++q) {
      if (p > 5 && q > 5 && p != q && p + q != 17) continue;  // unequal degrees thin out above 5
      INFO("seed " << seed << ", degrees " << p << ", " << q);
      check_interpolation(Shape::square(p, q), random);
    }
  }
}

TEST_CASE("each Lagrange basis function is 1 at its node and 0 at the others") {
  for (const Shape shape :
       {Shape::segment(4), Shape::triangle(4), Shape::square(3, 2), Shape::square(1, 4)}) {
    const auto all = nodes(shape);
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::vector<Rational> nodal(all.size());
      nodal[k] = 1;
      const Polynomial<Rational> f = converted(shape, nodal);
      for (std::size_t m = 0; m < all.size(); ++m) {
        INFO(show(shape) << ", function " << k << " at node " << m);
        CHECK(explicit_value(f, all[m]) == (k == m ? 1 : 0));
      }
    }
  }
}

TEST_CASE("known matrices: degree 2") {
  // On the segment c_1 = 2 f(1/2) - (f(0) + f(1)) / 2.
  const Polynomial<Rational> f = converted(Shape::segment(2), {3, 5, 11});
  CHECK(f.coefficients == std::vector<Rational>{3, 3, 11});
  // The order is 200 110 020 / 101 011 / 002. L_101 = 4 xi_0 xi_2 = 2 B_101.
  const Polynomial<Rational> g = converted(Shape::triangle(2), {0, 0, 0, 1, 0, 0});
  CHECK(g.coefficients == std::vector<Rational>{0, 0, 0, 2, 0, 0});
  // L_020 = xi_1 (2 xi_1 - 1) = xi_1 (xi_1 - xi_0 - xi_2) = B_020 - (B_110 + B_011) / 2.
  const Polynomial<Rational> h = converted(Shape::triangle(2), {0, 0, 1, 0, 0, 0});
  CHECK(h.coefficients == std::vector<Rational>{0, Rational(-1, 2), 1, 0, Rational(-1, 2), 0});
}

TEST_CASE("matrices are sparse lists of distinct columns with intervals around their integers") {
  for (const Shape shape : element_shapes(10, 4)) {
    const BasisChange& change = lagrange_to_bernstein(shape);
    INFO(show(shape));
    CHECK(change.denominator > 0);
    CHECK(&lagrange_to_bernstein(shape) == &change);
    for (const auto& row : change.rows) {
      std::set<std::size_t> columns;
      Integer sum = 0;
      for (const auto& entry : row) {
        if (entry.column >= change.rows.size()) FAIL("column " << entry.column);
        if (!columns.insert(entry.column).second) FAIL("column twice: " << entry.column);
        if (Rational(entry.interval.inf()) > Rational(entry.exact)) FAIL("interval");
        if (Rational(entry.interval.sup()) < Rational(entry.exact)) FAIL("interval");
        sum += entry.exact;
      }
      if (sum != change.denominator) FAIL("a constant is not kept");
    }
  }
}

TEST_CASE("an element given by nodes is the element that was sampled") {
  const std::uint64_t seed = seed_or(312);
  Random random(seed);
  long rational = 0, polynomial = 0;
  std::vector<Shape> shapes = element_shapes(5, 3);
  shapes.push_back(Shape::triangle(8));
  shapes.push_back(Shape::square(5, 2));
  for (const Shape shape : shapes) {
    for (const Weights weights : all_weights) {
      const ControlNet net = random_net(random, shape, random_points(random), weights);
      const ControlNet nodal = nodal_net(net);
      const Element element = lagrange_element(nodal);
      INFO("seed " << seed << ", " << show(net));
      CHECK(element.basis() == Basis::lagrange);
      CHECK(element.rational() == really_rational(net));
      CHECK(element.coordinates()[0][0] == nodal.x[0]);
      // The control net that the integers hold is the one that was sampled.
      const ExactNet exact = exact_net(element);
      const auto w = [&](std::size_t m) {
        return exact.net.rational() ? Rational(exact.net.weights[m]) : Rational(1);
      };
      for (std::size_t m = 0; m < net.x.size(); ++m) {
        if (exact.scale * Rational(exact.net.coordinates[0][m]) / w(m) != net.x[m] - net.x[0])
          FAIL("x of point " << m);
        if (exact.scale * Rational(exact.net.coordinates[1][m]) / w(m) != net.y[m] - net.y[0])
          FAIL("y of point " << m);
        if (w(m) / w(0) != net.weight(m) / net.weight(0)) FAIL("weight " << m);
      }
      const auto at = random_parameter(random, shape.domain, true);
      const MapValue value = evaluate_map(exact, Parameter(net.shape.domain, at));
      if (value.determinant != direct_determinant(net, at)) FAIL("det J at " << show(at));
      const auto [px, py] = point_at(net, at);
      if (value.place != Values{px, py}) FAIL("place of " << show(at));
      const Polynomial<Integer> n = jacobian_numerator(exact.net);
      Rational weight = 1;
      if (exact.net.rational()) weight = explicit_value(weight_polynomial(exact.net), at);
      const Rational factor =
          degree_factor(shape) * exact.scale * exact.scale / Rational(numerator_multiple(n.shape));
      if (factor * explicit_value(n, at) != direct_determinant(net, at) * weight * weight * weight) FAIL("N");
      // Intervals contain the same net, up to one factor of all weights.
      const RoundUp up;
      const IntervalNet intervals = interval_net(up, element);
      const auto wi = [&](std::size_t m) {
        return intervals.net.rational() ? intervals.net.weights[m] : Interval(1);
      };
      const auto inside = [](const Interval& interval, const Rational& x) {
        return Rational(interval.inf()) <= x && x <= Rational(interval.sup());
      };
      for (std::size_t m = 0; m < net.x.size(); ++m) {
        if (!inside(intervals.scale * intervals.net.coordinates[0][m] / wi(m), net.x[m] - net.x[0]))
          FAIL("interval x " << m);
        if (!inside(intervals.scale * intervals.net.coordinates[1][m] / wi(m), net.y[m] - net.y[0]))
          FAIL("interval y " << m);
        if (!inside(wi(m) / wi(0), net.weight(m) / net.weight(0))) FAIL("interval weight " << m);
      }
      (element.rational() ? rational : polynomial) += 1;
    }
  }
  CHECK(rational > 30);
  CHECK(polynomial >= 32);
}
