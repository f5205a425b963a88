#include "bezcert/certificate/zero_evidence.hpp"

#include "bezcert/algebra/algebraic_point.hpp"
#include "bezcert/certificate/evidence_text.hpp"
#include "bezcert/element/forms.hpp"

namespace bezcert {
namespace {

std::string text_at(const Rational& u, const Rational& v) {
  return "at " + to_string(u) + ' ' + to_string(v);
}

// The conditions of the closed domain.
std::vector<AffineCondition> domain_conditions(Domain domain) {
  std::vector<AffineCondition> result = {{0, 1, 0}, {0, 0, 1}};
  if (domain == Domain::triangle) {
    result.push_back({1, -1, -1});
  } else {
    result.push_back({1, -1, 0});
    result.push_back({1, 0, -1});
  }
  return result;
}

// Isolated zeros inside the domain are common zeros of a factor and its derivatives; those on edges, and
// those of a curve, are zeros of the factor. The more polynomials, the fewer other common zeros are in the
// way.
std::vector<std::vector<Bivariate>> equations(const Polynomial<Integer>& n, const PlanarPoint& at) {
  std::vector<std::vector<Bivariate>> result;
  const Bivariate powers = to_power_basis(n);
  const bool on_hypotenuse =
      n.shape.domain == Domain::triangle && at.u.lower + at.v.lower <= 1 && at.u.upper + at.v.upper >= 1;
  if (on_hypotenuse) {
    const Bivariate hypotenuse({Univariate({Integer(1), Integer(-1)}), Univariate({Integer(-1)})});
    result.push_back({powers, hypotenuse});
  }
  if (at.u.is_rational() || at.v.is_rational()) {
    result.push_back({powers});
    return result;
  }
  for (const auto& [factor, multiplicity] : irreducible_factors(powers)) {
    result.push_back({factor, derivative_u(factor), derivative_v(factor)});
    result.push_back({factor});
  }
  return result;
}

std::optional<std::string> text_of_zero(const Forms& forms, const PlanarPoint& at) {
  if (at.is_rational()) return text_at(at.u.lower, at.v.lower);
  const Polynomial<Integer>& n = forms.exact_jacobian().numerator;
  for (const std::vector<Bivariate>& vanishing : equations(n, at)) {
    std::optional<AlgebraicPoint> point = algebraic_point(vanishing, at);
    if (!point || !narrow(*point, domain_conditions(n.shape.domain))) continue;
    if (point->is_rational()) {
      const auto value = [](const std::vector<Rational>& f) { return f.empty() ? Rational(0) : f[0]; };
      return text_at(value(point->u), value(point->v));
    }
    const std::string text = "root " + text_of_polynomial(point->polynomial) + ' ' + to_string(point->lower) +
                             ' ' + to_string(point->upper) + ' ' + text_of_rational_polynomial(point->u) +
                             ' ' + text_of_rational_polynomial(point->v);
    if (within_limits(text)) return text;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> zero_evidence(const Forms& forms, const Decision& decision) {
  if (decision.witness && decision.witness->determinant.is_zero()) {
    const std::vector<Rational> uv = decision.witness->parameter.affine();
    return text_at(uv[0], uv[1]);
  }
  if (!decision.zero) return std::nullopt;
  return text_of_zero(forms, decision.zero->at);
}

}  // namespace bezcert
