#include "bezcert/decide/algebraic.hpp"

#include <algorithm>

namespace bezcert {
namespace {

using Point = std::array<Rational, 2>;

// Bits of the largest resultant that zero_set may compute of h: degree times size of a coefficient.
std::size_t resultant_bits(const Bivariate& h) {
  const std::size_t longest = longest_coefficient(h);
  const int smaller = std::min(h.degree_u(), h.degree_v());
  if (smaller <= 0) return longest;
  return static_cast<std::size_t>(zero_set_degree(h)) * static_cast<std::size_t>(2 * smaller - 1) * longest;
}

// Where N has the sign `wanted` on a column u = constant, between roots of N there.
std::optional<Rational> place_on_column(const Univariate& column, int wanted, const Rational& top) {
  if (column.is_zero()) return std::nullopt;
  for (const Gap& gap : gaps_between_roots(square_free_part(column), 0, top)) {
    if (sign_at(column, gap.sample) == wanted) return gap.sample;
  }
  return std::nullopt;
}

// A point with the wanted sign near the curve along which a factor of odd multiplicity changes its sign. All
// but finitely many columns of the cell have one: other factors vanish on the curve at finitely many points
// only.
Point place_near(const Polynomial<Integer>& n, const Bivariate& powers, int wanted, const ZeroSet& zeros) {
  const Bivariate in_columns = zeros.column_is_u ? powers : swapped(powers);
  const auto& [lower, upper] = zeros.cell;
  for (int parts = 2;; ++parts) {
    for (int k = 1; k < parts; ++k) {
      const Rational u = simplest_between(lower + (upper - lower) * Rational(4 * k - 1, 4 * parts),
                                          lower + (upper - lower) * Rational(4 * k + 1, 4 * parts));
      const Rational top = n.shape.domain == Domain::triangle ? Rational(1 - u) : Rational(1);
      if (const auto v = place_on_column(at_u(in_columns, u), wanted, top)) {
        return zeros.column_is_u ? Point{u, *v} : Point{*v, u};
      }
    }
  }
}

}  // namespace

AlgebraicSigns algebraic_signs(const Polynomial<Integer>& n, int wanted, const Strips& strips_u,
                               const Strips& strips_v, std::size_t budget_bits) {
  const Bivariate powers = to_power_basis(n);
  AlgebraicSigns result;
  // Factoring comes first and is dear for long coefficients alone.
  std::size_t bits_of_n = 0;
  for (const Integer& c : n.coefficients) bits_of_n += mpz_sizeinbase(c.backend().data(), 2);
  if (bits_of_n > budget_bits / 16) {
    result.exhausted = ExhaustedBudget{ExhaustedBudget::Limit::factoring_bits, budget_bits, bits_of_n};
    return result;
  }
  const auto factors = irreducible_factors(powers);
  for (const auto& [factor, multiplicity] : factors) {
    const std::size_t bits = resultant_bits(factor);
    if (bits <= budget_bits) continue;
    result.exhausted = ExhaustedBudget{ExhaustedBudget::Limit::factor_bits, budget_bits, bits,
                                       factor.degree_u(), factor.degree_v()};
    return result;
  }
  for (const auto& [factor, multiplicity] : factors) {
    ZeroSet zeros = zero_set(factor, n.shape.domain, strips_u, strips_v);
    if (zeros.changes_sign && multiplicity % 2 == 1) {
      result.opposite = place_near(n, powers, wanted, zeros);
      result.zero.reset();
      return result;
    }
    for (PlanarPoint& zero : zeros.zeros) {
      if (!result.zero) {
        result.zero = AlgebraicZero{std::move(zero), zeros.dimension};
      } else if (zero.is_rational() && !result.zero->at.is_rational()) {
        result.zero->at = std::move(zero);  // the better evidence
      }
      result.zero->dimension = std::max(result.zero->dimension, zeros.dimension);
    }
  }
  return result;
}

}  // namespace bezcert
