// Contacts of curves where they are known: by construction, in closed form, and by an independent
// elimination.
#include "bezcert/curve/contact.hpp"
#include "random_input.hpp"
#include "rational_polynomial.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// ---- curves
// -------------------------------------------------------------------------------------------------

/// Homogeneous control points as rationals.
using Curve = CurveNet<Rational>;

Curve curve(std::vector<std::array<Rational, 2>> points, std::vector<Rational> weights = {}) {
  Curve c;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rational w = weights.empty() ? Rational(1) : weights[i];
    c.x.push_back(points[i][0] * w);
    c.y.push_back(points[i][1] * w);
    c.w.push_back(w);
  }
  return c;
}

/// Bernstein coefficients of a polynomial over [low, high].
std::vector<Rational> bernstein(const RationalPolynomial& f, int degree, const Rational& low,
                                const Rational& high) {
  RationalPolynomial g;  // f(low + (high - low) t)
  const RationalPolynomial t({low, high - low});
  for (std::size_t k = f.c.size(); k-- > 0;) g = g * t + RationalPolynomial(std::vector<Rational>{f.c[k]});
  std::vector<Rational> result;
  for (int j = 0; j <= degree; ++j) {
    Rational sum = 0, factor = 1;  // C(j, k) / C(degree, k)
    for (int k = 0; k <= j && k < static_cast<int>(g.c.size()); ++k) {
      sum += factor * g.c[static_cast<std::size_t>(k)];
      factor *= Rational(j - k, degree - k > 0 ? degree - k : 1);
    }
    result.push_back(sum);
  }
  return result;
}

/// (x, y)(t) / w(t) for t from low to high, in powers of t.
Curve power_curve(const RationalPolynomial& x, const RationalPolynomial& y, const RationalPolynomial& w,
                  const Rational& low, const Rational& high) {
  const int degree = std::max({x.degree(), y.degree(), w.degree()});
  return {bernstein(x, degree, low, high), bernstein(y, degree, low, high), bernstein(w, degree, low, high)};
}

const RationalPolynomial one({Rational(1)}), T({Rational(0), Rational(1)});

Curve graph(const RationalPolynomial& y, const Rational& low = 0, const Rational& high = 1) {
  return power_curve(T, y, one, low, high);
}

// The unit circle from parameter low to high: ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)).
Curve arc(const Rational& low, const Rational& high) {
  return power_curve(RationalPolynomial({1, 0, -1}), RationalPolynomial({0, 2}),
                     RationalPolynomial({1, 0, 1}), low, high);
}

Curve moved(Curve c, const Rational& dx, const Rational& dy, const Rational& scale = 1) {
  for (std::size_t i = 0; i < c.size(); ++i) {
    c.x[i] = c.x[i] * scale + dx * c.w[i];
    c.y[i] = c.y[i] * scale + dy * c.w[i];
  }
  return c;
}

Curve turned_around(const Curve& c) {
  return {{c.x.rbegin(), c.x.rend()}, {c.y.rbegin(), c.y.rend()}, {c.w.rbegin(), c.w.rend()}};
}

Curve elevated(const Curve& c) {
  const std::size_t n = c.size();  // the new degree
  Curve result;
  for (std::size_t i = 0; i <= n; ++i) {
    const Rational part(static_cast<long>(i), static_cast<long>(n));
    const auto mix = [&](const std::vector<Rational>& v) {
      return Rational((i > 0 ? part * v[i - 1] : Rational(0)) + (i < n ? (1 - part) * v[i] : Rational(0)));
    };
    result.x.push_back(mix(c.x));
    result.y.push_back(mix(c.y));
    result.w.push_back(mix(c.w));
  }
  return result;
}

/// The parameter t of the result belongs to factor t / (1 - t + factor t) of c.
Curve reparametrised(Curve c, const Rational& factor) {
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Rational f = power(factor, static_cast<int>(i));
    c.x[i] *= f;
    c.y[i] *= f;
    c.w[i] *= f;
  }
  return c;
}

DyadicCurve build(const Curve& c, bool with_intervals) {
  std::vector<Rational> all(c.x);
  all.insert(all.end(), c.y.begin(), c.y.end());
  all.insert(all.end(), c.w.begin(), c.w.end());
  Integer scale = 1;
  for (const Rational& x : all) scale = lcm(scale, Integer(denominator(x)));
  CurveNet<Integer> exact;
  const auto fill = [&](const std::vector<Rational>& from, std::vector<Integer>& to) {
    for (const Rational& x : from) to.push_back(Integer(numerator(x)) * (scale / denominator(x)));
  };
  fill(c.x, exact.x);
  fill(c.y, exact.y);
  fill(c.w, exact.w);
  std::optional<CurveNet<Interval>> interval;
  if (with_intervals) {
    interval.emplace();
    for (const Integer& x : exact.x) interval->x.push_back(to_interval(x));
    for (const Integer& x : exact.y) interval->y.push_back(to_interval(x));
    for (const Integer& x : exact.w) interval->w.push_back(to_interval(x));
  }
  return DyadicCurve(std::move(interval), std::move(exact));
}

std::array<Rational, 2> point_at(const Curve& c, const Rational& t) {
  const auto value = [&](std::vector<Rational> v) {
    for (std::size_t level = 1; level < v.size(); ++level) {
      for (std::size_t i = 0; i + level < v.size(); ++i) v[i] = (1 - t) * v[i] + t * v[i + 1];
    }
    return v[0];
  };
  const Rational w = value(c.w);
  return {value(c.x) / w, value(c.y) / w};
}

// ---- what is expected
// ---------------------------------------------------------------------------------------

enum class Kind { none, points, piece };

struct Known {
  double s, t;
};

void check_result(const ContactResult& result, Kind kind, const std::vector<Known>& known, const Curve& a,
                  const Curve& b) {
  CAPTURE(result.exceeded.has_value());
  REQUIRE(result.status == (kind == Kind::none ? ContactStatus::none : ContactStatus::contact));
  if (kind == Kind::none) return;
  REQUIRE(result.contact);
  const Contact& at = *result.contact;
  CAPTURE(at.first.lower, at.first.upper, at.second.lower, at.second.upper);
  for (const ParameterRange& range : {at.first, at.second}) {
    REQUIRE(0 <= range.lower);
    REQUIRE(range.lower <= range.upper);
    REQUIRE(range.upper <= 1);
  }
  if (kind == Kind::points) REQUIRE_FALSE(at.along_a_piece);
  if (at.first.lower == at.first.upper && at.second.lower == at.second.upper) {
    REQUIRE(point_at(a, at.first.lower) == point_at(b, at.second.lower));
  }
  if (known.empty()) return;
  bool found = false;
  for (const Known& k : known) {
    constexpr double slack = 1e-9;
    found |= at.first.lower.convert_to<double>() - slack <= k.s &&
             k.s <= at.first.upper.convert_to<double>() + slack &&
             at.second.lower.convert_to<double>() - slack <= k.t &&
             k.t <= at.second.upper.convert_to<double>() + slack;
  }
  REQUIRE(found);
}

bool same_result(const ContactResult& a, const ContactResult& b) {
  if (a.status != b.status || a.contact.has_value() != b.contact.has_value()) return false;
  if (!a.contact) return true;
  const auto values = [](const Contact& c) {
    return std::array{c.first.lower, c.first.upper, c.second.lower, c.second.upper};
  };
  return values(*a.contact) == values(*b.contact) && a.contact->along_a_piece == b.contact->along_a_piece;
}

ContactResult contact_of(const Curve& a, const Curve& b, Joints joints) {
  DyadicCurve exact_a = build(a, false), exact_b = build(b, false), filtered_a = build(a, true),
              filtered_b = build(b, true);
  ContactResult result = find_contact(filtered_a, filtered_b, joints);
  REQUIRE(same_result(result, find_contact(exact_a, exact_b, joints)));  // the filter only skips work
  return result;
}

/// In all equivalent forms: exchanged, turned around, elevated, reparametrised, scaled and moved.
void check(const std::string& what, const Curve& a, const Curve& b, Kind kind,
           const std::vector<Known>& known = {}, Joints joints = {}) {
  INFO(what);
  const auto one_form = [&](const char* form, const Curve& x, const Curve& y, Joints j, const auto& map_s,
                            const auto& map_t, bool exchanged) {
    INFO(form);
    std::vector<Known> expected;
    for (const Known& k : known) {
      const Known m = {map_s(k.s), map_t(k.t)};
      expected.push_back(exchanged ? Known{m.t, m.s} : m);
    }
    check_result(contact_of(x, y, j), kind, expected, x, y);
  };
  const auto same = [](double t) { return t; };
  const auto reverse = [](double t) { return 1 - t; };
  const Joints back{joints.begin_to_end, joints.end_to_begin};
  one_form("as given", a, b, joints, same, same, false);
  one_form("exchanged", b, a, back, same, same, true);
  one_form("both turned around", turned_around(a), turned_around(b), back, reverse, reverse, false);
  if (!joints.begin_to_end && !joints.end_to_begin) {
    one_form("one turned around", a, turned_around(b), joints, same, reverse, false);
  }
  one_form("elevated", elevated(a), elevated(elevated(b)), joints, same, same, false);
  // t of the new curve belongs to f t / (1 - t + f t): t = x / (f - f x + x) for the old parameter x.
  one_form(
      "reparametrised", reparametrised(a, Rational(3, 5)), reparametrised(b, Rational(7, 2)), joints,
      [](double x) { return x / (0.6 - 0.6 * x + x); }, [](double x) { return x / (3.5 - 3.5 * x + x); },
      false);
  const Rational huge = power(10, 100) / 3;
  one_form("huge", moved(a, huge, -huge, huge), moved(b, huge, -huge, huge), joints, same, same, false);
  one_form("tiny", moved(a, 0, 0, 1 / huge), moved(b, 0, 0, 1 / huge), joints, same, same, false);
  one_form("tiny, far away", moved(a, 7, 9, 1 / power(10, 40)), moved(b, 7, 9, 1 / power(10, 40)), joints,
           same, same, false);
}

const Rational near12 = 1 / power(10, 12), near30 = 1 / power(10, 30);

const RationalPolynomial square_of_t = T * T;

RationalPolynomial constant(const Rational& c) { return RationalPolynomial(std::vector<Rational>{c}); }

}  // namespace

TEST_CASE("transversal contacts at dyadic, rational and irrational parameters") {
  check("lines at 1/2", curve({{0, 0}, {1, 1}}), curve({{0, 1}, {1, 0}}), Kind::points, {{0.5, 0.5}});
  check("lines at 1/3, 1/5", curve({{0, 0}, {3, 0}}), curve({{1, -1}, {1, 4}}), Kind::points,
        {{1.0 / 3, 0.2}});
  // The crossing is at a dyadic parameter of one curve only: halves of that curve never cross the other one
  // strictly.
  check("lines at 1/2, 1/3", curve({{0, 0}, {2, 0}}), curve({{1, -1}, {1, 2}}), Kind::points,
        {{0.5, 1.0 / 3}});
  check("line ends on a line", curve({{0, 0}, {3, 0}}), curve({{1, 4}, {1, 0}}), Kind::points,
        {{1.0 / 3, 1}});
  check("line ends above a line", curve({{0, 0}, {3, 0}}), curve({{1, 4}, {1, near30}}), Kind::none);
  check("line ends below a line", curve({{0, 0}, {3, 0}}), curve({{1, 4}, {1, -near30}}), Kind::points,
        {{1.0 / 3, 1}});
  check("parallel lines", curve({{0, 0}, {3, 0}}), curve({{0, near30}, {3, near30}}), Kind::none);
  check("parabola and line at 1/sqrt 2", graph(square_of_t),
        curve({{0, Rational(1, 2)}, {1, Rational(1, 2)}}), Kind::points, {{std::sqrt(0.5), std::sqrt(0.5)}});
  check("two parabolas, two contacts", graph(square_of_t),
        power_curve(square_of_t, T, one, Rational(-1, 2), 1), Kind::points, {{0, 1.0 / 3}, {1, 1}});
  check("circle and line at 1/sqrt 2", arc(0, 1), curve({{0, 0}, {1, 1}}), Kind::points,
        {{std::sqrt(2) - 1, std::sqrt(0.5)}});
  check("circle and cubic graph", arc(0, 1), graph(T * T * T), Kind::points);
  check("end points meet and are no joint", curve({{0, 0}, {1, 1}}), curve({{1, 1}, {2, 0}}), Kind::points,
        {{1, 0}});
  check("begin and begin", curve({{0, 0}, {1, 1}}), curve({{0, 0}, {2, 0}}), Kind::points, {{0, 0}});
}

TEST_CASE("tangential contacts, and curves that miss each other by little") {
  const RationalPolynomial tangent({Rational(-1, 9), Rational(2, 3)});  // of t^2 at 1/3
  check("parabola and tangent at 1/3", graph(square_of_t), graph(tangent), Kind::points,
        {{1.0 / 3, 1.0 / 3}});
  check("parabola and its lowest point", graph(square_of_t, -1, 1), curve({{-1, 0}, {1, 0}}), Kind::points,
        {{0.5, 0.5}});
  for (const Rational& gap : {near12, near30}) {
    check("parabola above the tangent", graph(square_of_t + constant(gap)), graph(tangent), Kind::none);
    check("parabola below the tangent", graph(square_of_t - constant(gap)), graph(tangent), Kind::points);
    check("parabola above a dyadic tangent", graph(square_of_t + constant(gap), -1, 1),
          curve({{-1, 0}, {1, 0}}), Kind::none);
    check("parabola below a dyadic tangent", graph(square_of_t - constant(gap), -1, 1),
          curve({{-1, 0}, {1, 0}}), Kind::points);
  }
  // (2 t^2 - 1)^2 touches 0 at 1/sqrt 2.
  const RationalPolynomial well = RationalPolynomial({-1, 0, 2}) * RationalPolynomial({-1, 0, 2});
  const double r = std::sqrt(0.5);
  check("irrational tangent", graph(well), curve({{0, 0}, {1, 0}}), Kind::points, {{r, r}});
  check("irrational tangent, another parameter", graph(well), curve({{-1, 0}, {1, 0}}), Kind::points,
        {{r, (1 + r) / 2}});
  check("above", graph(well + constant(near30)), curve({{0, 0}, {1, 0}}), Kind::none);
  check("below", graph(well - constant(near30)), curve({{0, 0}, {1, 0}}), Kind::points, {{r, r}});
  // Order 3 and 4: an inflection crosses, a flat point does not.
  const RationalPolynomial third({Rational(-1, 3), Rational(1)});
  check("inflection", graph(third * third * third), curve({{0, 0}, {1, 0}}), Kind::points,
        {{1.0 / 3, 1.0 / 3}});
  check("flat point", graph(third * third * third * third), curve({{0, 0}, {1, 0}}), Kind::points,
        {{1.0 / 3, 1.0 / 3}});
  check("flat point above", graph(third * third * third * third + constant(near30)), curve({{0, 0}, {1, 0}}),
        Kind::none);
  // Unit circles that touch in (5/13, 12/13), parameter 2/3.
  const auto opposite = [](const Rational& gap) {
    Curve c = moved(arc(0, 1), 0, 0, -1);
    return moved(c, Rational(10, 13) * (1 + gap), Rational(24, 13) * (1 + gap));
  };
  check("circles from outside", arc(0, 1), opposite(0), Kind::points, {{2.0 / 3, 2.0 / 3}});
  for (const Rational& gap : {near12, near30}) {
    check("circles apart", arc(0, 1), opposite(gap), Kind::none);
    check("circles into each other", arc(0, 1), opposite(-gap), Kind::points);
  }
  // From inside, radius 1/2 around (5/26, 12/26).
  check("circles from inside", arc(0, 1), moved(arc(0, 1), Rational(5, 26), Rational(12, 26), Rational(1, 2)),
        Kind::points, {{2.0 / 3, 2.0 / 3}});
  // The tangent ends at the contact.
  check("tangent ends there", graph(square_of_t), graph(tangent, 0, Rational(1, 3)), Kind::points,
        {{1.0 / 3, 1}});
  check("tangent ends before", graph(square_of_t), graph(tangent, 0, Rational(1, 3) - near30), Kind::none);
}

TEST_CASE("joints: neighbours may meet there, and nowhere else") {
  const Joints joined{true, false}, closed{true, true};
  check("corner", curve({{0, 0}, {1, 0}}), curve({{1, 0}, {1, 1}}), Kind::none, {}, joined);
  check("straight on", curve({{0, 0}, {1, 0}}), curve({{1, 0}, {3, 0}}), Kind::none, {}, joined);
  check("back along itself", curve({{0, 0}, {1, 0}}), curve({{1, 0}, {Rational(1, 2), 0}}), Kind::piece, {},
        joined);
  check("back along itself and on", curve({{0, 0}, {1, 0}}), curve({{1, 0}, {-3, 0}}), Kind::piece, {},
        joined);
  // A cusp: back along the tangent, at one side of it.
  const Curve to_origin = curve({{1, 0}, {0, 0}});
  check("cusp of order 2", to_origin, graph(square_of_t), Kind::none, {}, joined);
  check("cusp of order 3", to_origin, graph(square_of_t * T), Kind::none, {}, joined);
  check("cusp of order 5", to_origin, graph(square_of_t * square_of_t * T), Kind::none, {}, joined);
  check("cusp of two parabolas", turned_around(graph(square_of_t)), graph(Rational(2) * square_of_t),
        Kind::none, {}, joined);
  check("cusp of two almost equal parabolas", turned_around(graph(square_of_t)),
        graph((1 + near12) * square_of_t), Kind::none, {}, joined);
  const RationalPolynomial returns({1, -3});
  check("cusp, and a contact at 1/3", to_origin, graph(square_of_t * returns), Kind::points,
        {{2.0 / 3, 1.0 / 3}}, joined);
  check("cusp, and a tangent contact at 1/3", to_origin, graph(square_of_t * returns * returns), Kind::points,
        {{2.0 / 3, 1.0 / 3}}, joined);
  check("cusp, and a near miss at 1/3", to_origin,
        graph(square_of_t * (returns * returns + constant(near12))), Kind::none, {}, joined);
  check("the same cusp is a contact if it is no joint", to_origin, graph(square_of_t), Kind::points,
        {{1, 0}});
  check("circle arcs one after the other", arc(0, Rational(1, 3)), arc(Rational(1, 3), 1), Kind::none, {},
        joined);
  check("smooth joint, then round to the first", arc(-1, 1), curve({{0, 1}, {-2, 1}, {-2, -1}, {0, -1}}),
        Kind::points, {{0, 1}}, joined);
  // Rings.
  const Curve above = curve({{0, 0}, {0, 1}, {1, 1}, {1, 0}}),
              below = curve({{1, 0}, {1, -1}, {0, -1}, {0, 0}});
  check("ring", above, below, Kind::none, {}, closed);
  check("ring of line and arch", above, curve({{1, 0}, {0, 0}}), Kind::none, {}, closed);
  check("ring there and back", above, turned_around(above), Kind::piece, {}, closed);
  check("ring with a cusp at both ends",
        graph(square_of_t * RationalPolynomial({1, -1}) * RationalPolynomial({1, -1})),
        curve({{1, 0}, {0, 0}}), Kind::none, {}, closed);
  // y = t (1 - t) (3 t - 1)^2 touches the line between.
  check("ring that touches at 1/3", graph(T * RationalPolynomial({1, -1}) * returns * returns),
        curve({{1, 0}, {0, 0}}), Kind::points, {{1.0 / 3, 2.0 / 3}}, closed);
  check("ring that crosses at 1/3", graph(T * RationalPolynomial({1, -1}) * returns), curve({{1, 0}, {0, 0}}),
        Kind::points, {{1.0 / 3, 2.0 / 3}}, closed);
}

TEST_CASE("curves that have a piece in common") {
  check("lines", curve({{0, 0}, {2, 0}}), curve({{1, 0}, {3, 0}}), Kind::piece);
  check("line inside a line", curve({{0, 0}, {3, 3}}), curve({{2, 2}, {1, 1}}), Kind::piece);
  check("lines of other speed", curve({{0, 0}, {2, 0}}),
        power_curve(Rational(1, 2) * (T + square_of_t), RationalPolynomial(), one, Rational(1, 3), 3),
        Kind::piece);
  check("lines of other speed, apart", curve({{-2, 0}, {Rational(1, 5), 0}}),
        power_curve(Rational(1, 2) * (T + square_of_t), RationalPolynomial(), one, Rational(1, 3), 3),
        Kind::none);
  check("lines of one line, apart by 1e-30", curve({{0, 0}, {1, 0}}), curve({{1 + near30, 0}, {2, 0}}),
        Kind::none);
  check("lines of one line, touching", curve({{0, 0}, {1, 0}}), curve({{1, 0}, {2, 0}}), Kind::points,
        {{1, 0}});
  check("circle arcs", arc(0, Rational(2, 3)), arc(Rational(1, 3), 1), Kind::piece);
  check("circle arcs, apart", arc(0, Rational(1, 3)), arc(Rational(1, 2), 1), Kind::none);
  check("circle arcs, apart by 1e-30", arc(0, Rational(1, 3)), arc(Rational(1, 3) + near30, 1), Kind::none);
  check("circle arcs, touching", arc(0, Rational(1, 3)), arc(Rational(1, 3), 1), Kind::points, {{1, 0}});
  check("circle arcs, overlapping by 1e-30", arc(0, Rational(1, 3)), arc(Rational(1, 3) - near30, 1),
        Kind::piece);
  // 21 s = 5 + 30 t has no dyadic solution: subdivision meets no common point, and the result tells of the
  // piece.
  const Curve first = curve({{0, 0}, {21, 0}}), second = curve({{5, 0}, {35, 0}});
  check("lines, no dyadic point in common", first, second, Kind::piece);
  for (const ContactResult& result : {contact_of(first, second, {}), contact_of(second, first, {}),
                                      contact_of(arc(0, Rational(21, 35)), arc(Rational(5, 35), 1), {})}) {
    REQUIRE(result.contact);
    CHECK(result.contact->along_a_piece);
  }
  check("parabola and itself", graph(square_of_t), graph(square_of_t), Kind::piece);
  check("cubic and its piece, irrational relation of speeds", graph(square_of_t * T - T),
        elevated(graph(square_of_t * T - T, Rational(1, 3), 5)), Kind::piece);
  // Cubics that agree to second order at 0 and nowhere else.
  check("almost the same", graph(square_of_t), graph(square_of_t + near12 * square_of_t * T), Kind::points,
        {{0, 0}});
}

TEST_CASE("self contacts") {
  const auto check_self = [](const std::string& what, const Curve& c, Kind kind,
                             const std::vector<Known>& known = {}) {
    INFO(what);
    int form = 0;
    const Rational huge = power(10, 90) / 7;
    for (const Curve& x : {c, elevated(c), moved(c, huge, huge, huge), moved(c, 1, 1, 1 / huge)}) {
      CAPTURE(form++);
      DyadicCurve filtered = build(x, true), exact = build(x, false);
      const ContactResult result = self_contact(filtered);
      REQUIRE(same_result(result, self_contact(exact)));
      std::vector<Known> both = known;
      for (const Known& k : known) both.push_back({k.t, k.s});
      check_result(result, kind, both, x, x);
      if (result.contact) {
        // Two parameters, not one.
        REQUIRE((result.contact->first.upper < result.contact->second.lower ||
                 result.contact->second.upper < result.contact->first.lower));
      }
    }
  };
  // (t^2 - c, t (t^2 - c)): a node at t = +- sqrt c.
  const auto nodal = [](long c, const Rational& low, const Rational& high) {
    const RationalPolynomial f({Rational(-c), 0, 1});
    return power_curve(f, T * f, one, low, high);
  };
  check_self("line", curve({{0, 0}, {1, 1}}), Kind::none);
  check_self("line of changing speed", curve({{0, 0}, {1, 1}, {5, 5}}), Kind::none);
  check_self("parabola", graph(square_of_t, -1, 1), Kind::none);
  check_self("arc", arc(-3, 3), Kind::none);
  check_self("loop at dyadic parameters", nodal(1, -2, 2), Kind::points, {{0.25, 0.75}});
  check_self("loop at rational parameters", nodal(1, Rational(-3, 2), Rational(3, 2)), Kind::points,
             {{1.0 / 6, 5.0 / 6}});
  check_self("loop at irrational parameters", nodal(2, -2, 2), Kind::points,
             {{(2 - std::sqrt(2)) / 4, (2 + std::sqrt(2)) / 4}});
  check_self("closed loop", nodal(1, -1, 1), Kind::points, {{0, 1}});
  check_self("loop closed at one end", nodal(1, -1, 2), Kind::points, {{0, 2.0 / 3}});
  check_self("loop open by 1e-12", nodal(1, near12 - 1, 2), Kind::none);
  check_self("loop open by 1e-30", nodal(1, near30 - 1, 2), Kind::none);
  check_self("loop closed by 1e-30", nodal(1, -near30 - 1, 2), Kind::points, {{0, 2.0 / 3}});
  check_self("half of the loop", nodal(1, Rational(-1, 2), 5), Kind::none);
  check_self("closed square-like curve", curve({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}), Kind::points,
             {{0, 1}});
  // x = t^2, y = t ((t^2 - 1)^2 + gap): two branches +- sqrt x ((x - 1)^2 + gap) that touch at t = +- 1.
  const auto tacnode = [](const Rational& gap) {
    const RationalPolynomial f({-1, 0, 1});
    return power_curve(square_of_t, T * (f * f + constant(gap)), one, Rational(-3, 2), Rational(3, 2));
  };
  check_self("touches itself", tacnode(0), Kind::points, {{1.0 / 6, 5.0 / 6}});
  for (const Rational& gap : {near12, near30}) {
    check_self("misses itself", tacnode(gap), Kind::none);
    check_self("meets itself twice", tacnode(-gap), Kind::points);
  }
  // A full circle as a closed rational quartic: (1 - t^2)^2 - 4 t^2 ... with t from -1 to 1 the angle 4 atan
  // t runs once.
  const RationalPolynomial c1({1, 0, -1}), s1({0, 2}), w1({1, 0, 1});
  const auto circle = [&](const Rational& low, const Rational& high) {
    return power_curve(c1 * c1 - s1 * s1, Rational(2) * c1 * s1, w1 * w1, low, high);
  };
  check_self("full circle", circle(-1, 1), Kind::points, {{0, 1}});
  check_self("almost a full circle", circle(-1, 1 - near12), Kind::none);
  check_self("a circle and a bit", circle(-1, Rational(3, 2)), Kind::piece);
}

namespace {

// ---- an independent elimination
// -----------------------------------------------------------------------------

struct Powers {
  RationalPolynomial x, y, w;
};

RationalPolynomial powers_of(const std::vector<Rational>& bernstein) {
  const int n = static_cast<int>(bernstein.size()) - 1;
  RationalPolynomial sum;
  const RationalPolynomial rest({1, -1});
  Rational binomial = 1;
  for (int k = 0; k <= n; ++k) {
    RationalPolynomial term = constant(binomial * bernstein[static_cast<std::size_t>(k)]);
    for (int i = 0; i < k; ++i) term = term * T;
    for (int i = k; i < n; ++i) term = term * rest;
    sum = sum + term;
    binomial = binomial * Rational(n - k) / Rational(k + 1);
  }
  return sum;
}

Rational determinant(std::vector<std::vector<Rational>> rows) {
  Rational result = 1;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    std::size_t pivot = c;
    while (pivot < rows.size() && rows[pivot][c].is_zero()) ++pivot;
    if (pivot == rows.size()) return 0;
    if (pivot != c) {
      std::swap(rows[pivot], rows[c]);
      result = -result;
    }
    result *= rows[c][c];
    for (std::size_t r = c + 1; r < rows.size(); ++r) {
      if (rows[r][c].is_zero()) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < rows.size(); ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  return result;
}

// The resultant in s of X1(s) W2(t) - X2(t) W1(s) and the same with Y, by t: interpolated (Newton).
RationalPolynomial resultant(const Powers& a, const Powers& b, int degree_a, int degree_b) {
  const int points = 2 * degree_a * degree_b + 1;
  std::vector<Rational> at, table;
  for (int k = 0; k < points; ++k) {
    const Rational s(k - points / 2);
    at.push_back(s);
    const RationalPolynomial f = a.x(s) * b.w - a.w(s) * b.x, g = a.y(s) * b.w - a.w(s) * b.y;
    const auto n = static_cast<std::size_t>(degree_b);
    std::vector<std::vector<Rational>> rows(2 * n, std::vector<Rational>(2 * n, 0));
    for (std::size_t shift = 0; shift < n; ++shift) {
      for (std::size_t i = 0; i < f.c.size(); ++i) rows[shift][shift + n - i] = f.c[i];
      for (std::size_t i = 0; i < g.c.size(); ++i) rows[n + shift][shift + n - i] = g.c[i];
    }
    table.push_back(determinant(std::move(rows)));
  }
  for (std::size_t level = 1; level < table.size(); ++level) {
    for (std::size_t i = table.size(); i-- > level;)
      table[i] = (table[i] - table[i - 1]) / (at[i] - at[i - level]);
  }
  RationalPolynomial result;
  for (std::size_t i = table.size(); i-- > 0;) {
    result = result * (T - constant(at[i])) + constant(table[i]);
  }
  return result;
}

// The roots in [0, 1], each to within 2^-100.
std::vector<Rational> roots_of(const RationalPolynomial& f) {
  std::vector<Rational> result;
  const RationalPolynomial simple = without_multiple_roots(f);
  std::vector<std::pair<Rational, Rational>> open = {{0, 1}};
  if (simple(0).is_zero()) result.push_back(0);
  if (simple(1).is_zero()) result.push_back(1);
  while (!open.empty()) {
    auto [low, high] = open.back();
    open.pop_back();
    int inside =
        count_roots(simple, low, high) - (simple(low).is_zero() ? 1 : 0) - (simple(high).is_zero() ? 1 : 0);
    if (inside == 0) continue;
    if (inside == 1 && !simple(low).is_zero() && !simple(high).is_zero()) {
      while (high - low > power_of_two(-100)) {
        const Rational middle = (low + high) / 2;
        const int s = sign(simple(middle));
        if (s == 0)
          low = high = middle;
        else if (s == sign(simple(low)))
          low = middle;
        else
          high = middle;
      }
      result.push_back((low + high) / 2);
      continue;
    }
    const Rational middle = (low + high) / 2;
    if (simple(middle).is_zero()) result.push_back(middle);
    open.push_back({low, middle});
    open.push_back({middle, high});
  }
  return result;
}

struct RandomCurve {
  Curve curve;
  int degree = 1;
};

// A line, parabola, rational conic or cubic with small integers, injective and without a vanishing
// derivative.
RandomCurve random_curve(Random& random) {
  for (;;) {
    const int degree = static_cast<int>(random.integer(1, 3));
    std::vector<std::array<Rational, 2>> points;
    for (int k = 0; k <= degree; ++k)
      points.push_back({Rational(random.integer(-3, 3)), Rational(random.integer(-3, 3))});
    const auto cross = [&](int i, int j, int k) {
      return Rational((points[j][0] - points[i][0]) * (points[k][1] - points[i][1]) -
                      (points[k][0] - points[i][0]) * (points[j][1] - points[i][1]));
    };
    if (degree == 1 && points[0] == points[1]) continue;
    if (degree == 2 && cross(0, 1, 2).is_zero()) continue;
    if (degree == 3) {
      // Convex control polygons of one orientation: no loop, no cusp, no point where the derivative vanishes,
      // if also the end tangents turn by less than half a turn in all: all control vectors in an open half
      // plane in order.
      const Rational a = cross(0, 1, 2), b = cross(1, 2, 3);
      const auto along = [&](int i, int j) {
        return Rational((points[i + 1][0] - points[i][0]) * (points[j + 1][0] - points[j][0]) +
                        (points[i + 1][1] - points[i][1]) * (points[j + 1][1] - points[j][1]));
      };
      if (a.is_zero() || b.is_zero() || along(0, 1) <= 0 || along(1, 2) <= 0 || along(0, 2) <= 0) continue;
    }
    std::vector<Rational> weights;
    if (degree == 2 && random.chance(60)) {
      for (int k = 0; k <= 2; ++k) weights.emplace_back(random.integer(1, 4));
    }
    return {curve(points, weights), degree};
  }
}

}  // namespace

TEST_CASE("random curves against an independent elimination") {
  const std::uint64_t seed = seed_or(141);
  Random random(seed);
  int contacts = 0, none = 0, tangent = 0, tangent_contacts = 0, joined = 0, joined_contacts = 0, shared = 0,
      by_algebra = 0;
  for (int i = 0; i < 1500; ++i) {
    RandomCurve a = random_curve(random), b = random_curve(random);
    Joints joints;
    bool touching = false, meets = false;
    const long choice = random.integer(0, 3);
    const Rational s0(random.integer(0, 7), 7), t0(random.integer(0, 6), 6);
    if (choice == 1) {  // through one point at rational parameters
      const auto p = point_at(a.curve, s0), q = point_at(b.curve, t0);
      b.curve = moved(b.curve, p[0] - q[0], p[1] - q[1]);
      meets = true;
    } else if (choice == 2) {  // a joint
      const auto p = point_at(a.curve, 1), q = point_at(b.curve, 0);
      b.curve = moved(b.curve, p[0] - q[0], p[1] - q[1]);
      joints.end_to_begin = true;
      ++joined;
    } else if (choice == 3 && a.degree > 1) {  // the tangent, as a line or bent to either side
      const Powers p = {powers_of(a.curve.x), powers_of(a.curve.y), powers_of(a.curve.w)};
      const Rational dx = slope(p.x)(s0) * p.w(s0) - p.x(s0) * slope(p.w)(s0),
                     dy = slope(p.y)(s0) * p.w(s0) - p.y(s0) * slope(p.w)(s0);
      const auto at = point_at(a.curve, s0);
      const RationalPolynomial t({-t0, 1});
      const Rational bend(random.integer(-2, 2), 3);
      b.curve = power_curve(constant(at[0]) + dx * t - (bend * dy) * t * t,
                            constant(at[1]) + dy * t + (bend * dx) * t * t, one, 0, 1);
      b.degree = static_cast<int>(b.curve.size()) - 1;
      touching = meets = true;
      ++tangent;
    }
    const Powers pa = {powers_of(a.curve.x), powers_of(a.curve.y), powers_of(a.curve.w)},
                 pb = {powers_of(b.curve.x), powers_of(b.curve.y), powers_of(b.curve.w)};
    INFO("seed " << seed << " case " << i << " choice " << choice);
    for (const Curve* c : {&a.curve, &b.curve}) {
      std::string text;
      for (std::size_t k = 0; k < c->size(); ++k) {
        text += "(" + to_string(c->x[k]) + "," + to_string(c->y[k]) + "," + to_string(c->w[k]) + ") ";
      }
      UNSCOPED_INFO(text);
    }
    const ContactResult result = contact_of(a.curve, b.curve, joints);
    REQUIRE(result.status != ContactStatus::open);
    const RationalPolynomial in_s = resultant(pa, pb, a.degree, b.degree),
                             in_t = resultant(pb, pa, b.degree, a.degree);
    REQUIRE(in_s.is_zero() == in_t.is_zero());
    if (in_s.is_zero()) {  // on one line or conic: contacts are not isolated
      ++shared;
      if (meets) REQUIRE(result.status == ContactStatus::contact);
      continue;
    }
    std::vector<Known> expected;
    for (const Rational& s : roots_of(in_s)) {
      for (const Rational& t : roots_of(in_t)) {
        if (joints.end_to_begin && 1 - s < power_of_two(-90) && t < power_of_two(-90)) continue;
        const auto p = point_at(a.curve, s), q = point_at(b.curve, t);
        if (abs(p[0] - q[0]) < power_of_two(-60) && abs(p[1] - q[1]) < power_of_two(-60)) {
          expected.push_back({s.convert_to<double>(), t.convert_to<double>()});
        }
      }
    }
    if (meets) REQUIRE_FALSE(expected.empty());
    check_result(result, expected.empty() ? Kind::none : Kind::points, expected, a.curve, b.curve);
    (expected.empty() ? none : contacts) += 1;
    if (touching && !expected.empty()) ++tangent_contacts;
    if (joints.end_to_begin && !expected.empty()) ++joined_contacts;
    if (result.contact && result.contact->first.upper - result.contact->first.lower == 0) ++by_algebra;
  }
  INFO("seed " << seed << " contacts " << contacts << " none " << none << " tangent " << tangent << " joined "
               << joined << " with contacts " << joined_contacts << " shared " << shared << " exact "
               << by_algebra);
  CHECK(contacts > 400);
  CHECK(none > 300);
  CHECK(tangent_contacts > 100);
  CHECK(joined > 200);
  CHECK(joined_contacts > 20);
  CHECK(shared > 3);
}

TEST_CASE("random cubics: self contacts in closed form") {
  // (c(s) - c(t)) / (s - t) = A3 (s^2 + s t + t^2) + A2 (s + t) + A1 = 0 is linear in q = s^2 + s t + t^2 and
  // p = s + t.
  const std::uint64_t seed = seed_or(142);
  Random random(seed);
  int loops = 0, simple = 0, at_end = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<std::array<Rational, 2>> points;
    for (int k = 0; k < 4; ++k)
      points.push_back({Rational(random.integer(-3, 3)), Rational(random.integer(-3, 3))});
    if (random.chance(10)) points[3] = points[0];
    const Curve c = curve(points);
    const RationalPolynomial x = powers_of(c.x), y = powers_of(c.y);
    const auto at = [](const RationalPolynomial& f, std::size_t k) {
      return k < f.c.size() ? f.c[k] : Rational(0);
    };
    const auto cross = [&](std::size_t j, std::size_t k) {
      return Rational(at(x, j) * at(y, k) - at(y, j) * at(x, k));
    };
    const RationalPolynomial common = common_divisor(slope(x), slope(y));
    if (common.is_zero() || count_roots(common, 0, 1) > 0) continue;  // the derivative vanishes
    bool expected = false;
    double s = 0, t = 0;
    if (!cross(3, 2).is_zero()) {
      const Rational p = -cross(3, 1) / cross(3, 2);
      const Rational q = cross(2, 1) / cross(3, 2);  // A3 q + A2 p + A1 = 0, crossed with A2
      const Rational product = p * p - q, discriminant = p * p - 4 * product;
      expected = discriminant > 0 && product >= 0 && 1 - p + product >= 0 && p > 0 && p < 2;
      if (expected) {
        const double root = std::sqrt(discriminant.convert_to<double>());
        s = (p.convert_to<double>() - root) / 2;
        t = (p.convert_to<double>() + root) / 2;
        if (product.is_zero() || (1 - p + product).is_zero()) ++at_end;
      }
    }
    std::string text;
    for (const auto& [a, b] : points) text += "(" + to_string(a) + "," + to_string(b) + ") ";
    INFO("seed " << seed << " case " << i << " " << text);
    DyadicCurve filtered = build(c, true), exact = build(c, false);
    const ContactResult result = self_contact(filtered);
    REQUIRE(same_result(result, self_contact(exact)));
    check_result(result, expected ? Kind::points : Kind::none, {{s, t}, {t, s}}, c, c);
    (expected ? loops : simple) += 1;
  }
  INFO("seed " << seed << " loops " << loops << " simple " << simple << " at an end " << at_end);
  CHECK(loops > 100);
  CHECK(simple > 2000);
  CHECK(at_end > 30);
}

TEST_CASE("a budget that is too small is open, never a guess") {
  const Curve parabola = graph(square_of_t),
              tangent = graph(RationalPolynomial({Rational(-1, 9), Rational(2, 3)}));
  DyadicCurve a = build(parabola, true), b = build(tangent, true);
  ContactBudget budget;
  budget.algebra_bits = 1;
  const ContactResult result = find_contact(a, b, {}, budget);
  CHECK(result.status == ContactStatus::open);
  CHECK(result.exceeded);
  CHECK_FALSE(result.contact);
  // Algebra alone, after a single pair.
  budget.algebra_bits = std::size_t{1} << 25;
  budget.pairs = 1;
  DyadicCurve c = build(parabola, true), d = build(tangent, true);
  check_result(find_contact(c, d, {}, budget), Kind::points, {{1.0 / 3, 1.0 / 3}}, parabola, tangent);
}
