// The texts of polynomials in certificates (docs/certificate-format.md, "Text"): every value has one.
//
// Integers and rationals are written by to_string (number/rational.hpp): lowest terms, no denominator 1.
#pragma once

#include "bezcert/algebra/bivariate.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// POLY: the coefficients of 1, x, x^2, ... separated by commas; "0" for the zero polynomial.
std::string text_of_polynomial(const Univariate& f);

/// RATPOLY: POLY, or POLY/denominator in lowest terms. Coefficients of 1, x, x^2, ...; leading zeros are
/// dropped.
std::string text_of_rational_polynomial(const std::vector<Rational>& coefficients);

/// POLY2: the coefficients of 1, v, v^2, ... as POLY in u, separated by semicolons.
std::string text_of_polynomial2(const Bivariate& f);

/// Whether a text is at most half as long as a checker takes, and so is every number in it ("Limits").
bool within_limits(std::string_view text);

}  // namespace bezcert
