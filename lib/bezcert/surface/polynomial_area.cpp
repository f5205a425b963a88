#include "bezcert/surface/polynomial_area.hpp"

#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/curve/area.hpp"
#include "bezcert/element/lagrange.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace bezcert {
namespace {

// A_ij of the header, i < j row by row, times `denominator`.
struct AreaForm {
  std::vector<Integer> weights;
  Integer denominator = 1;
};

AreaForm build(Shape shape, Basis basis) {
  const auto count = static_cast<std::size_t>(shape.degree(0)) + 1;
  const BasisChange& change = lagrange_to_bernstein(shape);
  const auto unit = [&](std::size_t i) {
    std::vector<Integer> values(count, 0);
    values[i] = 1;
    if (basis == Basis::lagrange) change_basis(change, values);
    return values;
  };
  const Rational twice =
      basis == Basis::lagrange ? 2 * Rational(change.denominator) * Rational(change.denominator) : 2;
  std::vector<Rational> shares;
  AreaForm result;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto [positive, negative] = bracket_integral(unit(i), unit(j));
      shares.push_back(Rational((positive + negative) / twice));
      result.denominator = lcm(result.denominator, Integer(denominator(shares.back())));
    }
  }
  for (const Rational& share : shares)
    result.weights.push_back(numerator(Rational(share * Rational(result.denominator))));
  return result;
}

const AreaForm& area_form(std::size_t nodes, Basis basis) {
  static TableCache<AreaForm> lagrange, bernstein;
  const Shape shape = Shape::segment(static_cast<int>(nodes) - 1);
  return (basis == Basis::lagrange ? lagrange : bernstein).get(shape, [&](Shape s) {
    return build(s, basis);
  });
}

// The largest e with x a multiple of 2^e. Precondition: x is not 0.
int lowest_bit(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + std::countr_zero(static_cast<unsigned long>(mantissa));
}

// x / 2^e, an integer.
void set_scaled(Integer& to, double x, int e) {
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
  mpz_ptr z = to.backend().data();
  mpz_set_si(z, mantissa);
  const int shift = exponent - 53 - e;
  if (shift >= 0) {
    mpz_mul_2exp(z, z, static_cast<unsigned long>(shift));
  } else {
    mpz_tdiv_q_2exp(z, z, static_cast<unsigned long>(-shift));  // exact: these bits are 0
  }
}

}  // namespace

bool has_plain_area(const HalfEdges& edges, HalfEdge h) {
  return edges.mesh().coordinates(0).binary64() && edges.mesh().coordinates(1).binary64() &&
         edges.equal_weights(h);
}

Rational plain_area(const HalfEdges& edges, std::span<const HalfEdge> half_edges) {
  const double* const x = edges.mesh().coordinates(0).doubles().data();
  const double* const y = edges.mesh().coordinates(1).doubles().data();
  std::optional<int> lowest;
  for (const HalfEdge h : half_edges) {
    const EdgeNodes nodes = edges.nodes(h);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const double number : {x[nodes[i]], y[nodes[i]]}) {
        if (number != 0) lowest = std::min(lowest.value_or(lowest_bit(number)), lowest_bit(number));
      }
    }
  }
  if (!lowest) return 0;
  std::map<const AreaForm*, Integer> sums;
  std::vector<Integer> xs, ys;
  Integer pair;
  for (const HalfEdge h : half_edges) {
    const EdgeNodes nodes = edges.nodes(h);
    const AreaForm& form = area_form(nodes.size(), edges.basis(h));
    xs.resize(nodes.size());
    ys.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      set_scaled(xs[i], x[nodes[i]], *lowest);
      set_scaled(ys[i], y[nodes[i]], *lowest);
    }
    mpz_ptr sum = sums[&form].backend().data(), term = pair.backend().data();
    std::size_t k = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      for (std::size_t j = i + 1; j < xs.size(); ++j) {
        mpz_mul(term, xs[i].backend().data(), ys[j].backend().data());
        mpz_submul(term, xs[j].backend().data(), ys[i].backend().data());
        mpz_addmul(sum, term, form.weights[k++].backend().data());
      }
    }
  }
  Rational result = 0;
  for (const auto& [form, sum] : sums) result += Rational(sum, form->denominator);
  return result * power_of_two(2L * *lowest);
}

}  // namespace bezcert
