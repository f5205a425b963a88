#include "bezcert/certificate/evidence_text.hpp"

#include "bezcert/number/scaled.hpp"

namespace bezcert {

std::string text_of_polynomial(const Univariate& f) {
  if (f.is_zero()) return "0";
  std::string text;
  for (const Integer& c : f.coefficients) {
    if (!text.empty()) text += ',';
    text += c.str();
  }
  return text;
}

std::string text_of_rational_polynomial(const std::vector<Rational>& coefficients) {
  // Over the least common denominator, which has no divisor in common with all numerators.
  const ScaledIntegers whole = scaled_integers(coefficients);
  const std::string text = text_of_polynomial(Univariate(whole.values));
  const Integer denominator_of_all = denominator(whole.scale);
  return denominator_of_all == 1 ? text : text + '/' + denominator_of_all.str();
}

std::string text_of_polynomial2(const Bivariate& f) {
  if (f.is_zero()) return "0";
  std::string text;
  for (std::size_t k = 0; k < f.by_v.size(); ++k) {
    if (k > 0) text += ';';
    text += text_of_polynomial(f.by_v[k]);
  }
  return text;
}

bool within_limits(std::string_view text) {
  constexpr std::size_t max_text = std::size_t{1} << 25;
  constexpr std::size_t max_digits = 631305;  // of 2^21 bits
  if (text.size() > max_text) return false;
  std::size_t digits = 0;  // trees are shorter
  for (const char c : text) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    if (digits > max_digits) return false;
  }
  return true;
}

}  // namespace bezcert
