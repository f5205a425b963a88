// SELF and PAIR show by signs of control points that edges do not meet; MEET shows that they do: by equal
// points, by divisibility, or by Poincare-Miranda.
#include "rules.hpp"

#include <algorithm>

namespace verifier {

namespace {

/// n . P for the control points P.
std::vector<mpq_class> heights(const Curve& c, const Point& n) {
  const std::size_t size = limbs(c.x) + limbs(c.y) + limbs(c.w) +
                           limbs({n[0].get_num(), n[0].get_den(), n[1].get_num(), n[1].get_den()});
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
Polynomial2 difference(Curve a, Curve b, Integers Curve::*f) {
  for (Integers* c : {&(a.*f), &a.w, &(b.*f), &b.w}) shear(line(*c), true);  // to powers
  Polynomial2 product{a.*f}, other{a.w};
  trim(product), trim(other);
  return product * exchanged({b.w}) - other * exchanged({b.*f});
}

void rule_r(const Curve& a, const Curve& b, bool joint) {
  const Polynomial2 f = difference(a, b, &Curve::x), g = difference(a, b, &Curve::y);
  // In the degree that b has, perhaps less than the formal one, in which R would be 0. At least 1, so that
  // R = A F + B G.
  const int n = std::max({2, static_cast<int>(f.size()), static_cast<int>(g.size())}) - 1;
  Polynomial r = resultant(f, n, g, n);
  require(!r.empty(), "r: the resultant is 0");
  if (joint) r.erase(r.begin(), std::find_if(r.begin(), r.end(), [](const mpz_class& z) { return z != 0; }));
  require(one_strict_sign(bernstein(r, 0, 1)), "r: the resultant has not one sign");
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

Root::Root(Tokens& tokens) {
  if (tokens.accept("at")) return;
  if (!tokens.accept("root")) throw Malformed{"expected at, root or cross"};
  m = tokens.polynomial(), low = tokens.rational(), high = tokens.rational();
  require(m.size() >= 3 && low < high && sign_at(m, low) * sign_at(m, high) < 0,
          "root: no change of sign of a polynomial of degree >= 2");
}

RationalPolynomial Root::parameter(Tokens& tokens) const {
  return m.empty() ? constant(tokens.rational()) : tokens.rational_polynomial();
}

bool Root::zero(const Polynomial& f) const { return f.empty() || divisible(f, m); }

bool Root::not_negative(const Polynomial& f) const {
  const Integers b = bernstein(f, low, high);
  return zero(f) || std::all_of(b.begin(), b.end(), [](const mpz_class& z) { return z >= 0; });
}

bool Root::positive(const Polynomial& f) const {
  const Integers b = bernstein(f, low, high);
  return b[0] > 0 && one_strict_sign(b);
}

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

void check_boundary(Tokens& tokens, const std::vector<Curve>& edges) {
  for (const Curve& edge : edges) check_self(tokens, edge);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j)
      check_pair(tokens, edges[i], edges[j], {j == i + 1, i == 0 && j == edges.size() - 1});
}

void check_meet(Tokens& tokens, bool in_mesh,
                const std::function<MeetingEdges(const EdgeName&, const EdgeName&)>& find) {
  struct Place {
    EdgeName name;
    RationalPolynomial low, high;  ///< of the parameter, as functions of x; equal but for `cross`
  };
  const bool cross = tokens.accept("cross");
  const Root x = cross ? Root() : Root(tokens);
  const auto read = [&] {
    const EdgeName name = in_mesh ? tokens.edge_name() : EdgeName{0, static_cast<int>(tokens.small(0, 3))};
    const RationalPolynomial low = x.parameter(tokens);
    return Place{name, low, cross ? x.parameter(tokens) : low};
  };
  const Place s = read(), t = read();
  const auto [first, second, same, common] = find(s.name, t.name);

  const auto minus = [](const auto& a, const auto& b) { return compose(Polynomial2{{0, 1}, {-1}}, a, b); };
  const auto less = [&](const auto& a, const auto& b) { return x.positive(minus(b, a)); };
  const RationalPolynomial zero = constant(0), one = constant(1);
  const auto off_end = [&](const Place& p, int i) { return i == 0 ? less(zero, p.low) : less(p.high, one); };
  for (const Place& p : {s, t})
    require(x.not_negative(minus(p.low, zero)) && x.not_negative(minus(one, p.high)), "not in [0, 1]");
  require(!same || less(s.high, t.low) || less(t.high, s.low), "perhaps one parameter");
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      require(!common[i][j] || off_end(s, i) || off_end(t, j), "perhaps the common corner");
  if (cross) {
    require(less(s.low, s.high) && less(t.low, t.high), "cross: an empty interval");
    const auto value = [](const RationalPolynomial& c) { return fraction(c.numerator[0], c.denominator); };
    check_cross(part(first, value(s.low), value(s.high)), part(second, value(t.low), value(t.high)));
  } else {
    for (const auto f : {&Curve::x, &Curve::y})
      require(x.zero(compose(difference(first, second, f), s.low, t.low)), "no contact");
  }
}

}  // namespace verifier
