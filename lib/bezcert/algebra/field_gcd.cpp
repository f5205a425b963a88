#include "bezcert/algebra/field_gcd.hpp"

#include "bezcert/algebra/flint_types.hpp"

#include <flint/fmpq.h>
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <stdexcept>

namespace bezcert {
namespace {

// A polynomial over Z/p that owns its memory.
class Residue {
 public:
  explicit Residue(mp_limb_t p) { nmod_poly_init(value_, p); }
  Residue(const Residue& other) {
    nmod_poly_init(value_, other.value_->mod.n);
    nmod_poly_set(value_, other.value_);
  }
  Residue& operator=(const Residue& other) {
    nmod_poly_set(value_, other.value_);
    return *this;
  }
  ~Residue() { nmod_poly_clear(value_); }

  nmod_poly_struct* get() { return value_; }
  const nmod_poly_struct* get() const { return value_; }
  bool is_zero() const { return nmod_poly_is_zero(value_) != 0; }

 private:
  nmod_poly_t value_;
};

using Line = std::vector<Residue>;

void shrink(Line& f) {
  while (!f.empty() && f.back().is_zero()) f.pop_back();
}

// f modulo g, in place, over (Z/p)[x]/r. False if g's leading coefficient is not invertible.
bool reduce(Line& f, const Line& g, const Residue& r) {
  Residue inverse(r.get()->mod.n), factor(inverse), part(inverse);
  if (nmod_poly_invmod(inverse.get(), g.back().get(), r.get()) == 0) return false;
  while (f.size() >= g.size()) {
    const std::size_t shift = f.size() - g.size();
    nmod_poly_mulmod(factor.get(), f.back().get(), inverse.get(), r.get());
    for (std::size_t k = 0; k + 1 < g.size(); ++k) {
      nmod_poly_mulmod(part.get(), factor.get(), g[k].get(), r.get());
      nmod_poly_sub(f[shift + k].get(), f[shift + k].get(), part.get());
    }
    f.pop_back();
    shrink(f);
  }
  return true;
}

// The monic divisor modulo p, or nothing if p is not suitable.
std::optional<Line> divisor_modulo(mp_limb_t p, const Univariate& r_exact,
                                   const std::vector<std::vector<Univariate>>& f) {
  const FlintPolynomial r_integer(r_exact);
  Residue r(p), slope(p), common(p);
  fmpz_poly_get_nmod_poly(r.get(), r_integer.value);
  if (nmod_poly_degree(r.get()) < r_exact.degree()) return std::nullopt;
  nmod_poly_derivative(slope.get(), r.get());
  nmod_poly_gcd(common.get(), r.get(), slope.get());
  if (nmod_poly_degree(common.get()) > 0) return std::nullopt;
  const auto line_of = [&](const std::vector<Univariate>& exact) {
    Line line;
    for (const Univariate& c : exact) {
      const FlintPolynomial integer(c);
      Residue residue(p);
      fmpz_poly_get_nmod_poly(residue.get(), integer.value);
      nmod_poly_rem(residue.get(), residue.get(), r.get());
      line.push_back(residue);
    }
    return line;
  };
  Line divisor = line_of(f[0]);
  Residue inverse(p);
  if (nmod_poly_invmod(inverse.get(), divisor.back().get(), r.get()) == 0) return std::nullopt;
  for (std::size_t i = 1; i < f.size(); ++i) {
    Line other = line_of(f[i]);
    shrink(other);
    while (!other.empty()) {
      if (!reduce(divisor, other, r)) return std::nullopt;
      std::swap(divisor, other);
    }
  }
  if (nmod_poly_invmod(inverse.get(), divisor.back().get(), r.get()) == 0) return std::nullopt;
  for (Residue& c : divisor) nmod_poly_mulmod(c.get(), c.get(), inverse.get(), r.get());
  return divisor;
}

// Exact arithmetic in Q(alpha) for the final check.
struct FieldPolynomial {
  fmpq_poly_t value;

  FieldPolynomial() { fmpq_poly_init(value); }
  ~FieldPolynomial() { fmpq_poly_clear(value); }
  FieldPolynomial(const FieldPolynomial&) = delete;
  FieldPolynomial& operator=(const FieldPolynomial&) = delete;
};

// Whether the monic polynomial with the coefficients g divides f.
bool divides(const std::deque<FieldPolynomial>& g, const std::vector<Univariate>& f,
             const FieldPolynomial& r) {
  std::deque<FieldPolynomial> rest;
  for (const Univariate& c : f) {
    const FlintPolynomial integer(c);
    fmpq_poly_set_fmpz_poly(rest.emplace_back().value, integer.value);
    fmpq_poly_rem(rest.back().value, rest.back().value, r.value);
  }
  FieldPolynomial part;
  while (rest.size() >= g.size()) {
    const std::size_t shift = rest.size() - g.size();
    for (std::size_t k = 0; k + 1 < g.size(); ++k) {
      fmpq_poly_mul(part.value, rest.back().value, g[k].value);
      fmpq_poly_sub(rest[shift + k].value, rest[shift + k].value, part.value);
      fmpq_poly_rem(rest[shift + k].value, rest[shift + k].value, r.value);
    }
    rest.pop_back();
  }
  return std::all_of(rest.begin(), rest.end(),
                     [](const FieldPolynomial& c) { return fmpq_poly_is_zero(c.value) != 0; });
}

Rational coefficient_of(const fmpq_poly_t f, slong k) {
  fmpq_t c;
  fmpq_init(c);
  fmpq_poly_get_coeff_fmpq(c, f, k);
  Rational result;
  fmpq_get_mpq(result.backend().data(), c);
  fmpq_clear(c);
  return result;
}

// Residues of the divisor's coefficients modulo the product of the primes seen.
class Candidate {
 public:
  explicit Candidate(int degree_of_field) : degree_(degree_of_field) { fmpz_one(modulus_.value); }

  std::size_t size() const { return residues_.size(); }

  void start(const Line& divisor) {
    residues_.clear();
    for (std::size_t k = 0; k < divisor.size(); ++k) residues_.emplace_back();
    fmpz_one(modulus_.value);
  }
  void add(const Line& divisor, mp_limb_t p) {
    for (std::size_t k = 0; k < divisor.size(); ++k) {
      fmpz_poly_CRT_ui(residues_[k].value, residues_[k].value, modulus_.value, divisor[k].get(), 1);
    }
    fmpz_mul_ui(modulus_.value, modulus_.value, p);
  }
  // The rationals with these residues, if there are small ones.
  bool reconstruct(std::deque<FieldPolynomial>& g) const {
    fmpq_t q;
    fmpz_t c;
    fmpq_init(q);
    fmpz_init(c);
    bool success = true;
    for (std::size_t k = 0; k < residues_.size() && success; ++k) {
      fmpq_poly_struct* to = g.emplace_back().value;
      for (slong i = 0; i < degree_ && success; ++i) {
        fmpz_poly_get_coeff_fmpz(c, residues_[k].value, i);
        fmpz_mod(c, c, modulus_.value);
        success = fmpq_reconstruct_fmpz(q, c, modulus_.value) != 0;
        if (success) fmpq_poly_set_coeff_fmpq(to, i, q);
      }
    }
    fmpq_clear(q);
    fmpz_clear(c);
    return success;
  }

 private:
  slong degree_;
  std::deque<FlintPolynomial> residues_;
  FlintInteger modulus_;
};

}  // namespace

std::vector<FieldVector> field_gcd(const Univariate& r, const std::vector<Bivariate>& polynomials) {
  FieldPolynomial modulus;
  {
    const FlintPolynomial integer(r);
    fmpq_poly_set_fmpz_poly(modulus.value, integer.value);
  }
  // Without the leading coefficients that vanish at alpha, and without those polynomials that do.
  std::vector<std::vector<Univariate>> f;
  for (const Bivariate& one : polynomials) {
    std::vector<Univariate> line = one.by_v;
    const auto vanishes = [&](const Univariate& c) {
      return c.is_zero() || gcd(c, r).degree() == r.degree();
    };
    while (!line.empty() && vanishes(line.back())) line.pop_back();
    if (!line.empty()) f.push_back(std::move(line));
  }
  if (f.empty()) return {};
  std::sort(f.begin(), f.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });

  Candidate candidate(r.degree());
  std::size_t primes = 0, next_try = 1;
  mp_limb_t p = UWORD(1) << 61;
  for (int refused = 0;;) {
    p = n_nextprime(p, 0);
    const auto divisor = divisor_modulo(p, r, f);
    if (!divisor) {
      // Finitely many primes are not suitable.
      if (++refused > 1000) throw std::logic_error("field_gcd: the polynomial of alpha is not irreducible");
      continue;
    }
    if (divisor->size() == 1) return {{Rational(1)}};
    if (primes > 0 && divisor->size() > candidate.size()) continue;
    if (primes == 0 || divisor->size() < candidate.size()) {
      candidate.start(*divisor);
      primes = 0;
      next_try = 1;
    }
    candidate.add(*divisor, p);
    if (++primes < next_try) continue;
    next_try = primes + primes / 2 + 1;
    std::deque<FieldPolynomial> g;
    if (!candidate.reconstruct(g)) continue;
    if (!std::all_of(f.begin(), f.end(), [&](const auto& one) { return divides(g, one, modulus); })) continue;
    std::vector<FieldVector> result;
    for (const FieldPolynomial& c : g) {
      FieldVector coefficients;
      for (slong i = 0; i < fmpq_poly_length(c.value); ++i)
        coefficients.push_back(coefficient_of(c.value, i));
      result.push_back(std::move(coefficients));
    }
    return result;
  }
}

}  // namespace bezcert
