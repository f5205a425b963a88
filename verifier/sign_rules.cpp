// SIGN by Bernstein coefficients on the pieces of a subdivision, by factors, or column by column.
#include "rules.hpp"

#include <algorithm>

namespace verifier {

namespace {

/// `coefficients`.
bool is_positive(const Form& f, bool strict) {
  return std::ranges::all_of(f.c, [](const mpz_class& c) { return c >= 0; }) &&
         (!strict || (f.c.front() > 0 && f.c[f.at(f.p, 0)] > 0 && f.c[f.at(0, f.q)] > 0 && f.c.back() > 0));
}

/// A half after the cut of AB at its middle M: x_A A + x_B B = x A + y M (or x B + y M) is x_A = x + Y, x_B =
/// Y (or exchanged) with Y = y / 2; all times 2^max(p, q).
Form half(Form f, bool second, bool along_v) {
  Form result{f.triangle, f.p, f.q};
  f.lines(along_v, [&](Line line) {
    const int last = line.size - 1;
    const auto turn = [&] {
      for (int k = 0; second && k < last - k; ++k) swap(line[k], line[last - k]);
    };
    turn();
    shear(line);
    for (int k = 0; k <= last; ++k) line[k] <<= std::max(f.p, f.q) - k;
    for (int k = 0; k <= last && f.triangle; ++k)  // (C, A, M) or (B, C, M); C has the exponent p - last
      swap(result.c[f.at(second ? f.p - last : last - k, k)], line[k]);
    turn();
  });
  return f.triangle ? result : f;
}

/// `tree`: takes the one of f from the front of `bits`.
void check_tree(std::string_view& bits, const Form& f, bool strict, int depth = 0) {
  if (bits.empty() || depth > 512) throw Malformed{"not a tree, or deeper than 512"};
  const bool leaf = bits.front() == '0';
  bits.remove_prefix(1);
  if (leaf) return require(is_positive(f, strict), "coefficients");
  for (const bool second : {false, true})
    check_tree(bits, half(f, second, !f.triangle && depth % 2 == 1), strict, depth + 1);
}

/// The sign of the rational c != 0 for which f = c g; 0 if there is none. g is not 0.
int ratio(const Polynomial2& f, const Polynomial2& g) {
  if (f.empty() || f.back().empty()) return 0;
  const mpz_class &a = f.back().back(), &b = g.back().back();
  return f * Polynomial2{{b}} == g * Polynomial2{{a}} ? sgn(a) * sgn(b) : 0;
}

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

/// f > 0 on the square, shown on it or on its halves, quarters, ... across u, at most 4096 pieces.
void check_strip(const Form& f) {
  std::vector<Form> rest{f};
  for (int pieces = 1; !rest.empty();) {
    const Form piece = std::move(rest.back());
    rest.pop_back();
    if (is_positive(piece, true)) continue;
    require(piece.c.front() > 0 && piece.c.back() > 0 && ++pieces <= 4096, "f on a column or slab");
    for (const bool second : {false, true}) rest.push_back(half(piece, second, false));
  }
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
    for (const Polynomial& factor : s) require(sign_at(factor, u) != 0, "a column over a root");
    check_strip(form({compose(f, constant(u), {{0, 1}, 1})}, false, n, 0));
  }
  c.push_back(1);
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    if (strict && tokens.accept("slab")) {
      Polynomial2 slab;
      for (const Polynomial& row : f) slab.push_back(compose(row, degrees(f)[0], onto(c[i], c[i + 1])));
      check_strip(form(exchanged(slab), false, n, degrees(f)[0]));
      continue;
    }
    const bool open = tokens.accept("open"), at_end = i == 0 || i + 2 == c.size();
    if (!open && !tokens.accept("root")) throw Malformed{"expected open, root or slab"};
    int variations = 0;
    for (const Polynomial& factor : s) {
      Integers b = bernstein(factor, c[i], c[i + 1]);
      std::erase(b, 0);
      for (std::size_t k = 1; k < b.size(); ++k) variations += sgn(b[k - 1]) != sgn(b[k]);
      require(!strict || (sign_at(factor, c[i]) != 0 && sign_at(factor, c[i + 1]) != 0), "a root at the end");
    }
    require(open ? variations == 0 : !strict && !at_end && variations <= 1, "roots between columns");
  }
}

}  // namespace

void check_sign(Tokens& tokens, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors) {
  if (const bool one = tokens.accept("coefficients"); one || tokens.accept("tree")) {
    std::string_view bits = one ? "0" : tokens.bits();
    if (bits.size() > 1 << 16 || (bits == "0" && !one))
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

}  // namespace verifier
