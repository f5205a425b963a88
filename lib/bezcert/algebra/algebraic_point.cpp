#include "bezcert/algebra/algebraic_point.hpp"

#include "bezcert/algebra/field_gcd.hpp"
#include "bezcert/algebra/flint_types.hpp"
#include "bezcert/number/scaled.hpp"

#include <algorithm>

namespace bezcert {
namespace {

void trim(std::vector<Rational>& f) {
  while (!f.empty() && f.back().is_zero()) f.pop_back();
}

// A polynomial over the rationals that owns its memory.
class RationalPolynomial {
 public:
  RationalPolynomial() { fmpq_poly_init(value_); }
  explicit RationalPolynomial(const Univariate& f) : RationalPolynomial() {
    const FlintPolynomial integer(f);
    fmpq_poly_set_fmpz_poly(value_, integer.value);
  }
  explicit RationalPolynomial(const std::vector<Rational>& f) : RationalPolynomial() {
    for (std::size_t k = f.size(); k-- > 0;) {
      fmpq_poly_set_coeff_mpq(value_, static_cast<slong>(k), f[k].backend().data());
    }
  }
  RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
    fmpq_poly_set(value_, other.value_);
  }
  RationalPolynomial& operator=(const RationalPolynomial& other) {
    fmpq_poly_set(value_, other.value_);
    return *this;
  }
  ~RationalPolynomial() { fmpq_poly_clear(value_); }

  fmpq_poly_struct* get() { return value_; }
  const fmpq_poly_struct* get() const { return value_; }

  std::vector<Rational> coefficients() const {
    std::vector<Rational> result;
    fmpq_t c;
    fmpq_init(c);
    for (slong k = 0; k < fmpq_poly_length(value_); ++k) {
      fmpq_poly_get_coeff_fmpq(c, value_, k);
      fmpq_get_mpq(result.emplace_back().backend().data(), c);
    }
    fmpq_clear(c);
    return result;
  }

 private:
  fmpq_poly_t value_;
};

Rational constant_of(const std::vector<Rational>& f) { return f.empty() ? Rational(0) : f[0]; }

Rational at_rational(const Bivariate& f, const Rational& u, const Rational& v) {
  Rational sum = 0;
  for (std::size_t k = f.by_v.size(); k-- > 0;) sum = sum * v + value_at(f.by_v[k], u);
  return sum;
}

bool vanish(const std::vector<Bivariate>& polynomials, const AlgebraicPoint& point) {
  return std::all_of(polynomials.begin(), polynomials.end(),
                     [&](const Bivariate& f) { return value_at(f, point).empty(); });
}

// constant + by_u u(x) + by_v v(x).
std::vector<Rational> combination(const AffineCondition& c, const AlgebraicPoint& point) {
  std::vector<Rational> result(std::max({point.u.size(), point.v.size(), std::size_t{1}}), 0);
  result[0] = c.constant;
  for (std::size_t k = 0; k < point.u.size(); ++k) result[k] += c.by_u * point.u[k];
  for (std::size_t k = 0; k < point.v.size(); ++k) result[k] += c.by_v * point.v[k];
  trim(result);
  return result;
}

void halve_interval(AlgebraicPoint& point) {
  const Rational middle = (point.lower + point.upper) / 2;
  // The polynomial is irreducible of degree at least 2: no rational root.
  (sign_at(point.polynomial, middle) == sign_at(point.polynomial, point.lower) ? point.lower : point.upper) =
      middle;
}

// The sign of f(x).
int sign_of(const std::vector<Rational>& f, AlgebraicPoint& point) {
  if (f.size() <= 1) return sign(constant_of(f));
  const Univariate whole = from_rationals(f);
  for (;;) {
    const std::vector<Integer> c = bernstein_over(whole, point.lower, point.upper);
    if (std::all_of(c.begin(), c.end(), [](const Integer& x) { return x.sign() > 0; })) return 1;
    if (std::all_of(c.begin(), c.end(), [](const Integer& x) { return x.sign() < 0; })) return -1;
    halve_interval(point);
  }
}

bool between(const std::vector<Rational>& f, const RealRoot& bounds, AlgebraicPoint& point) {
  std::vector<Rational> above = f;
  if (above.empty()) above.emplace_back(0);
  std::vector<Rational> below = above;
  above[0] -= bounds.lower;
  below[0] -= bounds.upper;
  trim(above);
  trim(below);
  return sign_of(above, point) >= 0 && sign_of(below, point) <= 0;
}

AlgebraicPoint rational_point(const Rational& u, const Rational& v) {
  AlgebraicPoint point;
  if (!u.is_zero()) point.u = {u};
  if (!v.is_zero()) point.v = {v};
  return point;
}

AlgebraicPoint exchanged(AlgebraicPoint point) {
  std::swap(point.u, point.v);
  return point;
}

// The point (x - k v(x), v(x)) or, with k = 0, (x, v(x)), x irrational.
AlgebraicPoint point_over(const RealRoot& x, std::vector<Rational> u, std::vector<Rational> v) {
  trim(u);
  trim(v);
  return {x.polynomial, x.lower, x.upper, std::move(u), std::move(v)};
}

// If a monic polynomial over a field is the power of a linear one, this is its root: by the coefficient after
// the leading one. Whether it is, the caller finds out by checking the point.
std::vector<Rational> root_of_power(const std::vector<FieldVector>& monic) {
  const std::size_t degree = monic.size() - 1;
  std::vector<Rational> root = monic[degree - 1];
  for (Rational& c : root) c /= -static_cast<long>(degree);
  trim(root);
  return root;
}

// Roots of f in [lower, upper], each with its minimal polynomial.
std::vector<RealRoot> minimal_roots(const Univariate& f, const Rational& lower, const Rational& upper) {
  std::vector<RealRoot> result;
  if (f.degree() < 1) return result;
  for (RealRoot& root : roots_in(square_free_part(f), lower, upper)) {
    result.push_back(with_minimal_polynomial(std::move(root)));
  }
  return result;
}

std::size_t bits_of_resultant(const Bivariate& f, const Bivariate& g) {
  return static_cast<std::size_t>(std::max(resultant_degree_bound(f, g), 1)) *
         (static_cast<std::size_t>(std::max(g.degree_v(), 1)) * longest_coefficient(f) +
          static_cast<std::size_t>(std::max(f.degree_v(), 1)) * longest_coefficient(g));
}

class Search {
 public:
  Search(std::vector<Bivariate> vanishing, PlanarPoint at, std::size_t budget_bits)
      : vanishing_(std::move(vanishing)), at_(std::move(at)), budget_bits_(budget_bits) {}

  std::optional<AlgebraicPoint> run() {
    if (vanishing_.empty()) return rational_point(simplest(at_.u), simplest(at_.v));
    if (at_.u.is_rational()) return on_column(at_.u.lower);
    if (at_.v.is_rational() || (at_.u.polynomial.is_zero() && !at_.v.polynomial.is_zero())) {
      return in_rows();
    }
    if (!at_.u.polynomial.is_zero()) return over(at_.u);
    return by_resultant();
  }

 private:
  static Rational simplest(const RealRoot& bounds) { return simplest_between(bounds.lower, bounds.upper); }

  std::optional<AlgebraicPoint> accepted(AlgebraicPoint point) const {
    if (!between(point.u, at_.u, point) || !between(point.v, at_.v, point)) return std::nullopt;
    if (!vanish(vanishing_, point)) return std::nullopt;
    return point;
  }

  std::optional<AlgebraicPoint> in_rows() const {
    std::vector<Bivariate> other;
    for (const Bivariate& f : vanishing_) other.push_back(swapped(f));
    auto point = Search(std::move(other), {at_.v, at_.u}, budget_bits_).run();
    if (point) point = exchanged(std::move(*point));
    return point;
  }

  // u rational.
  std::optional<AlgebraicPoint> on_column(const Rational& u) const {
    if (at_.v.is_rational()) return accepted(rational_point(u, at_.v.lower));
    Univariate line;
    for (const Bivariate& f : vanishing_) line = gcd(line, at_u(f, u));
    if (line.is_zero()) return rational_point(u, simplest(at_.v));
    for (const RealRoot& v : minimal_roots(line, at_.v.lower, at_.v.upper)) {
      auto point = accepted(v.is_rational() ? rational_point(u, v.lower)
                                            : point_over(v, {u}, {Rational(0), Rational(1)}));
      if (point) return point;
    }
    return std::nullopt;
  }

  // u irrational, its minimal polynomial known.
  std::optional<AlgebraicPoint> over(RealRoot u) const {
    u = with_minimal_polynomial(std::move(u));
    if (u.is_rational()) return on_column(u.lower);
    std::vector<Bivariate> all = vanishing_;
    if (!at_.v.polynomial.is_zero()) {
      std::vector<Univariate> in_v;
      for (const Integer& c : at_.v.polynomial.coefficients) in_v.push_back(Univariate({c}));
      all.emplace_back(std::move(in_v));
    }
    const std::vector<FieldVector> divisor = field_gcd(u.polynomial, all);
    const std::vector<Rational> x = {Rational(0), Rational(1)};
    if (divisor.empty()) return accepted(point_over(u, x, {simplest(at_.v)}));
    if (divisor.size() < 2) return std::nullopt;
    if (auto point = accepted(point_over(u, x, root_of_power(divisor)))) return point;
    return divisor.size() == 2 ? std::nullopt : separated(u, divisor);
  }

  // x = v + k u for k = 1, 2, ...: the norm of the divisor at v = x - k u has the root x, and u is a common
  // zero of it and u's polynomial.
  std::optional<AlgebraicPoint> separated(RealRoot u, const std::vector<FieldVector>& divisor) const {
    // The divisor with integer coefficients, as a polynomial in its own u (outer) and v (inner).
    const auto degree = static_cast<std::size_t>(u.polynomial.degree());
    std::vector<Rational> all;
    for (FieldVector c : divisor) {
      c.resize(degree, 0);
      all.insert(all.end(), c.begin(), c.end());
    }
    const std::vector<Integer> cleared = scaled_integers(all).values;
    std::vector<Univariate> minimal;  // u's polynomial in the outer variable
    for (const Integer& c : u.polynomial.coefficients) minimal.push_back(Univariate({c}));
    const Bivariate m(std::move(minimal));
    RealRoot v = at_.v;
    for (int k = 1; k <= 8; ++k) {
      // G(u, x - k u) by Horner's rule in v = x - k u, the outer variable being u.
      const Bivariate line({Univariate({Integer(0), Integer(1)}), Univariate({Integer(-k)})});
      Bivariate moved;
      for (std::size_t i = divisor.size(); i-- > 0;) {
        std::vector<Univariate> c;
        for (std::size_t j = 0; j < degree; ++j) c.push_back(Univariate({-cleared[i * degree + j]}));
        moved = moved * line - Bivariate(std::move(c));
      }
      if (bits_of_resultant(moved, m) > budget_bits_) return std::nullopt;
      u.refine_to((at_.v.upper - at_.v.lower) / k);
      for (const RealRoot& x :
           minimal_roots(resultant_v(moved, m), v.lower + k * u.lower, v.upper + k * u.upper)) {
        // A rational x makes u and v linear in each other: another k gives the field.
        if (x.is_rational()) continue;
        const std::vector<FieldVector> common = field_gcd(x.polynomial, {m, moved});
        if (common.size() < 2) continue;
        const std::vector<Rational> u_of_x = root_of_power(common);
        std::vector<Rational> v_of_x = u_of_x;
        v_of_x.resize(std::max(v_of_x.size(), std::size_t{2}), 0);
        for (Rational& c : v_of_x) c *= -k;
        v_of_x[1] += 1;
        if (auto point = accepted(point_over(x, u_of_x, std::move(v_of_x)))) return point;
      }
    }
    return std::nullopt;
  }

  // Neither polynomial is known.
  std::optional<AlgebraicPoint> by_resultant() const {
    Bivariate common;
    for (const Bivariate& f : vanishing_) common = common.is_zero() ? f : gcd(common, f);
    if (common.degree_u() > 0 || common.degree_v() > 0) {
      if (auto point = on_common_curve(common)) return point;
    }
    for (std::size_t i = 0; i < vanishing_.size(); ++i) {
      for (std::size_t j = i + 1; j < vanishing_.size(); ++j) {
        const Bivariate shared = gcd(vanishing_[i], vanishing_[j]);
        if (auto point = over_roots(quotient(vanishing_[i], shared), quotient(vanishing_[j], shared))) {
          return point;
        }
      }
    }
    return std::nullopt;
  }

  // Columns over the roots of a resultant in the box.
  std::optional<AlgebraicPoint> over_roots(const Bivariate& f, const Bivariate& g) const {
    if (f.is_zero() || g.is_zero() || bits_of_resultant(f, g) > budget_bits_) return std::nullopt;
    for (const RealRoot& u : minimal_roots(resultant_v(f, g), at_.u.lower, at_.u.upper)) {
      if (auto point = over(u)) return point;
    }
    return std::nullopt;
  }

  // Zeros of a common divisor: on rational columns or rows through the box, or where its gradient vanishes.
  std::optional<AlgebraicPoint> on_common_curve(const Bivariate& common) const {
    constexpr int parts = 4;
    for (int i = 0; i <= parts; ++i) {
      const Rational u = at_.u.lower + (at_.u.upper - at_.u.lower) * Rational(i, parts);
      if (auto point = on_column(u)) return point;
      PlanarPoint row = at_;
      row.v = rational_root(at_.v.lower + (at_.v.upper - at_.v.lower) * Rational(i, parts));
      if (auto point = Search(vanishing_, row, budget_bits_).in_rows()) return point;
    }
    for (const auto& [factor, multiplicity] : irreducible_factors(common)) {
      if (factor.degree_v() < 1) continue;
      if (auto point = over_roots(factor, derivative_v(factor))) return point;
    }
    return std::nullopt;
  }

  std::vector<Bivariate> vanishing_;
  PlanarPoint at_;
  std::size_t budget_bits_;
};

}  // namespace

std::optional<AlgebraicPoint> algebraic_point(const std::vector<Bivariate>& vanishing, const PlanarPoint& at,
                                              std::size_t budget_bits) {
  std::vector<Bivariate> nonzero;
  for (const Bivariate& f : vanishing) {
    if (!f.is_zero()) nonzero.push_back(f);
  }
  return Search(std::move(nonzero), at, budget_bits).run();
}

std::vector<Rational> value_at(const Bivariate& f, const AlgebraicPoint& point) {
  if (point.is_rational()) {
    const Rational value = at_rational(f, constant_of(point.u), constant_of(point.v));
    return value.is_zero() ? std::vector<Rational>() : std::vector<Rational>{value};
  }
  const RationalPolynomial modulus(point.polynomial), u(point.u), v(point.v);
  std::vector<RationalPolynomial> powers(1);
  fmpq_poly_one(powers[0].get());
  const auto product = [&](RationalPolynomial& result, const RationalPolynomial& a,
                           const RationalPolynomial& b) {
    fmpq_poly_mul(result.get(), a.get(), b.get());
    fmpq_poly_rem(result.get(), result.get(), modulus.get());
  };
  for (int i = 0; i < f.degree_u(); ++i) {
    RationalPolynomial next;
    product(next, powers.back(), u);
    powers.push_back(next);
  }
  RationalPolynomial sum, row, term;
  for (std::size_t k = f.by_v.size(); k-- > 0;) {
    product(row, sum, v);
    for (std::size_t i = 0; i < f.by_v[k].coefficients.size(); ++i) {
      const FlintInteger c(f.by_v[k].coefficients[i]);
      fmpq_poly_scalar_mul_fmpz(term.get(), powers[i].get(), c.value);
      fmpq_poly_add(row.get(), row.get(), term.get());
    }
    sum = row;
  }
  fmpq_poly_rem(sum.get(), sum.get(), modulus.get());
  return sum.coefficients();
}

bool narrow(AlgebraicPoint& point, const std::vector<AffineCondition>& conditions) {
  for (const AffineCondition& condition : conditions) {
    const bool strict = condition.asks == AffineCondition::Asks::one_strict_sign;
    const std::vector<Rational> f = combination(condition, point);
    if (f.empty()) {
      if (strict) return false;
      continue;
    }
    // f has a smaller degree than the polynomial of x: it does not vanish at x, and narrowing ends with
    // coefficients of one strict sign.
    if (sign_of(f, point) < 0 && !strict) return false;
  }
  return true;
}

}  // namespace bezcert
