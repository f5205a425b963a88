#include "bezcert/certificate/separating_resultant.hpp"

#include "bezcert/algebra/real_root.hpp"
#include "bezcert/curve/contact_algebra.hpp"
#include "bezcert/curve/same_curve.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// The determinant of the Sylvester matrix of f and g, both taken in the larger of their degrees in v: where
// one falls short of it, the resultant times powers of the other's leading coefficient.
Univariate formal_resultant(const Bivariate& f, const Bivariate& g) {
  if (f.is_zero() || g.is_zero()) return {};
  Univariate result = resultant_v(f, g);
  for (int k = f.degree_v(); k < g.degree_v(); ++k) result = result * g.by_v.back();
  for (int k = g.degree_v(); k < f.degree_v(); ++k) result = result * f.by_v.back();
  return result;
}

// Of the Bernstein coefficients on [0, 1].
bool has_one_strict_sign(const Univariate& f) {
  const std::vector<Integer> values = bernstein_over(f, 0, 1);
  const int first = values[0].sign();
  return first != 0 &&
         std::all_of(values.begin(), values.end(), [&](const Integer& c) { return c.sign() == first; });
}

}  // namespace

bool resultant_separates(const CurveNet<Integer>& a, const CurveNet<Integer>& b, Joints joints) {
  const auto [f, g] =
      contact_equations(joints.end_to_begin ? reversed(a) : a, joints.begin_to_end ? reversed(b) : b, false);
  Univariate resultant = formal_resultant(f, g);
  if (resultant.is_zero()) return false;
  if (joints.end_to_begin || joints.begin_to_end) {
    const auto first = std::find_if(resultant.coefficients.begin(), resultant.coefficients.end(),
                                    [](const Integer& c) { return !c.is_zero(); });
    resultant.coefficients.erase(resultant.coefficients.begin(), first);
  }
  return has_one_strict_sign(resultant);
}

}  // namespace bezcert
