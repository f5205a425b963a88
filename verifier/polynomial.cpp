// Polynomials by schoolbook formulas on integers: no claim is decided here, but all signs rest on it.
#include "polynomial.hpp"

#include <algorithm>

namespace verifier {

std::size_t limbs(const Integers& c) {
  std::size_t most = 1;
  for (const mpz_class& x : c) most = std::max(most, mpz_size(x.get_mpz_t()));
  return most;
}

std::size_t product_work(std::size_t a, std::size_t b) {
  return 8 + std::max(a, b) * std::min<std::size_t>(std::min(a, b), 32);
}

mpq_class fraction(const mpz_class& a, const mpz_class& b) {
  spend(1024 * (1 + mpz_size(a.get_mpz_t()) + mpz_size(b.get_mpz_t())));  // a gcd
  mpq_class value(a, b);
  value.canonicalize();
  return value;
}

// The changes of basis are triangles of additions, as Pascal's.
static void spend_triangle(Line c) {
  std::size_t most = 1;
  for (int k = 0; k < c.size; ++k) most = std::max(most, mpz_size(c[k].get_mpz_t()));
  const auto size = static_cast<std::size_t>(c.size);
  spend(size * size * (most + size / 64));
}

void shear(Line c, bool minus) {
  spend_triangle(c);
  for (int end = c.size; end > 1; --end)
    for (int k = 1; k < end; ++k) minus ? c[k] -= c[k - 1] : c[k] += c[k - 1];
}

void differences(Line c) {
  spend_triangle(c);
  for (int first = 1; first < c.size; ++first)
    for (int k = c.size - 1; k >= first; --k) c[k] -= c[k - 1];
}

void newton_to_power(Line c, int degree, int unit) {
  mpz_class factor = 1;
  for (int k = degree; k >= 0; factor *= k--)
    if (k < c.size) c[k] *= factor;
  spend_triangle(c);
  for (int m = c.size - 2; m > 0; --m)
    for (int k = m; k < c.size - 1; ++k) mpz_submul_ui(c[k].get_mpz_t(), c[k + 1].get_mpz_t(), m);
  factor = 1;
  for (int k = 0; k < c.size; ++k, factor *= unit) c[k] *= factor;
}

std::array<int, 3> degrees(const Polynomial2& f) {
  std::array<int, 3> most{};
  for (int j = 0; j < std::ssize(f); ++j) {
    const int i = static_cast<int>(f[j].size()) - 1;
    if (i >= 0) most = {std::max(most[0], i), j, std::max(most[2], i + j)};
  }
  return most;
}

void trim(Polynomial& f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
}

void trim(Polynomial2& f) {
  for (Polynomial& row : f) trim(row);
  while (!f.empty() && f.back().empty()) f.pop_back();
}

static void add_product(Polynomial& sum, const Polynomial& f, const Polynomial& g) {
  if (f.empty() || g.empty()) return;
  spend(f.size() * g.size() * product_work(limbs(f), limbs(g)));
  if (sum.size() < f.size() + g.size() - 1) sum.resize(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j)
      mpz_addmul(sum[i + j].get_mpz_t(), f[i].get_mpz_t(), g[j].get_mpz_t());
}

Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial product;
  add_product(product, f, g);
  return product;
}

Polynomial2 operator*(const Polynomial2& f, const Polynomial2& g) {
  Polynomial2 product(f.empty() || g.empty() ? 0 : f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) add_product(product[i + j], f[i], g[j]);
  trim(product);
  return product;
}

Polynomial2 operator-(Polynomial2 f, const Polynomial2& g) {
  f.resize(std::max(f.size(), g.size()));
  for (std::size_t j = 0; j < g.size(); ++j) add_product(f[j], g[j], {-1});
  trim(f);
  return f;
}

Polynomial2 derivative(const Polynomial2& f, bool by_v) {
  Polynomial2 d(f.begin() + (by_v && !f.empty()), f.end());
  for (std::size_t j = 0; j < d.size(); ++j) {
    if (!by_v && !d[j].empty()) d[j].erase(d[j].begin());
    for (std::size_t i = 0; i < d[j].size(); ++i) d[j][i] *= (by_v ? j : i) + 1;
  }
  trim(d);
  return d;
}

Polynomial2 exchanged(const Polynomial2& f) {
  Polynomial2 result(degrees(f)[0] + 1, Polynomial(f.size()));
  for (std::size_t j = 0; j < f.size(); ++j)
    for (std::size_t i = 0; i < f[j].size(); ++i) result[i][j] = f[j][i];
  trim(result);
  return result;
}

Polynomial compose(const Polynomial& f, int degree, const RationalPolynomial& u) {
  require(std::ssize(f) <= degree + 1, "degree");
  Polynomial result, power{1};  // of the denominator
  for (int i = degree; i >= 0; --i, power = power * Polynomial{u.denominator}) {
    result = result * u.numerator;
    if (i < std::ssize(f)) add_product(result, power, {f[i]});
  }
  return result;
}

Polynomial compose(const Polynomial2& f, const RationalPolynomial& u, const RationalPolynomial& v) {
  const int degree_u = degrees(f)[0];
  Polynomial result, power{1};
  for (std::size_t j = f.size(); j-- > 0; power = power * Polynomial{v.denominator}) {
    result = result * v.numerator;
    add_product(result, power, compose(f[j], degree_u, u));
  }
  trim(result);
  return result;
}

Form form(const Polynomial2& f, bool triangle, int p, int q) {
  const auto [f_u, f_v, f_total] = degrees(f);
  require(triangle ? f_total <= p && p == q : f_u <= p && f_v <= q, "degree");
  Form result{triangle, p, q};
  for (int j = 0; j < std::ssize(f); ++j) std::copy(f[j].begin(), f[j].end(), &result.c[result.at(0, j)]);
  for (const bool along_v : {false, true})
    result.lines(along_v, [](Line line) { shear(line); });  // 1 = (1 - u - v) + u + v
  return result;
}

RationalPolynomial constant(const mpq_class& x) { return {{x.get_num()}, x.get_den()}; }

RationalPolynomial onto(const mpq_class& low, const mpq_class& high) {
  const mpz_class m = lcm(low.get_den(), high.get_den()), begin = m / low.get_den() * low.get_num();
  return {{begin, m / high.get_den() * high.get_num() - begin}, m};
}

// On [0, 1]: 1 = (1 - x) + x is put into the homogeneous polynomial.
Integers bernstein(const Polynomial& f, const mpq_class& low, const mpq_class& high) {
  if (f.empty()) return {0};
  Integers c = compose(f, static_cast<int>(f.size()) - 1, onto(low, high));
  c.resize(f.size());
  shear(line(c));
  return c;
}

int sign_at(const Polynomial& f, const mpq_class& x) { return sgn(bernstein(f, x, x)[0]); }

bool one_strict_sign(const Integers& c) {
  return std::all_of(c.begin(), c.end(), [&](const mpz_class& z) { return sgn(z) * sgn(c[0]) > 0; });
}

bool divisible(Polynomial f, const Polynomial& m) {
  if (m.empty()) return false;
  for (trim(f); f.size() >= m.size(); trim(f)) {
    spend(2 * f.size() * product_work(limbs(f), limbs(m)));
    const mpz_class top = f.back();
    for (mpz_class& c : f) c *= m.back();
    for (std::size_t i = 0; i < m.size(); ++i) f[f.size() - m.size() + i] -= top * m[i];
  }
  return f.empty();
}

// Bareiss: every intermediate entry is a minor, so the divisions are exact.
static mpz_class determinant(std::vector<Polynomial> a) {
  mpz_class previous = 1;
  int sign = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto pivot = std::find_if(a.begin() + k, a.end(), [&](const auto& row) { return row[k] != 0; });
    if (pivot == a.end()) return 0;
    if (pivot != a.begin() + k) std::swap(*pivot, a[k]), sign = -sign;
    std::size_t size = 1;
    for (const Polynomial& row : a) size = std::max(size, limbs(row));
    spend((a.size() - k) * (a.size() - k) * product_work(size, size));
    for (std::size_t i = k + 1; i < a.size(); ++i)
      for (std::size_t j = k + 1; j < a.size(); ++j)
        a[i][j] = (a[i][j] * a[k][k] - a[i][k] * a[k][j]) / previous;
    previous = a[k][k];
  }
  return sign * previous;
}

// A term of the determinant has m factors f_j and n factors g_k, the sum of all j and k is n m. So its degree
// in u is at most m and n times the degrees in u, and the same of the total degrees less n m. Its values at
// 0, 1, ... up to this are interpolated.
Polynomial resultant(const Polynomial2& f, int n, const Polynomial2& g, int m) {
  const auto [f_u, f_v, f_total] = degrees(f);
  const auto [g_u, g_v, g_total] = degrees(g);
  const int degree = std::max(0, std::min(m * f_u + n * g_u, m * f_total + n * g_total - n * m));
  const RationalPolynomial v{{0, 1}, 1};
  Polynomial r;
  for (int u = 0; u <= degree; ++u) {
    const Polynomial f_at = compose(f, constant(u), v), g_at = compose(g, constant(u), v);
    std::vector<Polynomial> sylvester(n + m, Polynomial(n + m));
    for (int row = 0; row < n + m; ++row) {
      const Polynomial& h = row < m ? f_at : g_at;
      for (int j = 0; j < std::ssize(h); ++j) sylvester[row][row + (row < m ? n : 0) - j] = h[j];
    }
    r.push_back(determinant(std::move(sylvester)));
  }
  differences(line(r));
  newton_to_power(line(r), degree, 1);
  trim(r);
  return r;
}

}  // namespace verifier
