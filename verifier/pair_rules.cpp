// Edges as Bezier curves. SELF and PAIR show by signs of control points that they do not meet; MEET shows
// that they do: by equal points, by divisibility, or by Poincare-Miranda. Points stay homogeneous, in
// integers.
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
  const int n = static_cast<int>(c.size());
  const std::size_t d = c.size() - 1;
  mpz_class factor = 1, common = 1;
  differences(c, 0, 1, n);
  for (std::size_t k = d + 1; k-- > 0; factor *= k) c[k] *= factor;  // d! / k!
  newton_to_power(c, 0, 1, n);
  factor = 1;
  for (std::size_t k = 0; k <= d; ++k, factor *= d) c[k] *= factor, common = lcm(common, choose(d, k));
  shear(c, 0, 1, n);
  for (std::size_t k = 0; k <= d; ++k) c[k] *= common / choose(d, k);
}

/// The derivative at the begin, times a positive number that depends on the size of c only.
mpz_class slope(Integers c, bool lagrange) {
  if (!lagrange) return c[1] - c[0];
  differences(c, 0, 1, static_cast<int>(c.size()));
  mpz_class sum, common = 1;
  for (unsigned long k = 1; k < c.size(); ++k) common = lcm(common, mpz_class(k));
  for (unsigned long k = 1; k < c.size(); ++k) k % 2 ? sum += common / k * c[k] : sum -= common / k * c[k];
  return sum;
}

std::size_t size_of(const Curve& c) { return std::max({limbs(c.x), limbs(c.y), limbs(c.w)}); }

/// The parts before and after the parameter p / q.
std::array<Curve, 2> cut(const Curve& curve, const mpz_class& p, const mpz_class& q) {
  std::array<Curve, 2> parts{curve, curve};
  const std::size_t d = curve.x.size() - 1, size = mpz_size(q.get_mpz_t());
  spend(3 * (d + 1) * (d + 1) * (1 + product_work(size_of(curve) + d * size, size)));
  const mpz_class rest = q - p;
  Integers powers{1};
  while (powers.size() <= d) powers.push_back(powers.back() * q);
  for (const auto f : coordinates) {
    Integers &first = parts[0].*f, &second = parts[1].*f;
    for (std::size_t k = 0; k <= d; ++k) {  // after k rounds points are q^k times too large
      first[k] = second[0] * powers[d - k];
      for (std::size_t i = 0; i + k < d; ++i) {
        second[i] *= rest;
        mpz_addmul(second[i].get_mpz_t(), second[i + 1].get_mpz_t(), p.get_mpz_t());
      }
    }
    for (std::size_t k = 1; k <= d; ++k) second[k] *= powers[k];
  }
  for (Curve& part : parts) {  // common powers of two would double with every halving
    mp_bitcnt_t common = ~mp_bitcnt_t{0};
    for (const auto f : coordinates)
      for (const mpz_class& z : part.*f)
        if (z != 0) common = std::min(common, mpz_scan1(z.get_mpz_t(), 0));
    for (const auto f : coordinates)
      for (mpz_class& z : part.*f) z >>= common;
  }
  return parts;
}

/// n . P_i for control points P_i: heights times weights.
struct Heights {
  Integers h;
  const Integers& w;
  Heights(const Curve& c, const mpz_class& nx, const mpz_class& ny) : w(c.w) {
    const std::size_t size = 1 + mpz_size(nx.get_mpz_t()) + mpz_size(ny.get_mpz_t());
    spend(3 * w.size() * product_work(size_of(c), size) +
          3 * w.size() * w.size() * product_work(size_of(c) + size, size_of(c)));
    for (std::size_t i = 0; i < w.size(); ++i) h.push_back(nx * c.x[i] + ny * c.y[i]);
  }
  std::size_t last() const { return h.size() - 1; }
};

/// The sign of the height of point i of a, less that of point j of b.
int compare(const Heights& a, std::size_t i, const Heights& b, std::size_t j) {
  return cmp(a.h[i] * b.w[j], b.h[j] * a.w[i]);
}

Polynomial power_basis(Integers c) {
  differences(c, 0, 1, static_cast<int>(c.size()));
  for (std::size_t k = 0; k < c.size(); ++k) c[k] *= choose(c.size() - 1, k);
  trim(c);
  return c;
}

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

void rule_s(Tokens& tokens, const Curve& a, const Curve& b) {
  const mpz_class nx = tokens.integer(), ny = tokens.integer();
  const Heights below(a, nx, ny), above(b, nx, ny);
  for (std::size_t i = 0; i <= below.last(); ++i)
    for (std::size_t j = 0; j <= above.last(); ++j) require(compare(below, i, above, j) < 0, "s: not apart");
}

void rule_j(Tokens& tokens, const Curve& a, const Curve& b, Joints joints) {
  const mpz_class nx = tokens.integer(), ny = tokens.integer();
  require(joints.end_to_begin != joints.begin_to_end, "j: not exactly one joint");
  const bool at_end = joints.end_to_begin;  // of a
  require(point(a, at_end ? 1 : 0) == point(b, at_end ? 0 : 1), "j: the joint is not one point");
  const auto one_side = [&](const Curve& c, bool end, int side) {
    const Heights heights(c, nx, ny);
    const std::size_t joint = end ? heights.last() : 0, other = heights.last() - joint;
    for (std::size_t i = 0; i <= heights.last(); ++i)
      require(side * compare(heights, i, heights, joint) >= (i == other ? 1 : 0), "j: on the wrong side");
  };
  one_side(a, at_end, -1);
  one_side(b, !at_end, 1);
}

void rule_r(const Curve& a, const Curve& b, Joints joints) {
  require(!joints.end_to_begin || !joints.begin_to_end, "r: two joints");
  const Curve first = joints.end_to_begin ? reversed(a) : a, second = joints.begin_to_end ? reversed(b) : b;
  const Polynomial2 f = difference(first, second, &Curve::x), g = difference(first, second, &Curve::y);
  // In the degree that b has, perhaps less than the formal one, in which R would be 0. At least 1, so that R
  // = A F + B G.
  const int n = std::max({2, static_cast<int>(f.size()), static_cast<int>(g.size())}) - 1;
  Polynomial r = resultant(f, n, g, n);
  require(!r.empty(), "r: the resultant is 0");
  if (joints.end_to_begin || joints.begin_to_end)
    r.erase(r.begin(), std::find_if(r.begin(), r.end(), [](const mpz_class& z) { return z != 0; }));
  require(one_strict_sign(bernstein_on(r, 0, 1)), "r: the resultant has not one sign");
}

void check_depth(int depth) {
  if (depth > 512) throw Malformed{"limit: more than 512 halvings"};
}

void pair_rule(Tokens& tokens, const Curve& a, const Curve& b, Joints joints, int depth) {
  check_depth(depth);
  const std::string_view rule = tokens.word();
  if (rule == "s") {
    require(!joints.end_to_begin && !joints.begin_to_end, "s: there is a joint");
    rule_s(tokens, a, b);
  } else if (rule == "j") {
    rule_j(tokens, a, b, joints);
  } else if (rule == "r") {
    rule_r(a, b, joints);
  } else if (rule == "a") {
    const auto half = halves(a);
    pair_rule(tokens, half[0], b, {false, joints.begin_to_end}, depth + 1);
    pair_rule(tokens, half[1], b, {joints.end_to_begin, false}, depth + 1);
  } else if (rule == "b") {
    const auto half = halves(b);
    pair_rule(tokens, a, half[0], {joints.end_to_begin, false}, depth + 1);
    pair_rule(tokens, a, half[1], {false, joints.begin_to_end}, depth + 1);
  } else {
    throw Malformed{"expected a rule for two pieces"};
  }
}

void self_rule(Tokens& tokens, const Curve& curve, int depth) {
  check_depth(depth);
  if (tokens.accept("h")) {
    const auto half = halves(curve);
    self_rule(tokens, half[0], depth + 1);
    self_rule(tokens, half[1], depth + 1);
    return pair_rule(tokens, half[0], half[1], {true, false}, depth + 1);
  }
  if (!tokens.accept("m")) throw Malformed{"expected a rule for one piece"};
  const mpz_class nx = tokens.integer(), ny = tokens.integer();
  const Heights heights(curve, nx, ny);
  for (std::size_t i = 0; i < heights.last(); ++i)
    require(compare(heights, i, heights, i + 1) < 0, "m: not increasing");
}

/// The numerator of f - c.
Polynomial less(const RationalPolynomial& f, int c) {
  Polynomial g = f.numerator;
  if (g.empty()) g.emplace_back(0);
  g[0] -= f.denominator * c;
  trim(g);
  return g;
}

void check_root(const Meet& meet, const MeetContext& context) {
  const Polynomial& m = meet.m;
  require(m.size() >= 3 && meet.low < meet.high && sgn(value(m, meet.low)) * sgn(value(m, meet.high)) < 0,
          "root: no change of sign of a polynomial of degree >= 2");
  const auto on = [&](const Polynomial& f) { return bernstein_on(f, meet.low, meet.high); };
  for (const RationalPolynomial* f : {&meet.s, &meet.t}) {
    for (const int c : {0, 1}) {  // f >= 0, f <= 1
      const Polynomial g = less(*f, c);
      const Integers b = on(g);
      const bool within =
          std::all_of(b.begin(), b.end(), [&](const mpz_class& z) { return c ? z <= 0 : z >= 0; });
      require(within || divisible(g, m), "root: a parameter is not in [0, 1]");
    }
  }
  require(!context.same_edge || one_strict_sign(on(compose({{0, 1}, {-1}}, meet.s, meet.t))),  // s - t
          "root: perhaps one parameter");
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      require(!context.common[i][j] || one_strict_sign(on(less(meet.s, i))) ||
                  one_strict_sign(on(less(meet.t, j))),
              "root: perhaps the common corner");
  for (const auto f : {&Curve::x, &Curve::y})
    require(divisible(compose(difference(context.first, context.second, f), meet.s, meet.t), m),
            "root: no contact");
}

/// Whether all control points of `inner` lie between two of `outer`.
bool between(const Heights& outer, std::size_t low, std::size_t high, const Heights& inner) {
  for (std::size_t i = 0; i <= inner.last(); ++i)
    if (compare(outer, low, inner, i) > 0 || compare(inner, i, outer, high) > 0) return false;
  return true;
}

void check_cross(const Curve& a, const Curve& b) {
  const std::size_t n = a.x.size() - 1;
  const mpz_class dx = a.x[n] * a.w[0] - a.x[0] * a.w[n], dy = a.y[n] * a.w[0] - a.y[0] * a.w[n];
  require(dx != 0 || dy != 0, "cross: d = 0");  // all below would hold
  require(between({a, dx, dy}, 0, n, {b, dx, dy}), "cross: the second piece passes an end of the first");
  const Heights side(b, -dy, dx), inner(a, -dy, dx);
  require(between(side, 0, side.last(), inner) || between(side, side.last(), 0, inner),
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

std::array<Curve, 2> halves(const Curve& curve) { return cut(curve, 1, 2); }

Curve restricted(const Curve& curve, const mpq_class& low, const mpq_class& high) {
  require(0 <= low && low < high && high <= 1, "not an interval in [0, 1]");
  const mpq_class part = low / high;
  return cut(cut(curve, high.get_num(), high.get_den())[0], part.get_num(), part.get_den())[1];
}

std::array<mpq_class, 2> point(const Curve& curve, const mpq_class& t) {
  const Curve c = t == 1 ? curve : cut(curve, t.get_num(), t.get_den())[0];
  return {fraction(c.x.back(), c.w.back()), fraction(c.y.back(), c.w.back())};
}

void check_pair(Tokens& tokens, const Curve& a, const Curve& b, Joints joints) {
  pair_rule(tokens, a, b, joints, 0);
}

void check_boundary(Tokens& tokens, const Element& element) {
  const int count = element.triangle ? 3 : 4;
  std::vector<Curve> edges;
  for (int e = 0; e < count; ++e) edges.push_back(edge_curve(element, e));
  for (const Curve& edge : edges) self_rule(tokens, edge, 0);
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      check_pair(tokens, edges[i], edges[j], {j == i + 1, i == 0 && j == count - 1});
}

Meet read_meet(Tokens& tokens, bool in_mesh) {
  Meet meet;
  meet.kind = tokens.word();
  const bool root = meet.kind == "root", cross = meet.kind == "cross";
  if (!root && !cross && meet.kind != "at") throw Malformed{"expected at, root or cross"};
  if (root) meet.m = tokens.polynomial(), meet.low = tokens.rational(), meet.high = tokens.rational();
  const auto place = [&](EdgeName& edge, mpq_class& low, mpq_class& high, RationalPolynomial& f) {
    edge = in_mesh ? tokens.edge_name() : EdgeName{0, static_cast<int>(tokens.small(0, 3))};
    if (root) return void(f = tokens.rational_polynomial());
    low = tokens.rational();
    high = cross ? tokens.rational() : low;
  };
  place(meet.first, meet.first_low, meet.first_high, meet.s);
  place(meet.second, meet.second_low, meet.second_high, meet.t);
  return meet;
}

void check_meet(const Meet& meet, const MeetContext& context) {
  if (meet.kind == "root") return check_root(meet, context);
  const mpq_class &s0 = meet.first_low, &s1 = meet.first_high, &t0 = meet.second_low, &t1 = meet.second_high;
  require(s0 >= 0 && s1 <= 1 && t0 >= 0 && t1 <= 1, "a parameter is not in [0, 1]");
  require(!context.same_edge || s1 < t0 || t1 < s0, "perhaps one parameter");
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      require(!context.common[i][j] || s0 > i || i > s1 || t0 > j || j > t1, "perhaps the common corner");
  if (meet.kind == "at")
    return require(point(context.first, s0) == point(context.second, t0), "at: two points");
  check_cross(restricted(context.first, s0, s1), restricted(context.second, t0, t1));
}

}  // namespace verifier
