// Claims of elements: the sign of N, its zeros, injectivity.
#include "rules.hpp"

#include <algorithm>

namespace verifier {

namespace {

/// Reads u and v, in the domain: N is 0 there, or has the sign `also` (at a number x only).
void check_value(Tokens& tokens, const Root& x, const Polynomial2& n, bool triangle, bool zero, int also) {
  const RationalPolynomial u = x.parameter(tokens), v = x.parameter(tokens);
  std::vector<Polynomial2> sides{{{0, 1}}, {{}, {1}}, {{1, -1}, {-1}}};  // all are >= 0 in the domain only
  if (!triangle) sides = {{{0, 1}}, {{}, {1}}, {{1, -1}}, {{1}, {-1}}};
  for (const Polynomial2& side : sides) require(x.not_negative(compose(side, u, v)), "outside the domain");
  const Polynomial f = compose(n, u, v);
  require((zero && x.zero(f)) || (x.m.empty() && !f.empty() && sgn(f[0]) == also), "the sign of N");
}

void check_hull(const Element& e, const Map& map) {
  const int times = e.rational ? 2 : 1, p = times * e.p - e.triangle, q = times * e.q - e.triangle;
  const auto column = [&](const Polynomial2& x, bool by_v) {
    const Polynomial2 d = derivative(x, by_v);
    return form(e.rational ? d * map.w - x * derivative(map.w, by_v) : d, e.triangle, p, q).c;
  };
  const Integers ax = column(map.x, false), ay = column(map.y, false), bx = column(map.x, true),
                 by = column(map.y, true);
  const std::size_t size = std::max({limbs(ax), limbs(ay), limbs(bx), limbs(by)});
  mpz_class mixed;
  for (std::size_t i = 0; i < ax.size(); ++i) {
    spend(ax.size() * 2 * product_work(size, size));
    for (std::size_t j = 0; j <= i; ++j) {
      mpz_mul(mixed.get_mpz_t(), ax[i].get_mpz_t(), by[j].get_mpz_t());
      mpz_submul(mixed.get_mpz_t(), ay[i].get_mpz_t(), bx[j].get_mpz_t());
      mpz_addmul(mixed.get_mpz_t(), ax[j].get_mpz_t(), by[i].get_mpz_t());
      mpz_submul(mixed.get_mpz_t(), ay[j].get_mpz_t(), bx[i].get_mpz_t());
      require(i == j ? mixed > 0 : mixed >= 0, "hull");
    }
  }
}

void check_orientation(const Element& e, const Map& map) {
  require(e.triangle, "orientation of a quadrilateral");
  const int n = e.p;
  const Integers x = form(map.x, true, n, n).c, y = form(map.y, true, n, n).c, w = form(map.w, true, n, n).c;
  std::vector<std::array<int, 2>> l;  // the indices (n - i - j, i, j)
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i) l.push_back({i, j});
  const std::size_t size = std::max({limbs(x), limbs(y), limbs(w)});
  for (std::size_t a = 0; a < l.size(); ++a) {
    for (std::size_t b = a + 1; b < l.size(); ++b) {
      const auto minor = [&](const auto& f, const auto& g) { return mpz_class(f[a] * g[b] - g[a] * f[b]); };
      const mpz_class yw = minor(y, w), wx = minor(w, x), xy = minor(x, y);
      spend(l.size() * 6 * product_work(size, size));
      for (std::size_t c = b + 1; c < l.size(); ++c) {
        // 1/n of the determinant of the three indices, whose components have the sum n.
        const int det = (l[b][0] - l[a][0]) * (l[c][1] - l[a][1]) - (l[b][1] - l[a][1]) * (l[c][0] - l[a][0]);
        const int orientation = sgn(mpz_class(yw * x[c] + wx * y[c] + xy * w[c]));
        // Corner triples are those with the sum (3n - 2, 1, 1), in some order.
        const int i = l[a][0] + l[b][0] + l[c][0], j = l[a][1] + l[b][1] + l[c][1];
        const bool corner = i * j * (3 * n - i - j) == 3 * n - 2;
        require(det == 0 || (det > 0 ? orientation : -orientation) >= corner, "orientation");
      }
    }
  }
}

/// INJECTIVE, of a regular element.
void check_injective(Tokens& tokens, const Element& e, const Map& map) {
  if (tokens.accept("orientation")) return check_orientation(e, map);
  if (tokens.accept("midpoint"))
    return require(!e.rational && e.p <= (e.triangle ? 2 : 1) && e.q <= (e.triangle ? 2 : 1), "midpoint");
  if (tokens.accept("boundary")) return check_boundary(tokens, edge_curves(e));
  throw Malformed{"expected a proof of injectivity"};
}

MeetingEdges meeting(const Element& e, std::size_t first, std::size_t second) {
  const std::vector<Curve> edges = edge_curves(e);
  if (std::max(first, second) >= edges.size()) throw Malformed{"the element has no such edge"};
  MeetingEdges result{edges[first], edges[second], first == second};
  result.common[1][0] = second == (first + 1) % edges.size();
  result.common[0][1] = first == (second + 1) % edges.size();
  return result;
}

}  // namespace

Claim check_element(const Element& e, Tokens& tokens) {
  static constexpr std::string_view names[] = {"injective", "regular",  "overlapping", "degenerate",
                                               "folded",    "reversed", "invalid",     "undecided"};
  const auto* name = std::ranges::find(names, tokens.word());
  if (name == std::end(names)) throw Malformed{"unknown claim"};
  const auto claim = static_cast<Claim>(name - names);
  const Map map = map_of(e);
  if (claim == Claim::injective && tokens.accept("hull")) {
    check_hull(e, map);
  } else if (claim != Claim::undecided) {
    const Polynomial2 n = jacobian_numerator(map, e.rational);
    const int times = e.rational ? 3 : 2, more = e.triangle ? 0 : 1;
    const std::array<int, 2> degree{times * (e.p - 1) + more, times * (e.q - 1) + more};
    if (claim == Claim::folded) {
      check_value(tokens, Root(), n, e.triangle, false, -1);
    } else if (claim != Claim::invalid) {
      check_sign(tokens, claim == Claim::reversed ? Polynomial2{} - n : n, e.triangle, degree,
                 claim != Claim::degenerate);
    }
    if (claim == Claim::injective) check_injective(tokens, e, map);
    if (claim == Claim::overlapping)
      check_meet(tokens, false, [&](const auto& a, const auto& b) {
        return meeting(e, static_cast<std::size_t>(a.edge), static_cast<std::size_t>(b.edge));
      });
    if (claim == Claim::degenerate) check_value(tokens, Root(tokens), n, e.triangle, true, 0);
    if (claim == Claim::folded) check_value(tokens, Root(tokens), n, e.triangle, true, 1);
    if (claim == Claim::invalid) check_value(tokens, Root(tokens), n, e.triangle, true, -1);
  }
  tokens.expect_end();
  return claim;
}

}  // namespace verifier
