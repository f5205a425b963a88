// element.hpp, net.hpp and forms.hpp: what an element accepts, and the number forms of its control net.
#include "element/random_net.hpp"

#include "bezcert/element/forms.hpp"
#include "bezcert/element/net.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace bezcert;
using namespace bezcert::test;

namespace {

using Doubles = std::vector<double>;

/// The message of the exception that a constructor throws; "" if it throws none.
std::string refusal(Shape shape, const Doubles& x, const Doubles& y, const Doubles& w = {},
                    Basis basis = Basis::bernstein) {
  try {
    const Element element(shape, basis, {ExactVector(x), ExactVector(y)}, ExactVector(w));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& message, std::initializer_list<const char*> words) {
  for (const char* word : words) {
    if (message.find(word) == std::string::npos) return false;
  }
  return true;
}

bool inside(const Interval& interval, const Rational& x) {
  return Rational(interval.inf()) <= x && x <= Rational(interval.sup());
}

}  // namespace

TEST_CASE("an element refuses what is none, and says why") {
  const Shape triangle = Shape::triangle(1);
  const Doubles three{0, 1, 2};
  REQUIRE(refusal(triangle, three, three).empty());
  REQUIRE(refusal(triangle, three, three, {1, 2, 3}).empty());

  CHECK(says(refusal(Shape::segment(2), three, three), {"segment"}));
  CHECK(says(refusal(Shape::triangle(0), {0}, {0}), {"degree", "at least 1"}));
  CHECK(says(refusal(Shape::triangle(-1), {}, {}), {"degree", "at least 1"}));
  CHECK(says(refusal(Shape::square(0, 1), {0, 1}, {0, 1}), {"degree", "at least 1"}));
  CHECK(says(refusal(Shape::square(1, 0), {0, 1}, {0, 1}), {"degree", "at least 1"}));
  CHECK(says(refusal(Shape::square(-2, -2), {1}, {1}), {"degree", "at least 1"}));

  const std::string limit = std::to_string(max_degree);
  const auto zeros = [](Shape shape) { return Doubles(coefficient_count(shape)); };
  for (const Shape too_high : {Shape::triangle(max_degree + 1), Shape::square(max_degree + 1, 1),
                               Shape::square(1, max_degree + 1)}) {
    INFO(show(too_high));
    CHECK(says(refusal(too_high, zeros(too_high), zeros(too_high)), {"degree", limit.c_str()}));
  }
  CHECK(refusal(Shape::square(max_degree, 1), Doubles(2 * max_degree + 2), Doubles(2 * max_degree + 2))
            .empty());

  CHECK(says(refusal(triangle, {0, 1}, three), {"3 points", "2"}));
  CHECK(says(refusal(triangle, three, {0, 1, 2, 3}), {"3 points", "4"}));
  CHECK(says(refusal(Shape::square(1, 2), three, three), {"6 points", "3"}));
  CHECK(says(refusal(triangle, three, three, {1, 1}), {"3 weights", "2"}));
  CHECK(says(refusal(triangle, three, three, {1, 1, 1, 1}), {"3 weights", "4"}));

  CHECK(says(refusal(triangle, three, three, {1, 0, 1}), {"weight 2", "0", "positive"}));
  CHECK(says(refusal(triangle, three, three, {1, 1, -1}), {"weight 3", "-1", "positive"}));
  CHECK(says(refusal(triangle, three, three, {-0.5, 1, 1}), {"weight 1", "-1/2", "positive"}));
}

TEST_CASE("an element given by nodes refuses weights that are not positive as a control net") {
  const Shape quadratic = Shape::triangle(2);
  const Doubles six(6);
  // The middle control weight of the first edge is 2 w_1 - (w_0 + w_2) / 2.
  CHECK(refusal(quadratic, six, six, {1, 0.51, 1, 1, 1, 1}, Basis::lagrange).empty());
  CHECK(
      says(refusal(quadratic, six, six, {1, 0.5, 1, 1, 1, 1}, Basis::lagrange), {"weight", "2", "positive"}));
  CHECK(says(refusal(quadratic, six, six, {1, 0.25, 1, 1, 1, 1}, Basis::lagrange),
             {"weight", "2", "positive"}));
  CHECK(says(refusal(quadratic, six, six, {1, 1, 1, 1, 0.25, 1}, Basis::lagrange),
             {"weight", "5", "positive"}));
  CHECK(refusal(quadratic, six, six, {1, 0.25, 1, 1, 1, 1}, Basis::bernstein).empty());
  CHECK(says(refusal(quadratic, six, six, {1, 1, 1, 1, 1, 0}, Basis::lagrange), {"weight", "6", "positive"}));
}

TEST_CASE("a triangle has no second degree") {
  const Doubles three{0, 1, 2};
  const std::string message = refusal({Domain::triangle, 1, 1}, three, three);
  // Either refused, or kept as the shape it is: q is 0 for triangles (shape.hpp).
  if (message.empty()) {
    const Element element({Domain::triangle, 1, 1}, Basis::bernstein,
                          {ExactVector(three), ExactVector(three)});
    CHECK(element.shape() == Shape::triangle(1));
  }
}

TEST_CASE("an element keeps what it was given and names itself") {
  const ControlNet net = identity_net(Shape::square(2, 3));
  const Element quad = bernstein_element(net);
  CHECK(quad.shape() == Shape::square(2, 3));
  CHECK(quad.basis() == Basis::bernstein);
  CHECK_FALSE(quad.is_triangle());
  CHECK_FALSE(quad.rational());
  CHECK(quad.weights().empty());
  CHECK(quad.degree() == 3);
  CHECK(kind_name(quad) == "quadrilateral");
  CHECK(degree_name(quad) == "2x3");
  for (std::size_t m = 0; m < net.x.size(); ++m) {
    CHECK(quad.coordinates()[0][m] == net.x[m]);
    CHECK(quad.coordinates()[1][m] == net.y[m]);
  }
  const Element wide = bernstein_element(identity_net(Shape::square(4, 1)));
  CHECK(wide.degree() == 4);
  CHECK(degree_name(wide) == "4x1");
  CHECK(degree_name(bernstein_element(identity_net(Shape::square(3, 3)))) == "3");
  const Element triangle = bernstein_element(identity_net(Shape::triangle(3)));
  CHECK(triangle.is_triangle());
  CHECK(triangle.degree() == 3);
  CHECK(kind_name(triangle) == "triangle");
  CHECK(degree_name(triangle) == "3");
}

TEST_CASE("an element is rational exactly when its weights differ") {
  ControlNet net = identity_net(Shape::triangle(2));
  net.w.assign(6, Rational(1, 3));
  const Element equal = bernstein_element(net);
  CHECK_FALSE(equal.rational());
  CHECK(equal.weights().size() == 6);
  net.w[5] = Rational(1, 3) + Rational(1) / Rational(Integer(1) << 200);
  CHECK(bernstein_element(net).rational());
}

TEST_CASE("the integer net is the element relative to its first point, the interval net contains it") {
  const std::uint64_t seed = seed_or(321);
  Random random(seed);
  long rational = 0, polynomial = 0;
  for (const Shape shape : element_shapes(5, 3)) {
    for (const Points points : all_points) {
      for (const Weights weights : all_weights) {
        const ControlNet net = random_net(random, shape, points, weights);
        const Element element = bernstein_element(net);
        const ExactNet exact = exact_net(element);
        INFO("seed " << seed << ", " << show(net));
        if (exact.scale <= 0) FAIL("scale");
        if (exact.net.shape != shape || exact.net.rational() != element.rational()) FAIL("shape or weights");
        const RoundUp up;
        const IntervalNet intervals = interval_net(up, element);
        if (certain_sign(intervals.scale) != 1) FAIL("interval scale");
        if (intervals.net.shape != shape || intervals.net.rational() != element.rational())
          FAIL("interval form");
        const auto w = [&](std::size_t m) {
          return element.rational() ? Rational(exact.net.weights[m]) : Rational(1);
        };
        const auto wi = [&](std::size_t m) {
          return element.rational() ? intervals.net.weights[m] : Interval(1);
        };
        for (std::size_t m = 0; m < net.x.size(); ++m) {
          const Rational x = net.x[m] - net.x[0];
          const Rational y = net.y[m] - net.y[0];
          if (exact.scale * Rational(exact.net.coordinates[0][m]) != w(m) * x) FAIL("x of point " << m);
          if (exact.scale * Rational(exact.net.coordinates[1][m]) != w(m) * y) FAIL("y of point " << m);
          if (w(m) <= 0) FAIL("weight " << m << " not positive");
          if (!inside(intervals.scale * intervals.net.coordinates[0][m] / wi(m), x))
            FAIL("interval x of point " << m);
          if (!inside(intervals.scale * intervals.net.coordinates[1][m] / wi(m), y))
            FAIL("interval y of point " << m);
          if (!element.rational()) continue;
          if (w(m) * net.w[0] != w(0) * net.w[m]) FAIL("weight " << m);
          if (!inside(wi(m) / wi(0), net.w[m] / net.w[0])) FAIL("interval weight " << m);
        }
        (element.rational() ? rational : polynomial) += 1;
      }
    }
  }
  CHECK(rational > 14 * 4 * 2);
  CHECK(polynomial >= 14 * 4 * 2);
}

TEST_CASE("orientations of control points have the sign of the triangle's area, filter on or off") {
  const std::uint64_t seed = seed_or(322);
  Random random(seed);
  long seen[3] = {}, rational = 0, exact_was_needed = 0, filter_sufficed = 0;
  for (int i = 0; i < 1500; ++i) {
    const Shape shape = random.chance(50) ? Shape::triangle(3) : Shape::square(2, 2);
    const Points points = random_points(random);
    const ControlNet net = random_net(random, shape, points, random_weights(random));
    const Element element = bernstein_element(net);
    const long last = static_cast<long>(net.x.size()) - 1;
    const auto a = static_cast<std::size_t>(random.integer(0, last));
    const auto b = static_cast<std::size_t>(random.integer(0, last));
    const auto c = static_cast<std::size_t>(random.integer(0, last));
    const Rational area =
        (net.x[b] - net.x[a]) * (net.y[c] - net.y[a]) - (net.x[c] - net.x[a]) * (net.y[b] - net.y[a]);
    const Forms on(element, Filter::on);
    const Forms off(element, Filter::off);
    const auto expression = [=](const auto& form) { return orientation(form, a, b, c); };
    INFO("seed " << seed << ", points " << a << " " << b << " " << c << " of " << show(net));
    if (on.sign_of(expression) != area.sign()) FAIL("filter on");
    if (off.sign_of(expression) != area.sign()) FAIL("filter off");
    if (!off.went_exact()) FAIL("filter off did not go exact");
    // A positive multiple: of 2 area, by w_a w_b w_c and the scale.
    const Net<Integer>& integers = off.exact().net;
    Rational multiple = 1 / (off.exact().scale * off.exact().scale);
    if (integers.rational())
      multiple *= Rational(Integer(integers.weights[a] * integers.weights[b] * integers.weights[c]));
    if (Rational(orientation(integers, a, b, c)) != area * multiple) FAIL("multiple of the area");
    ++seen[area.sign() + 1];
    rational += element.rational();
    (on.went_exact() ? exact_was_needed : filter_sufficed) += 1;
  }
  for (const long count : seen) CHECK(count > 200);
  CHECK(rational > 500);
  CHECK(exact_was_needed > 20);
  CHECK(filter_sufficed > 700);
}

TEST_CASE("forms compute the numerator and weight of their element once") {
  const std::uint64_t seed = seed_or(323);
  Random random(seed);
  for (const Weights weights : all_weights) {
    const ControlNet net = random_net(random, Shape::triangle(3), Points::fractions, weights);
    const Element element = bernstein_element(net);
    const Forms forms(element);
    CHECK(&forms.element() == &element);
    CHECK(forms.filter() == Filter::on);
    CHECK_FALSE(forms.went_exact());
    CHECK(forms.interval_jacobian(RoundUp()).numerator.shape ==
          numerator_shape(net.shape, element.rational()));
    CHECK_FALSE(forms.went_exact());
    CHECK(forms.exact_jacobian().numerator.coefficients ==
          jacobian_numerator(exact_net(element).net).coefficients);
    CHECK(forms.exact_jacobian().weight.coefficients ==
          weight_polynomial(exact_net(element).net).coefficients);
    CHECK(forms.went_exact());
    CHECK(&forms.exact_jacobian() == &forms.exact_jacobian());
    CHECK(&forms.interval_jacobian(RoundUp()) == &forms.interval_jacobian(RoundUp()));
  }
}
