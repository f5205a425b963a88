// Edges as Bezier curves. SELF and PAIR show by signs of control points that they do not meet; MEET shows
// that they do: by equal points, by divisibility, or by Poincare-Miranda.
#include "pair_rules.hpp"

#include <algorithm>

namespace verifier {

using Integers = std::vector<mpz_class>;

mpz_class choose(std::size_t n, std::size_t k) {
  mpz_class value;
  mpz_bin_uiui(value.get_mpz_t(), n, k);
  return value;
}

mpq_class fraction(const mpz_class& a, const mpz_class& b) {
  mpq_class value(a, b);
  value.canonicalize();
  return value;
}

namespace {

/// From values at 0, 1/d, ..., 1 to Bernstein coefficients, times a number that depends on d only: Newton's
/// formula in d t, powers of d t, of t, and 1 = (1 - t) + t put in.
void to_bernstein(Integers& c) {
  const std::size_t d = c.size() - 1;
  mpz_class common = 1;
  differences(c);
  newton_to_power(c, static_cast<int>(d), static_cast<int>(d));
  for (std::size_t k = 0; k <= d; ++k) common = lcm(common, choose(d, k));
  shear(c);
  for (std::size_t k = 0; k <= d; ++k) c[k] *= common / choose(d, k);
}

/// The derivative at the begin, times a positive number that depends on the size of c only.
mpz_class slope(Integers c, bool lagrange) {
  if (!lagrange) return c[1] - c[0];
  differences(c);
  mpz_class sum, common = 1;
  for (unsigned long k = 1; k < c.size(); ++k) common = lcm(common, mpz_class(k));
  for (unsigned long k = 1; k < c.size(); ++k) k % 2 ? sum += common / k * c[k] : sum -= common / k * c[k];
  return sum;
}

Polynomial power_basis(Integers c) {
  differences(c);
  for (std::size_t k = 0; k < c.size(); ++k) c[k] *= choose(c.size() - 1, k);
  trim(c);
  return c;
}

std::size_t size_of(const Point& p) {
  return limbs({p[0].get_num(), p[0].get_den(), p[1].get_num(), p[1].get_den()});
}

/// The curve from one parameter to another.
Curve part(Curve curve, const mpq_class& low, const mpq_class& high) {
  const std::size_t d = curve.x.size() - 1, size = size_of({low, high});
  for (const auto f : coordinates) {
    spend(2 * d * d * product_work(limbs(curve.*f) + d * size, size));
    curve.*f = bernstein(power_basis(curve.*f), static_cast<int>(d), low, high);
    for (std::size_t k = 0; k <= d; ++k) (curve.*f)[k] /= choose(d, k);  // exact
  }
  return curve;
}

/// n . P for the control points P.
std::vector<mpq_class> heights(const Curve& c, const Point& n) {
  const std::size_t size = limbs(c.x) + limbs(c.y) + limbs(c.w) + size_of(n);
  spend(8 * c.x.size() * product_work(size, size));
  std::vector<mpq_class> all;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    const Point p = control_point(c, i);
    all.push_back(n[0] * p[0] + n[1] * p[1]);
  }
  return all;
}

mpq_class least(const std::vector<mpq_class>& z) { return *std::min_element(z.begin(), z.end()); }
mpq_class greatest(const std::vector<mpq_class>& z) { return *std::max_element(z.begin(), z.end()); }

/// f_a(s) w_b(t) - f_b(t) w_a(s), s for u and t for v: the F or G of `r` and `root`.
Polynomial2 difference(const Curve& a, const Curve& b, Integers Curve::*f) {
  const auto in_t = [](const Integers& c) {
    Polynomial2 rows;
    for (const mpz_class& z : power_basis(c)) rows.push_back({z});
    trim(rows);
    return rows;
  };
  return Polynomial2{power_basis(a.*f)} * in_t(b.w) - Polynomial2{power_basis(a.w)} * in_t(b.*f);
}

Integers bernstein_on(const Polynomial& f, const mpq_class& low, const mpq_class& high) {
  return bernstein(f, f.empty() ? 0 : static_cast<int>(f.size()) - 1, low, high);
}

bool one_strict_sign(const Integers& c) {
  return std::all_of(c.begin(), c.end(), [&](const mpz_class& z) { return sgn(z) * sgn(c[0]) > 0; });
}

void rule_r(const Curve& a, const Curve& b, bool joint) {
  const Polynomial2 f = difference(a, b, &Curve::x), g = difference(a, b, &Curve::y);
  // In the degree that b has, perhaps less than the formal one, in which R would be 0. At least 1, so that
  // R = A F + B G.
  const int n = std::max({2, static_cast<int>(f.size()), static_cast<int>(g.size())}) - 1;
  Polynomial r = resultant(f, n, g, n);
  require(!r.empty(), "r: the resultant is 0");
  if (joint) r.erase(r.begin(), std::find_if(r.begin(), r.end(), [](const mpz_class& z) { return z != 0; }));
  require(one_strict_sign(bernstein_on(r, 0, 1)), "r: the resultant has not one sign");
}

void check_depth(int depth) {
  if (depth > 512) throw Malformed{"limit: more than 512 halvings"};
}

Point direction(Tokens& tokens) {
  const mpz_class x = tokens.integer(), y = tokens.integer();
  return {x, y};
}

void check_self(Tokens& tokens, const Curve& curve, int depth = 0) {
  check_depth(depth);
  if (tokens.accept("h")) {
    const auto half = halves(curve);
    for (const Curve& c : half) check_self(tokens, c, depth + 1);
    check_pair(tokens, half[0], half[1], {true, false}, depth + 1);
  } else if (tokens.accept("m")) {
    const auto h = heights(curve, direction(tokens));
    require(std::adjacent_find(h.begin(), h.end(), std::greater_equal<>()) == h.end(), "m: not increasing");
  } else {
    throw Malformed{"expected a rule for one piece"};
  }
}

void check_cross(const Curve& a, const Curve& b) {
  const Point d = point(a, 1) - point(a, 0), e{-d[1], d[0]};
  require(d != Point{}, "cross: d = 0");  // all below would hold
  const auto between = [](const std::vector<mpq_class>& inner, const mpq_class& low, const mpq_class& high) {
    return low <= least(inner) && greatest(inner) <= high;
  };
  const auto a_d = heights(a, d), b_d = heights(b, d), a_e = heights(a, e), b_e = heights(b, e);
  require(between(b_d, a_d.front(), a_d.back()), "cross: the second piece passes an end of the first");
  require(between(a_e, b_e.front(), b_e.back()) || between(a_e, b_e.back(), b_e.front()),
          "cross: the first piece passes an end of the second");
}

}  // namespace

Curve edge_curve(const Element& element, int e) {
  if (e < 0 || e >= (element.triangle ? 3 : 4)) throw Malformed{"the element has no such edge"};
  Curve c;
  for (const std::size_t i : edge_positions(element, e)) {
    c.x.push_back(element.x[i] * element.w[i]);
    c.y.push_back(element.y[i] * element.w[i]);
    c.w.push_back(element.unit * element.w[i]);
  }
  if (element.lagrange)
    for (const auto f : coordinates) to_bernstein(c.*f);
  for (const mpz_class& w : c.w)
    if (w <= 0) throw Malformed{"a control weight is not positive"};
  return c;
}

std::vector<Curve> edge_curves(const Element& element) {
  std::vector<Curve> edges;
  for (int e = 0; e < (element.triangle ? 3 : 4); ++e) edges.push_back(edge_curve(element, e));
  return edges;
}

int first_direction(const Element& element, const std::vector<std::size_t>& places, int axis) {
  Integers z, w;  // direction of (z / w)' = (z' w - z w') / w^2
  for (const std::size_t i : places) z.push_back((axis == 0 ? element.x : element.y)[i] * element.w[i]);
  if (!element.rational) return sgn(slope(std::move(z), element.lagrange));
  for (const std::size_t i : places) w.push_back(element.w[i]);
  return cmp(slope(z, element.lagrange) * w[0], z[0] * slope(w, element.lagrange));
}

Curve reversed(Curve curve) {
  for (const auto f : coordinates) std::reverse((curve.*f).begin(), (curve.*f).end());
  return curve;
}

std::array<Curve, 2> halves(const Curve& curve) {
  const mpq_class middle(1, 2);
  return {part(curve, 0, middle), part(curve, middle, 1)};
}

Point control_point(const Curve& curve, std::size_t i) {
  return {fraction(curve.x[i], curve.w[i]), fraction(curve.y[i], curve.w[i])};
}

Point point(const Curve& curve, const mpq_class& t) { return control_point(part(curve, t, t), 0); }

void check_pair(Tokens& tokens, const Curve& a, const Curve& b, Joints joints, int depth) {
  check_depth(depth);
  const auto [end_to_begin, begin_to_end] = joints;
  const std::string_view rule = tokens.word();
  if (rule == "a") {
    const auto half = halves(a);
    check_pair(tokens, half[0], b, {false, begin_to_end}, depth + 1);
    return check_pair(tokens, half[1], b, {end_to_begin, false}, depth + 1);
  }
  if (rule == "b") {
    const auto half = halves(b);
    check_pair(tokens, a, half[0], {end_to_begin, false}, depth + 1);
    return check_pair(tokens, a, half[1], {false, begin_to_end}, depth + 1);
  }
  // Both are taken to begin at their joint.
  const Curve first = end_to_begin ? reversed(a) : a, second = begin_to_end ? reversed(b) : b;
  const int count = end_to_begin + begin_to_end;
  if (rule == "r") {
    require(count <= 1, "r: two joints");
    return rule_r(first, second, count == 1);
  }
  if (rule != "s" && rule != "j") throw Malformed{"expected a rule for two pieces"};
  require(rule != "s" || count == 0, "s: there is a joint");
  const Point n = direction(tokens);
  const auto below = heights(first, n), above = heights(second, n);
  if (rule == "s") return require(greatest(below) < least(above), "s: not apart");
  require(count == 1 && control_point(first, 0) == control_point(second, 0), "j: not one joint, a point");
  require(greatest(below) == below[0] && below.back() < below[0] && least(above) == above[0] &&
              above[0] < above.back(),
          "j: on the wrong side");
}

void check_boundary(Tokens& tokens, const Element& element) {
  const std::vector<Curve> edges = edge_curves(element);
  for (const Curve& edge : edges) check_self(tokens, edge);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j)
      check_pair(tokens, edges[i], edges[j], {j == i + 1, i == 0 && j == edges.size() - 1});
}

void check_root(const Polynomial& m, const mpq_class& low, const mpq_class& high, const RationalPolynomial& u,
                const RationalPolynomial& v, const std::vector<Polynomial2>& sides) {
  require(m.size() >= 3 && low < high && sgn(value(m, low)) * sgn(value(m, high)) < 0,
          "root: no change of sign of a polynomial of degree >= 2");
  for (const Polynomial2& side : sides) {
    const Polynomial f = compose(side, u, v);
    const Integers b = bernstein_on(f, low, high);
    require(std::all_of(b.begin(), b.end(), [](const mpz_class& z) { return z >= 0; }) || divisible(f, m),
            "root: outside the domain");
  }
}

Meet read_meet(Tokens& tokens, bool in_mesh) {
  Meet meet;
  meet.kind = tokens.word();
  const bool root = meet.kind == "root", cross = meet.kind == "cross";
  if (!root && !cross && meet.kind != "at") throw Malformed{"expected at, root or cross"};
  if (root) meet.m = tokens.polynomial(), meet.low = tokens.rational(), meet.high = tokens.rational();
  for (Meet::Place* place : {&meet.first, &meet.second}) {
    static_cast<EdgeName&>(*place) =
        in_mesh ? tokens.edge_name() : EdgeName{0, static_cast<int>(tokens.small(0, 3))};
    if (root) {
      place->parameter = tokens.rational_polynomial();
    } else {
      place->low = tokens.rational();
      place->high = cross ? tokens.rational() : place->low;
    }
  }
  return meet;
}

void check_meet(const Meet& meet, const MeetContext& context) {
  const bool root = meet.kind == "root";
  const auto& [first, second, same_edge, common] = context;
  const Meet::Place &s = meet.first, &t = meet.second;
  const auto contact = [&](const Polynomial2& f) { return compose(f, s.parameter, t.parameter); };
  const auto one_sign = [&](const Polynomial2& f) {
    return one_strict_sign(bernstein_on(contact(f), meet.low, meet.high));
  };
  const auto apart = [](const mpq_class& low, const mpq_class& high, const Meet::Place& p) {
    return high < p.low || p.high < low;
  };
  if (root) {
    check_root(meet.m, meet.low, meet.high, s.parameter, t.parameter,
               {{{0, 1}}, {{1, -1}}, {{}, {1}}, {{1}, {-1}}});
  } else {
    for (const Meet::Place* p : {&s, &t}) require(0 <= p->low && p->high <= 1, "not in [0, 1]");
  }
  require(!same_edge || (root ? one_sign({{0, 1}, {-1}}) : apart(s.low, s.high, t)), "perhaps one parameter");
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      require(!common[i][j] ||
                  (root ? one_sign({{-i, 1}}) || one_sign({{-j}, {1}}) : apart(i, i, s) || apart(j, j, t)),
              "perhaps the common corner");
  if (root) {
    for (const auto f : {&Curve::x, &Curve::y})
      require(divisible(contact(difference(first, second, f)), meet.m), "root: no contact");
  } else if (meet.kind == "at") {
    require(point(first, s.low) == point(second, t.low), "at: two points");
  } else {
    require(s.low < s.high && t.low < t.high, "cross: an empty interval");
    check_cross(part(first, s.low, s.high), part(second, t.low, t.high));
  }
}

}  // namespace verifier
