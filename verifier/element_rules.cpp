// Claims of elements: N in the power basis, its sign on parts of the domain, its zeros, injectivity.
#include "element_rules.hpp"
#include "pair_rules.hpp"

#include <algorithm>

namespace verifier {

namespace {

/// f on a piece of its domain as a homogeneous polynomial in the piece's barycentric coordinates (squares:
/// those of u, and those of v). Coefficients, in the order of Element's points, are Bernstein coefficients
/// times multinomials.
struct Form {
  bool triangle;
  int p, q;  ///< p = q on triangles
  std::vector<mpz_class> c = std::vector<mpz_class>(point_count(triangle, p, q));

  /// The place of the coefficient with the exponents i of corner 1 (u) and j of corner 2 (v).
  std::size_t at(int i, int j) const { return triangle ? j * (2 * p + 3 - j) / 2 + i : j * (p + 1) + i; }
  /// Changes all lines of coefficients along u, or v.
  template <class Change>
  void lines(bool along_v, Change change) {
    for (int k = 0; k <= (along_v ? p : q); ++k) {
      std::vector<mpz_class> line((triangle ? p - k : along_v ? q : p) + 1);
      const auto exchange = [&] {
        for (int i = 0; i < std::ssize(line); ++i) swap(line[i], c[along_v ? at(k, i) : at(i, k)]);
      };
      exchange();
      change(line);
      exchange();
    }
  }
};

/// On the whole domain: 1 = (1 - u - v) + u + v is put into f.
Form form(const Polynomial2& f, bool triangle, int p, int q) {
  const auto [f_u, f_v, f_total] = degrees(f);
  require(triangle ? f_total <= p && p == q : f_u <= p && f_v <= q, "degree");
  Form result{triangle, p, q};
  for (int j = 0; j < std::ssize(f); ++j) std::ranges::copy(f[j], &result.c[result.at(0, j)]);
  for (const bool along_v : {false, true}) result.lines(along_v, shear);
  return result;
}

/// `coefficients`.
bool is_positive(const Form& f, bool strict) {
  return std::ranges::all_of(f.c, [](const mpz_class& c) { return c >= 0; }) &&
         (!strict || (f.c.front() > 0 && f.c[f.at(f.p, 0)] > 0 && f.c[f.at(0, f.q)] > 0 && f.c.back() > 0));
}

/// A half after the cut of AB at its middle M: x_A A + x_B B = x A + y M (or x B + y M) is x_A = x + Y, x_B =
/// Y (or exchanged) with Y = y / 2; all times 2^max(p, q).
Form half(Form f, bool second, bool along_v) {
  Form result = f;
  f.lines(along_v, [&](std::vector<mpz_class>& line) {
    const int last = static_cast<int>(line.size()) - 1;
    if (second) std::ranges::reverse(line);
    shear(line);
    for (int k = 0; k <= last; ++k) line[k] <<= std::max(f.p, f.q) - k;
    for (int k = 0; k <= last && f.triangle; ++k)  // (C, A, M) or (B, C, M); C has the exponent p - last
      result.c[f.at(second ? f.p - last : last - k, k)] = line[k];
    if (second) std::ranges::reverse(line);
  });
  return f.triangle ? result : f;
}

/// `tree`: takes the one of f from the front of `bits`.
void check_tree(std::string_view& bits, const Form& f, bool strict, int depth = 0) {
  if (bits.empty() || depth > 512) throw Malformed{"not a tree, or deeper than 512"};
  const bool leaf = bits.front() == '0';
  bits.remove_prefix(1);
  if (leaf) return require(is_positive(f, strict), "a leaf of a tree");
  for (const bool second : {false, true})
    check_tree(bits, half(f, second, !f.triangle && depth % 2 == 1), strict, depth + 1);
}

/// The sign of the rational c != 0 for which f = c g; 0 if there is none. g is not 0.
int ratio(const Polynomial2& f, const Polynomial2& g) {
  if (f.empty() || f.back().empty()) return 0;
  const mpz_class &a = f.back().back(), &b = g.back().back();
  return f * Polynomial2{{b}} == g * Polynomial2{{a}} ? sgn(a) * sgn(b) : 0;
}

void check_sign(Tokens&, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors = true);

void check_factors(Tokens& tokens, const Polynomial2& f, bool triangle, bool strict) {
  const auto [f_u, f_v, f_total] = degrees(f);
  Polynomial2 product{{1}};
  int sign = 1;
  for (long k = tokens.small(1, 4096); k > 0; --k) {
    const long exponent = tokens.small(1, 4096);
    const Polynomial2 h = tokens.polynomial2();
    const auto [h_u, h_v, h_total] = degrees(h);
    if (h_total == 0) throw Malformed{"a constant factor"};
    for (long i = 0; i < exponent; ++i, product = product * h) {
      const auto [u, v, total] = degrees(product);
      require(u + h_u <= f_u && v + h_v <= f_v, "degree of factors");
    }
    if (tokens.accept("none")) {
      require(exponent % 2 == 0 && !strict, "a factor without proof");
      continue;
    }
    const bool minus = tokens.accept("-");
    if (!minus && !tokens.accept("+")) throw Malformed{"expected none, + or -"};
    if (minus && exponent % 2 == 1) sign = -sign;
    check_sign(tokens, minus ? Polynomial2{} - h : h, triangle,
               {triangle ? h_total : h_u, triangle ? h_total : h_v}, strict, false);
  }
  require(ratio(f, product) == sign, "the product of the factors, or its sign");
}

/// A list E of exponents: f = const * prod s_i^E_i.
void check_exponents(Tokens& tokens, const Polynomial& f, const std::vector<Polynomial>& s) {
  std::string list(tokens.word());
  std::ranges::replace(list, ',', ' ');
  Tokens exponents(list);
  if (s.empty() && !exponents.accept("-")) throw Malformed{"expected -"};
  Polynomial product{1};
  for (const Polynomial& factor : s)
    for (long e = exponents.small(0, 1 << 20); e > 0; --e, product = product * factor)
      require(product.size() + factor.size() <= f.size() + 1, "exponents of columns");
  exponents.expect_end();
  require(ratio({f}, {product}) != 0, "roots of columns");
}

/// f > 0 on the square, shown on it or on its halves, quarters, ... across u, at most `left` + 1 pieces.
void check_halves(const Form& f, int& left) {
  if (is_positive(f, true)) return;
  require(f.c.front() > 0 && f.c.back() > 0 && left-- > 0, "f on a column or slab");
  for (const bool second : {false, true}) check_halves(half(f, second, false), left);
}

void check_strip(const Polynomial2& f, int p, int q) {
  int left = 4095;
  check_halves(form(f, false, p, q), left);
}

Polynomial2 exchanged(const Polynomial2& f) {
  Polynomial2 result(degrees(f)[0] + 1, Polynomial(f.size()));
  for (std::size_t j = 0; j < f.size(); ++j)
    for (std::size_t i = 0; i < f[j].size(); ++i) result[i][j] = f[j][i];
  trim(result);
  return result;
}

void check_columns(Tokens& tokens, Polynomial2 f, bool triangle, bool strict) {
  const bool by_v = tokens.accept("v");
  if (!by_v && !tokens.accept("u")) throw Malformed{"expected u or v"};
  if (by_v) f = exchanged(f);
  const int n = degrees(f)[1];
  require(n >= 1, "columns of a polynomial without v");
  const Polynomial top = triangle ? Polynomial{1, -1} : Polynomial{1};
  std::vector<Polynomial> s(tokens.small(0, 4096));
  for (Polynomial& factor : s)
    if ((factor = tokens.polynomial()).size() < 2) throw Malformed{"a constant for columns"};
  check_exponents(tokens, f.back(), s);
  check_exponents(tokens, f.front(), s);
  check_exponents(tokens, compose(f, {{0, 1}, 1}, {top, 1}), s);
  check_exponents(tokens, resultant(f, n, derivative(f, true), n - 1), s);

  Polynomial power{1};  // f becomes f(u, t top(u)), on the unit square
  for (Polynomial& row : f) row = row * power, power = power * top;
  std::vector<mpq_class> c{0};
  for (long k = tokens.small(1, 1 << 16); k > 0; --k) {
    const mpq_class u = tokens.rational();
    require(c.back() < u && u < 1, "order of columns");
    c.push_back(u);
    for (const Polynomial& factor : s) require(value(factor, u) != 0, "a column over a root");
    check_strip({compose(f, {{u.get_num()}, u.get_den()}, {{0, 1}, 1})}, n, 0);
  }
  c.push_back(1);
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    if (strict && tokens.accept("slab")) {
      Polynomial2 slab;
      for (const Polynomial& row : f) slab.push_back(compose(row, degrees(f)[0], onto(c[i], c[i + 1])));
      check_strip(exchanged(slab), n, degrees(f)[0]);
      continue;
    }
    const bool open = tokens.accept("open"), at_end = i == 0 || i + 2 == c.size();
    if (!open && !tokens.accept("root")) throw Malformed{"expected open, root or slab"};
    int variations = 0;
    for (const Polynomial& factor : s) {
      std::vector<mpz_class> b = bernstein(factor, static_cast<int>(factor.size()) - 1, c[i], c[i + 1]);
      std::erase(b, 0);
      for (std::size_t k = 1; k < b.size(); ++k) variations += sgn(b[k - 1]) != sgn(b[k]);
      require(!strict || (value(factor, c[i]) != 0 && value(factor, c[i + 1]) != 0), "a root at the end");
    }
    require(open ? variations == 0 : !strict && !at_end && variations <= 1, "roots between columns");
  }
}

/// SIGN: f > 0, or f >= 0 if not strict, on the domain. `degree` is for `coefficients` and `tree`.
void check_sign(Tokens& tokens, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors) {
  if (tokens.accept("coefficients")) {
    require(is_positive(form(f, triangle, degree[0], degree[1]), strict), "coefficients");
  } else if (tokens.accept("tree")) {
    std::string_view bits = tokens.bits();
    if (bits == "0" || bits.size() > 1 << 16)
      throw Malformed{"a tree without a cut, or of more than 2^16 pieces"};
    check_tree(bits, form(f, triangle, degree[0], degree[1]), strict);
    if (!bits.empty()) throw Malformed{"more than a tree"};
  } else if (factors && tokens.accept("factors")) {
    check_factors(tokens, f, triangle, strict);
  } else if (tokens.accept("columns")) {
    check_columns(tokens, f, triangle, strict);
  } else {
    throw Malformed{"expected the proof of a sign"};
  }
}

bool in_domain(bool triangle, const mpq_class& u, const mpq_class& v) {
  return u >= 0 && v >= 0 && (triangle ? u + v <= 1 : u <= 1 && v <= 1);
}

/// The sign of f at a point.
int sign_at(const Polynomial2& f, const mpq_class& u, const mpq_class& v) {
  const Polynomial at = compose(f, {{u.get_num()}, u.get_den()}, {{v.get_num()}, v.get_den()});
  return at.empty() ? 0 : sgn(at[0]);
}

/// ZERO; at a rational point N may have the sign `also` as well.
void check_zero(Tokens& tokens, const Polynomial2& n, bool triangle, int also) {
  if (tokens.accept("at")) {
    const mpq_class u = tokens.rational(), v = tokens.rational();
    const int sign = sign_at(n, u, v);
    return require(in_domain(triangle, u, v) && (sign == 0 || sign == also), "the sign at a point");
  }
  if (!tokens.accept("root")) throw Malformed{"expected at or root"};
  const Polynomial m = tokens.polynomial();
  const mpq_class low = tokens.rational(), high = tokens.rational();
  const RationalPolynomial u = tokens.rational_polynomial(), v = tokens.rational_polynomial();
  std::vector<Polynomial2> sides{{{0, 1}}, {{}, {1}}, {{1, -1}, {-1}}};  // all are >= 0 in the domain only
  if (!triangle) sides = {{{0, 1}}, {{}, {1}}, {{1, -1}}, {{1}, {-1}}};
  check_root(m, low, high, u, v, sides);
  require(divisible(compose(n, u, v), m), "N at the root");
}

/// X, Y, W in the power basis in (u, v), times one positive number; if not rational W = 1, and X, Y are times
/// one.
struct Map {
  Polynomial2 x, y, w;
};

/// N = [P P_u P_v] times a positive number.
Polynomial2 jacobian_numerator(const Map& map, bool rational) {
  const auto minor = [](const Polynomial2& f, const Polynomial2& g) {
    return derivative(f, false) * derivative(g, true) - derivative(f, true) * derivative(g, false);
  };
  if (!rational) return minor(map.x, map.y);
  return map.x * minor(map.y, map.w) - map.y * minor(map.x, map.w) - map.w * minor(map.y, map.x);
}

void check_hull(const Element& e, const Map& map) {
  const int times = e.rational ? 2 : 1, p = times * e.p - e.triangle, q = times * e.q - e.triangle;
  const auto column = [&](const Polynomial2& x, bool by_v) {
    const Polynomial2 d = derivative(x, by_v);
    return form(e.rational ? d * map.w - x * derivative(map.w, by_v) : d, e.triangle, p, q).c;
  };
  const std::vector<mpz_class> ax = column(map.x, false), ay = column(map.y, false), bx = column(map.x, true),
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
  const std::vector<mpz_class> x = form(map.x, true, n, n).c, y = form(map.y, true, n, n).c,
                               w = form(map.w, true, n, n).c;
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
  if (tokens.accept("midpoint")) {
    require(!e.rational && (e.triangle ? e.p <= 2 : e.p == 1 && e.q == 1), "midpoint of a higher degree");
  } else if (tokens.accept("hull")) {
    check_hull(e, map);
  } else if (tokens.accept("orientation")) {
    check_orientation(e, map);
  } else if (tokens.accept("boundary")) {
    check_boundary(tokens, e);
  } else {
    throw Malformed{"expected a proof of injectivity"};
  }
}

/// MEET of two edges of the element.
void check_element_meet(Tokens& tokens, const Element& e) {
  const Meet meet = read_meet(tokens, false);
  const int m = e.triangle ? 3 : 4, first = meet.first.edge, second = meet.second.edge;
  MeetContext context{edge_curve(e, first), edge_curve(e, second), first == second};
  context.common[1][0] = second == (first + 1) % m;
  context.common[0][1] = first == (second + 1) % m;
  check_meet(meet, context);
}

/// The polynomial with these control points, or these values at the nodes, times a number that depends on the
/// shape.
Polynomial2 in_powers(const Element& e, const std::vector<mpz_class>& values) {
  Form f{e.triangle, e.p, e.q, values};
  for (const bool along_v : {false, true}) f.lines(along_v, differences);
  for (const bool along_v : {false, true})
    if (e.lagrange)
      f.lines(along_v, [&](auto& line) { newton_to_power(line, along_v ? e.q : e.p, along_v ? e.q : e.p); });
  if (!e.lagrange) {  // differences at the first control point are coefficients but for the multinomials
    const Form one = form({{1}}, e.triangle, e.p, e.q);
    for (std::size_t k = 0; k < f.c.size(); ++k) f.c[k] *= one.c[k];
  }
  Polynomial2 rows;
  for (int j = 0; j <= e.q; ++j)
    rows.emplace_back(&f.c[f.at(0, j)], &f.c[f.at(e.triangle ? e.p - j : e.p, j)] + 1);
  trim(rows);
  return rows;
}

/// Throws Malformed if a control weight is not positive.
Map map_of(const Element& e) {
  if (!e.rational) return {in_powers(e, e.x), in_powers(e, e.y), {{1}}};
  std::vector<mpz_class> x = e.x, y = e.y, w = e.w;
  for (std::size_t i = 0; i < w.size(); ++i) x[i] *= e.w[i], y[i] *= e.w[i], w[i] *= e.unit;
  const Map map{in_powers(e, x), in_powers(e, y), in_powers(e, w)};
  for (const mpz_class& weight : form(map.w, e.triangle, e.p, e.q).c)
    if (weight <= 0) throw Malformed{"a control weight that is not positive"};
  return map;
}

}  // namespace

Claim check_element(const Element& e, Tokens& tokens) {
  static constexpr std::string_view names[] = {"injective", "regular",  "overlapping", "degenerate",
                                               "folded",    "reversed", "invalid",     "undecided"};
  const auto* name = std::ranges::find(names, tokens.word());
  if (name == std::end(names)) throw Malformed{"unknown claim"};
  const auto claim = static_cast<Claim>(name - names);
  const Map map = map_of(e);
  const Polynomial2 n = jacobian_numerator(map, e.rational);
  const int times = e.rational ? 3 : 2, more = e.triangle ? 0 : 1;
  const std::array<int, 2> degree{times * (e.p - 1) + more, times * (e.q - 1) + more};
  if (claim == Claim::folded) {
    const mpq_class u = tokens.rational(), v = tokens.rational();
    require(in_domain(e.triangle, u, v) && sign_at(n, u, v) < 0, "a negative point");
  } else if (claim != Claim::invalid && claim != Claim::undecided) {
    check_sign(tokens, claim == Claim::reversed ? Polynomial2{} - n : n, e.triangle, degree,
               claim != Claim::degenerate);
  }
  if (claim == Claim::injective) check_injective(tokens, e, map);
  if (claim == Claim::overlapping) check_element_meet(tokens, e);
  if (claim == Claim::degenerate) check_zero(tokens, n, e.triangle, 0);
  if (claim == Claim::folded) check_zero(tokens, n, e.triangle, 1);
  if (claim == Claim::invalid) check_zero(tokens, n, e.triangle, -1);
  tokens.expect_end();
  return claim;
}

}  // namespace verifier
