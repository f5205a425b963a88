// Claims of elements: N in the power basis, its sign on parts of the domain, its zeros, injectivity.
#include "element_rules.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "pair_rules.hpp"

namespace verifier {

namespace {

/// f on a piece of its domain as a homogeneous polynomial in the piece's barycentric coordinates (squares:
/// those of u, and those of v). Coefficients are Bernstein coefficients times multinomials, so they have
/// their signs. c[at(i, j)] has the exponents i of corner 1 (u) and j of corner 2 (v); if i + j > p = q on a
/// triangle, it is 0.
struct Form {
  bool triangle;
  int p, q;
  std::vector<mpz_class> c = std::vector<mpz_class>(at(0, q + 1));

  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j * (p + 1) + i); }
  int last_u(int j) const { return triangle ? p - j : p; }
  int last_v(int i) const { return triangle ? q - i : q; }
  std::size_t work() const { return c.size() * static_cast<std::size_t>(p + q + 1) * limbs(c); }
  /// Visits (c, first, stride, count) of all lines along u, then of those along v.
  template <class Visit>
  void lines(Visit visit) {
    spend(work());
    for (int j = 0; j <= q; ++j) visit(c, at(0, j), 1, last_u(j) + 1);
    for (int i = 0; i <= p; ++i) visit(c, at(i, 0), p + 1, last_v(i) + 1);
  }
  struct Place {
    int i, j;
    std::size_t at;
  };
  /// All coefficients, in the order of the points in Element.
  std::vector<Place> places() const {
    std::vector<Place> all;
    for (int j = 0; j <= q; ++j) {
      for (int i = 0; i <= last_u(j); ++i) all.push_back({i, j, at(i, j)});
    }
    return all;
  }
};

/// On the whole domain: 1 = (1 - u - v) + u + v is put into f.
Form form(const Polynomial2& f, bool triangle, int p, int q) {
  const auto [f_u, f_v, f_total] = degrees(f);
  require(triangle ? f_total <= p && p == q : f_u <= p && f_v <= q, "degree");
  spend(static_cast<std::size_t>(p + 1) * static_cast<std::size_t>(q + 1));
  Form result{triangle, p, q};
  for (int j = 0; j <= f_v && !f.empty(); ++j)
    std::ranges::copy(f[static_cast<std::size_t>(j)], &result.c[result.at(0, j)]);
  result.lines(shear);
  return result;
}

/// `coefficients`.
bool is_positive(const Form& f, bool strict) {
  if (std::ranges::any_of(f.c, [](const mpz_class& c) { return c < 0; })) return false;
  return !strict ||
         (f.c[0] > 0 && f.c[f.at(f.p, 0)] > 0 && f.c[f.at(0, f.q)] > 0 && (f.triangle || f.c.back() > 0));
}

/// A half after the cut of AB at its middle M: x_A A + x_B B = x A + y M (or x B + y M) is x_A = x + Y, x_B =
/// Y (or exchanged) with Y = y / 2.
Form half(Form f, bool second, bool along_v) {
  Form result{f.triangle, f.p, f.q};
  spend(f.work());
  for (int line = 0; line <= (along_v ? f.p : f.q); ++line) {
    const int last = along_v ? f.last_v(line) : f.last_u(line);
    const auto at = [&](int k) {  // k is the exponent of Y
      const int i = second ? last - k : k;
      return along_v ? f.at(line, i) : f.at(i, line);
    };
    shear(f.c, at(0), (second ? -1 : 1) * (along_v ? f.p + 1 : 1), last + 1);
    for (int k = 0; k <= last;
         ++k) {  // triangle: `line` is the exponent of C; halves are (C, A, M), (B, C, M)
      mpz_class& c = result.c[f.triangle ? f.at(second ? line : last - k, k) : at(k)];
      mpz_mul_2exp(c.get_mpz_t(), f.c[at(k)].get_mpz_t(),
                   static_cast<unsigned>((f.triangle ? f.p : last) - k));
    }
  }
  return result;
}

/// `tree`: bits[at] ... are one of f; moves `at` behind it.
void check_tree(std::string_view bits, std::size_t& at, const Form& f, bool strict, int depth = 0) {
  if (at == bits.size() || depth > 512) throw Malformed{"not a tree, or too deep"};
  if (bits[at++] == '0') return require(is_positive(f, strict), "a leaf of a tree");
  for (const bool second : {false, true})
    check_tree(bits, at, half(f, second, !f.triangle && depth % 2 == 1), strict, depth + 1);
}

void check_tree(std::string_view bits, const Form& f, bool strict) {
  if (bits.size() > std::size_t{1} << 16) throw Malformed{"limit: a tree of more than 2^16 pieces"};
  std::size_t at = 0;
  check_tree(bits, at, f, strict);
  if (at != bits.size()) throw Malformed{"more than a tree"};
}

/// f = c g for a rational c that is not 0; of this sign, if not 0. Neither f nor g has leading zeros.
bool proportional(const Polynomial2& f, const Polynomial2& g, int sign) {
  if (f.empty() || f.back().empty() || f.size() != g.size()) return false;
  for (std::size_t j = 0; j < f.size(); ++j) {
    if (f[j].size() != g[j].size()) return false;
    spend(64 * f[j].size() * (limbs(f[j]) + limbs(g[j]) + limbs({f.back().back(), g.back().back()})));
    for (std::size_t i = 0; i < f[j].size(); ++i) {
      if (f[j][i] * g.back().back() != g[j][i] * f.back().back()) return false;
    }
  }
  return sign == 0 || sgn(f.back().back()) * sgn(g.back().back()) == sign;
}

Polynomial2 negative(const Polynomial2& f) { return Polynomial2{} - f; }

Polynomial2 derivative(const Polynomial2& f, bool by_v) {
  Polynomial2 d(f.begin() + (by_v && !f.empty()), f.end());
  for (std::size_t j = 0; j < d.size(); ++j) {
    if (!by_v && !d[j].empty()) d[j].erase(d[j].begin());
    for (std::size_t i = 0; i < d[j].size(); ++i) d[j][i] *= (by_v ? j : i) + 1;
  }
  trim(d);
  return d;
}

void check_sign(Tokens&, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors = true);

void check_factors(Tokens& tokens, const Polynomial2& f, bool triangle, bool strict) {
  Polynomial2 product{{1}};
  int sign = 1;
  for (long k = tokens.small(1, 4096); k > 0; --k) {
    const long exponent = tokens.small(1, 4096);
    const Polynomial2 h = tokens.polynomial2();
    const auto [h_u, h_v, h_total] = degrees(h);
    if (h_total == 0) throw Malformed{"a constant factor"};
    for (long i = 0; i < exponent; ++i, product = product * h) {
      require(degrees(product)[0] + h_u <= degrees(f)[0] && degrees(product)[1] + h_v <= degrees(f)[1],
              "degree of factors");
    }
    if (tokens.accept("none")) {
      require(exponent % 2 == 0 && !strict, "a factor without proof");
      continue;
    }
    const bool minus = tokens.accept("-");
    if (!minus && !tokens.accept("+")) throw Malformed{"expected none, + or -"};
    const std::array<int, 2> degree{triangle ? h_total : h_u, triangle ? h_total : h_v};
    check_sign(tokens, minus ? negative(h) : h, triangle, degree, strict, false);
    if (minus && exponent % 2 == 1) sign = -sign;
  }
  require(proportional(f, product, sign), "the product of the factors, or its sign");
}

/// A list E of exponents: f = const * prod s_i^E_i.
void check_exponents(Tokens& tokens, const Polynomial& f, const std::vector<Polynomial>& s) {
  std::string_view list = tokens.word();
  if (s.empty() && list != "-") throw Malformed{"expected -"};
  Polynomial product{1};
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::string_view number = list.substr(0, list.find(','));
    if ((number.size() < list.size()) != (i + 1 < s.size())) throw Malformed{"number of exponents"};
    list.remove_prefix(std::min(list.size(), number.size() + 1));
    for (long e = Tokens(number).small(0, 1 << 20); e > 0; --e, product = product * s[i]) {
      require(product.size() + s[i].size() <= f.size() + 1, "exponents of columns");
    }
  }
  require(proportional({f}, {product}, 0), "roots of columns");
}

/// f > 0 on the domain, or on its halves, quarters, ... across u (or v) alone.
void check_halves(const Form& f, bool across_v) {
  std::vector<Form> open{f};
  for (int pieces = 1; !open.empty();) {
    const Form piece = std::move(open.back());
    open.pop_back();
    if (is_positive(piece, true)) continue;
    require(piece.c.front() > 0 && piece.c.back() > 0 && ++pieces <= 4096, "f on a column or slab");
    for (const bool second : {true, false}) open.push_back(half(piece, second, across_v));
  }
}

void check_columns(Tokens& tokens, Polynomial2 f, bool triangle, bool strict) {
  if (tokens.accept("v")) {
    Polynomial2 exchanged(static_cast<std::size_t>(degrees(f)[0]) + 1, Polynomial(f.size()));
    for (std::size_t j = 0; j < f.size(); ++j) {
      for (std::size_t i = 0; i < f[j].size(); ++i) exchanged[i][j] = f[j][i];
    }
    trim(f = exchanged);
  } else if (!tokens.accept("u")) {
    throw Malformed{"expected u or v"};
  }
  require(f.size() >= 2, "columns of a polynomial without v");
  const int n = static_cast<int>(f.size()) - 1;
  const Polynomial top = triangle ? Polynomial{1, -1} : Polynomial{1};
  std::vector<Polynomial> s(static_cast<std::size_t>(tokens.small(0, 4096)));
  for (Polynomial& factor : s) {
    if ((factor = tokens.polynomial()).size() < 2) throw Malformed{"a constant for columns"};
  }
  check_exponents(tokens, f.back(), s);
  check_exponents(tokens, f.front(), s);
  check_exponents(tokens, compose(f, {{0, 1}, 1}, {top, 1}), s);
  check_exponents(tokens, resultant(f, n, derivative(f, true), n - 1), s);

  // g(u, t) = f(u, t top(u)) on the unit square, and its part over [low, high].
  Polynomial2 g = f;
  Polynomial power{1};
  for (Polynomial& row : g) row = row * power, power = power * top;
  const int g_u = degrees(g)[0];
  const auto part = [&](const mpq_class& low, const mpq_class& high) {
    Polynomial2 rows;
    for (const Polynomial& row : g) rows.push_back(substituted(row, g_u, low, high));
    trim(rows);
    return rows;
  };
  std::vector<mpq_class> c{0};
  for (long k = tokens.small(1, 1 << 16); k > 0; --k) {
    c.push_back(tokens.rational());
    require(c[c.size() - 2] < c.back() && c.back() < 1, "order of columns");
    for (const Polynomial& factor : s) require(value(factor, c.back()) != 0, "a column over a root");
    Polynomial column;
    for (const Polynomial& row : part(c.back(), c.back()))
      column.push_back(row.empty() ? mpz_class() : row[0]);
    check_halves(form({column}, false, static_cast<int>(column.size()) - 1, 0), false);
  }
  c.push_back(1);
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    if (strict && tokens.accept("slab")) {
      check_halves(form(part(c[i], c[i + 1]), false, g_u, n), true);
      continue;
    }
    const bool open = tokens.accept("open"), first = i == 0, last = i + 2 == c.size();
    if (!open && !tokens.accept("root")) throw Malformed{"expected open, root or slab"};
    int variations = 0;
    for (const Polynomial& factor : s) {
      int sign = 0;
      for (const mpz_class& b : bernstein(factor, static_cast<int>(factor.size()) - 1, c[i], c[i + 1])) {
        variations += sgn(b) * sign < 0;
        if (b != 0) sign = sgn(b);
      }
      if (strict)
        require(!(first && factor[0] == 0) && !(last && value(factor, 1) == 0), "a root at the end");
    }
    require(open ? variations == 0 : !strict && !first && !last && variations <= 1, "roots between columns");
  }
}

/// SIGN: f > 0, or f >= 0 if not strict, on the domain. `degree` is for `coefficients` and `tree`.
void check_sign(Tokens& tokens, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors) {
  if (tokens.accept("coefficients")) {
    require(is_positive(form(f, triangle, degree[0], degree[1]), strict), "coefficients");
  } else if (tokens.accept("tree")) {
    const std::string_view bits = tokens.bits();
    if (bits == "0") throw Malformed{"a tree without a cut"};
    check_tree(bits, form(f, triangle, degree[0], degree[1]), strict);
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

/// ZERO; at a rational point N may have the sign `also` as well.
void check_zero(Tokens& tokens, const Polynomial2& n, bool triangle, int also) {
  std::vector<Polynomial2> sides{{{0, 1}}, {{}, {1}}, {{1, -1}, {-1}}};  // all are >= 0 in the domain only
  if (!triangle) sides = {{{0, 1}}, {{}, {1}}, {{1, -1}}, {{1}, {-1}}};
  if (tokens.accept("at")) {
    const mpq_class u = tokens.rational(), v = tokens.rational(), at = value(n, u, v);
    return require(in_domain(triangle, u, v) && (at == 0 || sgn(at) == also), "the sign at a point");
  }
  if (!tokens.accept("root")) throw Malformed{"expected at or root"};
  const Polynomial m = tokens.polynomial();
  const mpq_class low = tokens.rational(), high = tokens.rational();
  const RationalPolynomial u = tokens.rational_polynomial(), v = tokens.rational_polynomial();
  require(m.size() >= 3 && low < high && sgn(value(m, low)) * sgn(value(m, high)) < 0, "a root of m");
  require(divisible(compose(n, u, v), m), "N at the root");
  for (const Polynomial2& side : sides) {
    const Polynomial at = compose(side, u, v);
    if (divisible(at, m)) continue;
    for (const mpz_class& b : bernstein(at, static_cast<int>(at.size()) - 1, low, high))
      require(b >= 0, "a root outside");
  }
}

/// N = [P P_u P_v], or X_u Y_v - X_v Y_u if W is constant.
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
    return form(e.rational ? d * map.w - x * derivative(map.w, by_v) : d, e.triangle, p, q);
  };
  const Form ax = column(map.x, false), ay = column(map.y, false), bx = column(map.x, true),
             by = column(map.y, true);
  const auto places = ax.places();
  const std::size_t size = std::max({limbs(ax.c), limbs(ay.c), limbs(bx.c), limbs(by.c)});
  mpz_class mixed;
  for (const auto& [i_u, i_v, i] : places) {
    spend(places.size() * 2 * product_work(size, size));
    for (const auto& [j_u, j_v, j] : places) {
      if (j > i) break;
      mpz_mul(mixed.get_mpz_t(), ax.c[i].get_mpz_t(), by.c[j].get_mpz_t());
      mpz_submul(mixed.get_mpz_t(), ay.c[i].get_mpz_t(), bx.c[j].get_mpz_t());
      mpz_addmul(mixed.get_mpz_t(), ax.c[j].get_mpz_t(), by.c[i].get_mpz_t());
      mpz_submul(mixed.get_mpz_t(), ay.c[j].get_mpz_t(), bx.c[i].get_mpz_t());
      require(i == j ? mixed > 0 : mixed >= 0, "hull");
    }
  }
}

void check_orientation(const Element& e, const Map& map) {
  require(e.triangle, "orientation of a quadrilateral");
  const int n = e.p;
  const Form x = form(map.x, true, n, n), y = form(map.y, true, n, n), w = form(map.w, true, n, n);
  const auto l = x.places();
  const std::size_t size = std::max({limbs(x.c), limbs(y.c), limbs(w.c)});
  for (auto a = l.begin(); a != l.end(); ++a) {
    for (auto b = a + 1; b != l.end(); ++b) {
      const auto minor = [&](const Form& f, const Form& g) {
        return mpz_class(f.c[a->at] * g.c[b->at] - g.c[a->at] * f.c[b->at]);
      };
      const mpz_class yw = minor(y, w), wx = minor(w, x), xy = minor(x, y);
      spend(l.size() * 6 * product_work(size, size));
      for (auto c = b + 1; c != l.end(); ++c) {
        // 1/n of the determinant of the three indices, whose components have the sum n.
        const int det = (b->i - a->i) * (c->j - a->j) - (b->j - a->j) * (c->i - a->i);
        if (det == 0) continue;
        const int orientation = sgn(mpz_class(yw * x.c[c->at] + wx * y.c[c->at] + xy * w.c[c->at]));
        // Corner triples are those with the sum (3n - 2, 1, 1), in some order.
        const int i = a->i + b->i + c->i, j = a->j + b->j + c->j,
                  least = i * j * (3 * n - i - j) == 3 * n - 2;
        require((det > 0 ? orientation : -orientation) >= least, "orientation");
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
  if (std::min(first, second) < 0 || std::max(first, second) >= m) throw Malformed{"no such edge"};
  MeetContext context{edge_curve(e, first), edge_curve(e, second), first == second};
  context.common[1][0] = second == (first + 1) % m;
  context.common[0][1] = first == (second + 1) % m;
  check_meet(meet, context);
}

struct Factors {
  std::vector<mpz_class> differences, powers;
};

/// The factors of in_powers, the same for all elements of one shape.
const Factors& factors_of(const Element& e, const std::vector<Form::Place>& places) {
  static std::map<std::tuple<bool, bool, int, int>, Factors> known;
  const auto [entry, fresh] = known.try_emplace({e.triangle, e.lagrange, e.p, e.q});
  for (std::size_t k = 0; fresh && k < places.size(); ++k) {
    const auto& [i, j, at] = places[k];
    const auto factorial = [](int n) { return mpz_class::factorial(n); };
    mpz_class f = factorial(e.p) * (e.triangle ? mpz_class(1) : factorial(e.q)) /
                  (factorial(i) * factorial(j)),
              power;
    if (!e.lagrange)
      f /= e.triangle ? factorial(e.p - i - j) : mpz_class(factorial(e.p - i) * factorial(e.q - j));
    entry->second.differences.push_back(f);
    mpz_ui_pow_ui(power.get_mpz_t(), static_cast<unsigned>(e.p), static_cast<unsigned>(i));
    mpz_ui_pow_ui(f.get_mpz_t(), static_cast<unsigned>(e.q), static_cast<unsigned>(j));
    entry->second.powers.push_back(f * power);
  }
  return entry->second;
}

/// The polynomial with these control points, or these values at the nodes times p! (triangles) or p! q!: the
/// (i, j)-th difference at the first point is the coefficient of u^i v^j but for the multinomial, or of C(p
/// u, i) C(q v, j).
Polynomial2 in_powers(const Element& e, const std::vector<mpz_class>& values) {
  Form f{e.triangle, e.p, e.q};
  const auto places = f.places();
  if (values.size() != places.size()) throw Malformed{"number of points"};
  for (std::size_t k = 0; k < values.size(); ++k) f.c[places[k].at] = values[k];
  f.lines(differences);
  const Factors& factors = factors_of(e, places);
  for (std::size_t k = 0; k < values.size(); ++k) f.c[places[k].at] *= factors.differences[k];
  if (e.lagrange) {
    f.lines(newton_to_power);
    for (std::size_t k = 0; k < values.size(); ++k) f.c[places[k].at] *= factors.powers[k];
  }
  Polynomial2 rows;
  for (int j = 0; j <= e.q; ++j) rows.emplace_back(&f.c[f.at(0, j)], &f.c[f.at(0, j)] + f.last_u(j) + 1);
  trim(rows);
  return rows;
}

}  // namespace

Map map_of(const Element& e) {
  if (e.x.size() != e.w.size() || e.y.size() != e.w.size()) throw Malformed{"number of points"};
  std::vector<mpz_class> x = e.x, y = e.y, w(e.w.size(), e.unit);
  for (std::size_t i = 0; e.rational && i < w.size(); ++i) x[i] *= e.w[i], y[i] *= e.w[i], w[i] *= e.w[i];
  Map map{in_powers(e, x), in_powers(e, y), in_powers(e, w)};
  const Form control = form(map.w, e.triangle, e.p, e.q);
  for (const auto& [i, j, at] : control.places()) {
    if (control.c[at] <= 0) throw Malformed{"a control weight that is not positive"};
  }
  return map;
}

Claim check_element(const Element& e, Tokens& tokens) {
  static constexpr std::string_view names[] = {"injective", "regular",  "overlapping", "degenerate",
                                               "folded",    "reversed", "invalid",     "undecided"};
  const auto* name = std::find(std::begin(names), std::end(names), tokens.word());
  if (name == std::end(names)) throw Malformed{"unknown claim"};
  const auto claim = static_cast<Claim>(name - names);
  const Map map = map_of(e);
  const Polynomial2 n = jacobian_numerator(map, e.rational);
  const int times = e.rational ? 3 : 2, more = e.triangle ? 0 : 1;
  const std::array<int, 2> degree{times * (e.p - 1) + more, times * (e.q - 1) + more};
  if (claim == Claim::folded) {
    const mpq_class u = tokens.rational(), v = tokens.rational();
    require(in_domain(e.triangle, u, v) && value(n, u, v) < 0, "a negative point");
  } else if (claim != Claim::invalid && claim != Claim::undecided) {
    check_sign(tokens, claim == Claim::reversed ? negative(n) : n, e.triangle, degree,
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
