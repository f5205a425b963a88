#include "bezcert/algebra/bivariate.hpp"

#include "bezcert/algebra/flint_types.hpp"
#include "bezcert/bernstein/multinomial.hpp"

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

// FLINT's sparse polynomials in (u, v).
struct Context {
  fmpz_mpoly_ctx_t value;

  Context() {
    expect_rounding_to_nearest();
    fmpz_mpoly_ctx_init(value, 2, ORD_LEX);
  }
  ~Context() { fmpz_mpoly_ctx_clear(value); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

struct Sparse {
  const Context& context;
  fmpz_mpoly_t value;

  explicit Sparse(const Context& c) : context(c) { fmpz_mpoly_init(value, c.value); }
  Sparse(const Context& c, const Bivariate& f) : Sparse(c) {
    for (std::size_t k = 0; k < f.by_v.size(); ++k) {
      for (std::size_t i = 0; i < f.by_v[k].coefficients.size(); ++i) {
        const FlintInteger coefficient(f.by_v[k].coefficients[i]);
        const ulong exponents[2] = {static_cast<ulong>(i), static_cast<ulong>(k)};
        fmpz_mpoly_set_coeff_fmpz_ui(value, coefficient.value, exponents, c.value);
      }
    }
  }
  ~Sparse() { fmpz_mpoly_clear(value, context.value); }
  Sparse(const Sparse&) = delete;
  Sparse& operator=(const Sparse&) = delete;
};

Bivariate to_bivariate(const fmpz_mpoly_t f, const Context& context) {
  std::vector<std::vector<Integer>> rows;
  FlintInteger coefficient;
  for (slong i = 0; i < fmpz_mpoly_length(f, context.value); ++i) {
    ulong exponents[2];
    fmpz_mpoly_get_term_exp_ui(exponents, f, i, context.value);
    fmpz_mpoly_get_term_coeff_fmpz(coefficient.value, f, i, context.value);
    if (rows.size() <= exponents[1]) rows.resize(exponents[1] + 1);
    auto& row = rows[exponents[1]];
    if (row.size() <= exponents[0]) row.resize(exponents[0] + 1, 0);
    row[exponents[0]] = to_integer(coefficient.value);
  }
  std::vector<Univariate> by_v;
  for (auto& row : rows) by_v.emplace_back(std::move(row));
  return Bivariate(std::move(by_v));
}

}  // namespace

Bivariate::Bivariate(std::vector<Univariate> coefficients) : by_v(std::move(coefficients)) {
  while (!by_v.empty() && by_v.back().is_zero()) by_v.pop_back();
}

int Bivariate::degree_u() const {
  int degree = -1;
  for (const Univariate& c : by_v) degree = std::max(degree, c.degree());
  return degree;
}

Bivariate to_power_basis(const Polynomial<Integer>& f) {
  const int p = f.shape.degree(0);
  std::vector<Univariate> by_v;
  if (f.shape.domain == Domain::square) {
    // Each column to powers of v, then each row of those to powers of u.
    std::vector<std::vector<Integer>> rows(static_cast<std::size_t>(f.shape.degree(1)) + 1,
                                           std::vector<Integer>(static_cast<std::size_t>(p) + 1, 0));
    for (int c = 0; c <= p; ++c) {
      std::vector<Integer> line;
      for (int r = 0; r <= f.shape.degree(1); ++r) line.push_back(f.at(r, c));
      const Univariate powers = from_bernstein(line);
      for (std::size_t k = 0; k < powers.coefficients.size(); ++k) {
        rows[k][static_cast<std::size_t>(c)] = powers.coefficients[k];
      }
    }
    for (const auto& row : rows) by_v.push_back(from_bernstein(row));
    return Bivariate(std::move(by_v));
  }
  // The coefficient of u^i v^k is p! / (i! k! (p-i-k)!) times the mixed difference at corner 0.
  for (int k = 0; k <= p; ++k) {
    std::vector<Integer> row;
    for (int i = 0; i + k <= p; ++i) {
      Integer sum = 0;
      for (int r = 0; r <= k; ++r) {
        for (int c = 0; c <= i; ++c) {
          const Integer term = binomial(k, r) * binomial(i, c) * f.at(r, c);
          if ((k - r + i - c) % 2 == 0) {
            sum += term;
          } else {
            sum -= term;
          }
        }
      }
      row.push_back(sum * binomial(p, k) * binomial(p - k, i));
    }
    by_v.emplace_back(std::move(row));
  }
  return Bivariate(std::move(by_v));
}

Bivariate operator-(const Bivariate& f, const Bivariate& g) {
  std::vector<Univariate> by_v(std::max(f.by_v.size(), g.by_v.size()));
  for (std::size_t k = 0; k < by_v.size(); ++k) {
    by_v[k] = (k < f.by_v.size() ? f.by_v[k] : Univariate()) - (k < g.by_v.size() ? g.by_v[k] : Univariate());
  }
  return Bivariate(std::move(by_v));
}

Bivariate operator*(const Bivariate& f, const Bivariate& g) {
  if (f.is_zero() || g.is_zero()) return {};
  std::vector<Univariate> by_v(f.by_v.size() + g.by_v.size() - 1);
  for (std::size_t i = 0; i < f.by_v.size(); ++i) {
    for (std::size_t j = 0; j < g.by_v.size(); ++j) by_v[i + j] = by_v[i + j] + f.by_v[i] * g.by_v[j];
  }
  return Bivariate(std::move(by_v));
}

Bivariate derivative_u(const Bivariate& f) {
  std::vector<Univariate> by_v;
  for (const Univariate& c : f.by_v) by_v.push_back(derivative(c));
  return Bivariate(std::move(by_v));
}

Bivariate derivative_v(const Bivariate& f) {
  std::vector<Univariate> by_v;
  for (std::size_t k = 1; k < f.by_v.size(); ++k) {
    Univariate c = f.by_v[k];
    for (Integer& x : c.coefficients) x *= Integer(static_cast<unsigned long>(k));
    by_v.push_back(std::move(c));
  }
  return Bivariate(std::move(by_v));
}

Bivariate swapped(const Bivariate& f) {
  std::vector<std::vector<Integer>> rows(static_cast<std::size_t>(f.degree_u() + 1),
                                         std::vector<Integer>(f.by_v.size(), 0));
  for (std::size_t k = 0; k < f.by_v.size(); ++k) {
    for (std::size_t i = 0; i < f.by_v[k].coefficients.size(); ++i) rows[i][k] = f.by_v[k].coefficients[i];
  }
  std::vector<Univariate> by_v;
  for (auto& row : rows) by_v.emplace_back(std::move(row));
  return Bivariate(std::move(by_v));
}

Univariate at_u(const Bivariate& f, const Rational& u) {
  // Homogeneous: coefficient k times the same power of u's denominator for all k.
  const Integer p = numerator(u), q = denominator(u);
  const auto degree = static_cast<std::size_t>(std::max(f.degree_u(), 0));
  std::vector<Integer> q_powers(degree + 1, 1);
  for (std::size_t i = 1; i <= degree; ++i) q_powers[i] = q_powers[i - 1] * q;
  std::vector<Integer> values;
  for (const Univariate& c : f.by_v) {
    Integer sum = 0;
    for (std::size_t i = c.coefficients.size(); i-- > 0;) {
      sum = sum * p + c.coefficients[i] * q_powers[degree - i];
    }
    values.push_back(std::move(sum));
  }
  return Univariate(std::move(values));
}

int sign_at(const Bivariate& f, const Rational& u, const Rational& v) { return sign_at(at_u(f, u), v); }

Univariate along(const Bivariate& f, const std::array<Rational, 2>& from, const std::array<Rational, 2>& to) {
  // u = (a + b t) / q and v = (c + d t) / q over one denominator q.
  const Rational du = to[0] - from[0], dv = to[1] - from[1];
  Integer q = 1;
  for (const Rational& x : {from[0], from[1], du, dv}) q = lcm(q, Integer(denominator(x)));
  const auto scaled = [&](const Rational& x) {
    return Integer(Integer(numerator(x)) * (q / denominator(x)));
  };
  const Univariate u({scaled(from[0]), scaled(du)}), v({scaled(from[1]), scaled(dv)});
  const int degree_u = std::max(f.degree_u(), 0), degree_v = std::max(f.degree_v(), 0);
  std::vector<Univariate> u_powers = {Univariate({Integer(1)})}, v_powers = u_powers;
  for (int i = 0; i < degree_u; ++i) u_powers.push_back(u_powers.back() * u);
  for (int i = 0; i < degree_v; ++i) v_powers.push_back(v_powers.back() * v);
  std::vector<Integer> q_powers = {1};
  for (int i = 0; i < degree_u + degree_v; ++i) q_powers.push_back(q_powers.back() * q);
  Univariate sum;
  for (std::size_t k = 0; k < f.by_v.size(); ++k) {
    Univariate row;
    for (std::size_t i = 0; i < f.by_v[k].coefficients.size(); ++i) {
      const Integer factor =
          f.by_v[k].coefficients[i] * q_powers[static_cast<std::size_t>(degree_u + degree_v) - i - k];
      row = row + u_powers[i] * Univariate({factor});
    }
    sum = sum + row * v_powers[k];
  }
  return sum;
}

int some_sign(const Bivariate& f) {
  const int steps = f.degree_u() + f.degree_v() + 2;
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; j < steps; ++j) {
      const int s = sign_at(f, Rational(i, 2 * steps), Rational(j, 2 * steps));
      if (s != 0) return s;
    }
  }
  throw std::logic_error("some_sign: a polynomial that is not 0 vanishes on a grid");
}

std::vector<std::pair<Bivariate, int>> irreducible_factors(const Bivariate& f) {
  const Context context;
  const Sparse whole(context, f);
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_factor_init(factors, context.value);
  const int success = fmpz_mpoly_factor(factors, whole.value, context.value);
  std::vector<std::pair<Bivariate, int>> result;
  Sparse base(context);
  for (slong i = 0; success != 0 && i < fmpz_mpoly_factor_length(factors, context.value); ++i) {
    fmpz_mpoly_factor_get_base(base.value, factors, i, context.value);
    result.emplace_back(to_bivariate(base.value, context),
                        static_cast<int>(fmpz_mpoly_factor_get_exp_si(factors, i, context.value)));
  }
  fmpz_mpoly_factor_clear(factors, context.value);
  if (success == 0) throw std::runtime_error("irreducible_factors: FLINT could not factor a polynomial");
  // A fixed order, whatever FLINT does: by degrees, then by coefficients.
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    const auto key = [](const auto& x) {
      std::vector<std::vector<Integer>> all;
      for (const Univariate& c : x.first.by_v) all.push_back(c.coefficients);
      return std::tuple(x.first.degree_v() + x.first.degree_u(), x.first.degree_v(), all);
    };
    return key(a) < key(b);
  });
  return result;
}

Bivariate gcd(const Bivariate& f, const Bivariate& g) {
  const Context context;
  const Sparse a(context, f), b(context, g);
  Sparse divisor(context);
  if (fmpz_mpoly_gcd(divisor.value, a.value, b.value, context.value) == 0) {
    throw std::runtime_error("gcd: FLINT could not find a common divisor");
  }
  return to_bivariate(divisor.value, context);
}

Bivariate quotient(const Bivariate& f, const Bivariate& g) {
  const Context context;
  Sparse result(context), dividend(context, f), divisor(context, g);
  FlintInteger content;
  // Primitive parts divide over the integers (Gauss).
  const auto make_primitive = [&](Sparse& x) {
    _fmpz_vec_content(content.value, x.value->coeffs, x.value->length);
    fmpz_mpoly_scalar_divexact_fmpz(x.value, x.value, content.value, context.value);
  };
  make_primitive(dividend);
  make_primitive(divisor);
  if (fmpz_mpoly_divides(result.value, dividend.value, divisor.value, context.value) == 0) {
    throw std::logic_error("quotient: the division leaves a remainder");
  }
  return to_bivariate(result.value, context);
}

std::size_t longest_coefficient(const Bivariate& f) {
  std::size_t bits = 1;
  for (const Univariate& row : f.by_v) {
    for (const Integer& c : row.coefficients) {
      bits = std::max(bits, mpz_sizeinbase(c.backend().data(), 2));
    }
  }
  return bits;
}

int resultant_degree_bound(const Bivariate& f, const Bivariate& g) {
  return f.degree_u() * g.degree_v() + g.degree_u() * f.degree_v();
}

Univariate resultant_v(const Bivariate& f, const Bivariate& g) {
  const auto count = static_cast<std::size_t>(resultant_degree_bound(f, g)) + 1;
  fmpz* points = _fmpz_vec_init(static_cast<slong>(count));
  fmpz* values = _fmpz_vec_init(static_cast<slong>(count));
  FlintPolynomial result;
  long at = 0;
  for (std::size_t found = 0; found<count; at = at> 0 ? -at : -at + 1) {
    const Rational u(at);
    const Univariate a = at_u(f, u), b = at_u(g, u);
    // Where a leading coefficient vanishes the value would be that of smaller degrees.
    if (a.degree() < f.degree_v() || b.degree() < g.degree_v()) continue;
    const FlintPolynomial fa(a), fb(b);
    fmpz_set_si(points + found, at);
    fmpz_poly_resultant(values + found, fa.value, fb.value);
    ++found;
  }
  fmpz_poly_interpolate_fmpz_vec(result.value, points, values, static_cast<slong>(count));
  _fmpz_vec_clear(points, static_cast<slong>(count));
  _fmpz_vec_clear(values, static_cast<slong>(count));
  return to_univariate(result.value);
}

}  // namespace bezcert
