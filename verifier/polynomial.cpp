// Polynomials by schoolbook formulas on integers: no claim is decided here, but all signs rest on it.
#include "polynomial.hpp"

#include <algorithm>

namespace verifier {

// The three changes of basis are triangles of additions, as Pascal's.
void shear(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count) {
  mpz_class* const line = c.data() + first;
  for (int round = 1; round < count; ++round) {
    for (int k = 1; k <= count - round; ++k) line[k * stride] += line[(k - 1) * stride];
  }
}

void differences(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count) {
  mpz_class* const line = c.data() + first;
  for (int round = 1; round < count; ++round) {
    for (int k = count - 1; k >= round; --k) line[k * stride] -= line[(k - 1) * stride];
  }
}

void newton_to_power(std::vector<mpz_class>& c, std::size_t first, std::ptrdiff_t stride, int count) {
  mpz_class* const line = c.data() + first;
  for (int m = count - 2; m > 0; --m) {
    for (int k = m; k < count - 1; ++k) {
      mpz_submul_ui(line[k * stride].get_mpz_t(), line[(k + 1) * stride].get_mpz_t(),
                    static_cast<unsigned>(m));
    }
  }
}

std::size_t limbs(const std::vector<mpz_class>& c) {
  std::size_t most = 1;
  for (const mpz_class& x : c) most = std::max(most, mpz_size(x.get_mpz_t()));
  return most;
}

std::size_t product_work(std::size_t a, std::size_t b) {
  return 8 + std::max(a, b) * std::min<std::size_t>(std::min(a, b), 32);
}

std::array<int, 3> degrees(const Polynomial2& f) {
  std::array<int, 3> most{0, std::max(0, static_cast<int>(f.size()) - 1), 0};
  for (std::size_t j = 0; j < f.size(); ++j) {
    if (f[j].empty()) continue;
    most[0] = std::max(most[0], static_cast<int>(f[j].size()) - 1);
    most[2] = std::max(most[2], static_cast<int>(f[j].size() + j) - 1);
  }
  return most;
}

static std::size_t size_of(const mpq_class& x) {
  return mpz_size(x.get_num_mpz_t()) + mpz_size(x.get_den_mpz_t());
}

mpq_class value(const Polynomial& f, const mpq_class& x) {
  spend(f.size() * product_work(limbs(f) + f.size() * size_of(x), size_of(x)));
  mpz_class sum, power = 1;
  for (std::size_t i = f.size(); i-- > 0; power *= x.get_den()) sum = sum * x.get_num() + f[i] * power;
  mpq_class result(sum * x.get_den(), power);
  result.canonicalize();
  return result;
}

mpq_class value(const Polynomial2& f, const mpq_class& u, const mpq_class& v) {
  spend(256 * f.size() * f.size() * (size_of(u) * static_cast<std::size_t>(degrees(f)[0]) + size_of(v)));
  mpq_class sum;
  for (std::size_t j = f.size(); j-- > 0;) sum = sum * v + value(f[j], u);
  return sum;
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
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) {
      mpz_addmul(sum[i + j].get_mpz_t(), f[i].get_mpz_t(), g[j].get_mpz_t());
    }
  }
}

Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial product;
  add_product(product, f, g);
  return product;
}

Polynomial2 operator*(const Polynomial2& f, const Polynomial2& g) {
  Polynomial2 product(f.empty() || g.empty() ? 0 : f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) add_product(product[i + j], f[i], g[j]);
  }
  trim(product);
  return product;
}

Polynomial2 operator-(const Polynomial2& f, const Polynomial2& g) {
  Polynomial2 difference = f;
  difference.resize(std::max(f.size(), g.size()));
  for (std::size_t j = 0; j < g.size(); ++j) {
    difference[j].resize(std::max(difference[j].size(), g[j].size()));
    for (std::size_t i = 0; i < g[j].size(); ++i) difference[j][i] -= g[j][i];
  }
  trim(difference);
  return difference;
}

// With low = a / m, high = (a + w) / m: m^degree f((a + w x) / m) = h(a + w x) for h(y) = sum of
// f_i m^(degree - i) y^i.
Polynomial substituted(const Polynomial& f, int degree, const mpq_class& low, const mpq_class& high) {
  const auto d = static_cast<std::size_t>(degree);
  if (f.size() > d + 1) throw Rejected{"degree"};
  if (low == 0 && high == 1) return f;
  spend((d + 1) * f.size() * (limbs(f) + (d + 1) * (size_of(low) + size_of(high))));
  const mpz_class m = lcm(low.get_den(), high.get_den());
  const mpz_class a = low.get_num() * (m / low.get_den());
  const mpz_class w = high.get_num() * (m / high.get_den()) - a;
  Polynomial h = f;
  mpz_class power;
  if (!h.empty()) mpz_pow_ui(power.get_mpz_t(), m.get_mpz_t(), d + 1 - h.size());
  for (std::size_t i = h.size(); i-- > 0; power *= m) h[i] *= power;
  for (std::size_t i = 0; i + 1 < h.size() && a != 0; ++i) {
    for (std::size_t k = h.size() - 1; k-- > i;)
      mpz_addmul(h[k].get_mpz_t(), a.get_mpz_t(), h[k + 1].get_mpz_t());
  }
  power = 1;
  for (mpz_class& x : h) x *= power, power *= w;
  return h;
}

// On [0, 1]: 1 = (1 - x) + x is put into the homogeneous polynomial; what results has binomials as factors.
std::vector<mpz_class> bernstein(const Polynomial& f, int degree, const mpq_class& low,
                                 const mpq_class& high) {
  std::vector<mpz_class> c = substituted(f, degree, low, high);
  c.resize(static_cast<std::size_t>(degree) + 1);
  spend(c.size() * c.size() * limbs(c));
  shear(c, 0, 1, degree + 1);
  return c;
}

// By Gauss' lemma the quotient by a primitive m has integer coefficients, so every step must divide.
bool divisible(const Polynomial& f, const Polynomial& m) {
  if (m.empty()) return false;
  spend((f.size() + m.size()) * product_work(limbs(m), limbs(m)) * 32);
  mpz_class content;
  for (const mpz_class& x : m) content = gcd(content, x);
  Polynomial rest = f, primitive = m;
  for (mpz_class& x : primitive) x /= content;
  for (trim(rest); rest.size() >= m.size(); trim(rest)) {
    if (!mpz_divisible_p(rest.back().get_mpz_t(), primitive.back().get_mpz_t())) return false;
    const mpz_class factor = rest.back() / primitive.back();
    spend(m.size() * product_work(mpz_size(factor.get_mpz_t()), limbs(primitive)));
    for (std::size_t i = 0; i < m.size(); ++i) {
      mpz_submul(rest[rest.size() - m.size() + i].get_mpz_t(), factor.get_mpz_t(), primitive[i].get_mpz_t());
    }
  }
  return rest.empty();
}

Polynomial compose(const Polynomial2& f, const RationalPolynomial& u, const RationalPolynomial& v) {
  std::vector<Polynomial> powers{{1}};  // of u's numerator
  const auto p = static_cast<std::size_t>(degrees(f)[0]);
  spend((p * p + f.size() * f.size()) *
        (mpz_size(u.denominator.get_mpz_t()) + mpz_size(v.denominator.get_mpz_t())));
  for (std::size_t i = 0; i < p; ++i) powers.push_back(powers.back() * u.numerator);
  Polynomial result, u_scales{1};  // u_scales[i] = (denominator of u)^i
  while (u_scales.size() <= p) u_scales.push_back(u_scales.back() * u.denominator);
  mpz_class v_scale = 1;
  for (std::size_t j = f.size(); j-- > 0; v_scale *= v.denominator) {
    result = result * v.numerator;
    for (std::size_t i = 0; i < f[j].size(); ++i) {
      add_product(result, powers[i], {f[j][i] * u_scales[p - i] * v_scale});
    }
  }
  trim(result);
  return result;
}

// Bareiss: every intermediate entry is a minor, so the divisions are exact.
static mpz_class determinant(std::vector<std::vector<mpz_class>> a) {
  const std::size_t size = a.size();
  mpz_class previous = 1;
  bool negative = false;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    while (pivot < size && a[pivot][k] == 0) ++pivot;
    if (pivot == size) return 0;
    if (pivot != k) std::swap(a[pivot], a[k]), negative = !negative;
    const std::size_t l = limbs(a[k]);
    spend((size - k) * (size - k) * product_work(l, l));
    for (std::size_t i = k + 1; i < size; ++i) {
      for (std::size_t j = k + 1; j < size; ++j) {
        a[i][j] *= a[k][k];
        mpz_submul(a[i][j].get_mpz_t(), a[i][k].get_mpz_t(), a[k][j].get_mpz_t());
        mpz_divexact(a[i][j].get_mpz_t(), a[i][j].get_mpz_t(), previous.get_mpz_t());
      }
    }
    previous = a[k][k];
  }
  return negative ? mpz_class(-previous) : previous;
}

// A term of the determinant has m factors f_j and n factors g_k, the sum of all j and k is n m: its degree in
// u is at most m D(f) + n D(g) - n m, D the total degrees, and at most m and n times the degrees in u. So the
// determinants at 0, 1, ... up to this are interpolated.
Polynomial resultant(const Polynomial2& f, int n, const Polynomial2& g, int m) {
  const long n_f = n, m_g = m;
  if (n < 0 || m < 0 || static_cast<int>(f.size()) > n + 1 || static_cast<int>(g.size()) > m + 1)
    throw Rejected{"degree of a resultant"};
  const auto size = static_cast<std::size_t>(n + m);
  const auto [f_u, f_v, f_total] = degrees(f);
  const auto [g_u, g_v, g_total] = degrees(g);
  const long degree =
      std::max(0L, std::min(m_g * f_u + n_f * g_u, m_g * f_total + n_f * g_total - n_f * m_g));
  const auto count = static_cast<std::size_t>(degree) + 1;
  Polynomial r;
  for (mpz_class u = 0; r.size() < count; ++u) {
    spend(size * size * size / 3 + 64 * count);
    const auto at_u = [&](const Polynomial2& h) {
      Polynomial in_v;
      for (const Polynomial& row : h) in_v.push_back(value(row, u).get_num());
      return in_v;
    };
    const Polynomial f_at = at_u(f), g_at = at_u(g);
    std::vector<std::vector<mpz_class>> sylvester(size, std::vector<mpz_class>(size));
    const auto n_rows = static_cast<std::size_t>(n), m_rows = static_cast<std::size_t>(m);
    for (std::size_t row = 0; row < m_rows; ++row) {
      for (std::size_t j = 0; j < f.size(); ++j) sylvester[row][row + n_rows - j] = f_at[j];
    }
    for (std::size_t row = m_rows; row < size; ++row) {
      for (std::size_t j = 0; j < g.size(); ++j) sylvester[row][row - j] = g_at[j];
    }
    r.push_back(determinant(std::move(sylvester)));
  }
  spend(count * count * (limbs(r) + count / 8 + 1));
  differences(r, 0, 1, static_cast<int>(count));
  mpz_class factorial = 1;  // r has integer coefficients in the basis of newton_to_power too
  for (std::size_t k = 1; k < count; ++k) {
    factorial *= static_cast<unsigned long>(k);
    mpz_divexact(r[k].get_mpz_t(), r[k].get_mpz_t(), factorial.get_mpz_t());
  }
  newton_to_power(r, 0, 1, static_cast<int>(count));
  trim(r);
  return r;
}

}  // namespace verifier
