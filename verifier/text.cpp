// Tokens of certificates: strict, one spelling a value; decimals of elements files; the limits of work.
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace verifier {

namespace {

constexpr char digits[] = "0123456789";
constexpr std::size_t most_digits = 1'262'611;   // of a number: less than 2^22 bits
constexpr std::size_t most_coefficients = 4097;  // of a POLY, and rows of a POLY2
constexpr std::size_t most_in_poly2 = 1 << 20;   // coefficients of a POLY2
constexpr long most_power_of_ten = 1'000'000;    // of decimals
std::size_t line_left = std::size_t{1} << 36, total_left = std::size_t{1} << 42;

mpz_class from_digits(std::string_view text) {
  if (text.size() > most_digits) throw Malformed{"limit: number of more than 2^22 bits"};
  if (text.size() > 18) return spend(8 * text.size()), mpz_class(std::string(text), 10);
  unsigned long value = 0;
  for (const char c : text) value = 10 * value + static_cast<unsigned long>(c - '0');
  return value;
}

mpz_class natural(std::string_view text) {
  if (text.empty() || text.find_first_not_of(digits) != text.npos || (text[0] == '0' && text.size() > 1))
    throw Malformed{"not an integer in its one spelling"};
  return from_digits(text);
}

mpz_class integer_of(std::string_view text) {
  if (!text.starts_with('-')) return natural(text);
  const mpz_class value = natural(text.substr(1));
  if (value == 0) throw Malformed{"-0"};
  return -value;
}

/// For a gcd of a and b, or a division by it.
void spend_gcd(const mpz_class& a, const mpz_class& b) {
  spend(1024 * (1 + mpz_size(a.get_mpz_t()) + mpz_size(b.get_mpz_t())));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0, end = 0; end != text.npos; at = end + 1) {
    end = text.find(separator, at);
    parts.push_back(text.substr(at, end - at));
    if (parts.size() > most_coefficients) throw Malformed{"limit: degree above 4096"};
  }
  return parts;
}

Polynomial polynomial_of(std::string_view text) {
  Polynomial f;
  if (text == "0") return f;
  for (const std::string_view part : split(text, ',')) f.push_back(integer_of(part));
  if (f.back() == 0) throw Malformed{"the last coefficient is 0"};
  return f;
}

/// POLY or POLY/INT in lowest terms.
RationalPolynomial fraction_of(std::string_view token) {
  const std::size_t slash = token.find('/');
  RationalPolynomial f{polynomial_of(token.substr(0, slash)), 1};
  if (slash == token.npos) return f;
  f.denominator = natural(token.substr(slash + 1));
  mpz_class common = f.denominator;
  for (const mpz_class& c : f.numerator) spend_gcd(c, common), common = gcd(c, common);
  if (f.denominator <= 1 || common != 1) throw Malformed{"fraction not in lowest terms"};
  return f;
}

}  // namespace

Tokens::Tokens(std::string_view line) : line_(line) {
  for (const char c : line)
    if (c < ' ' || c > '~') throw Malformed{"a character that is not printable ASCII"};
}

std::string_view Tokens::word() {
  if (at_end()) throw Malformed{"the line ends too early"};
  const std::string_view token = line_.substr(at_, line_.find(' ', at_) - at_);
  if (token.empty()) throw Malformed{"tokens are separated by exactly one space"};
  at_ += token.size() + 1;
  return token;
}

bool Tokens::accept(std::string_view word) {
  if (at_end() || line_.substr(at_, line_.find(' ', at_) - at_) != word) return false;
  at_ += word.size() + 1;
  return true;
}

void Tokens::expect_end() const {
  if (!at_end()) throw Malformed{"the line goes on where it should end"};
}

mpz_class Tokens::integer() { return integer_of(word()); }

long Tokens::small(long low, long high) {
  const mpz_class value = integer();
  if (value < low || value > high) throw Malformed{"integer out of its range"};
  return value.get_si();
}

mpq_class Tokens::rational() {
  const std::string_view token = word();
  if (token.find(',') != token.npos) throw Malformed{"expected one number"};
  const RationalPolynomial value = fraction_of(token);
  return value.numerator.empty() ? mpq_class(0) : mpq_class(value.numerator[0], value.denominator);
}

Polynomial Tokens::polynomial() { return polynomial_of(word()); }
RationalPolynomial Tokens::rational_polynomial() { return fraction_of(word()); }

Polynomial2 Tokens::polynomial2() {
  Polynomial2 f;
  std::size_t coefficients = 0;
  for (const std::string_view part : split(word(), ';')) {
    f.push_back(polynomial_of(part));
    coefficients += f.back().size();
    if (coefficients > most_in_poly2) throw Malformed{"limit: polynomial of more than 2^20 coefficients"};
  }
  if (f.back().empty()) throw Malformed{"the last coefficient is 0"};
  return f;
}

std::string_view Tokens::bits() {
  const std::string_view token = word();
  if (token.find_first_not_of("01") != token.npos) throw Malformed{"expected a string of 0 and 1"};
  return token;
}

EdgeName Tokens::edge_name() {
  const std::string_view token = word(), edge = token.substr(std::min(token.find('.'), token.size()));
  const mpz_class position = natural(token.substr(0, token.size() - edge.size()));
  if (position < 1 || position > 0xffffffff || edge.size() != 2 || edge[1] < '0' || edge[1] > '3')
    throw Malformed{"expected position.edge"};
  return {position.get_ui() - 1, edge[1] - '0'};
}

mpq_class exact_number(std::string_view text, bool fractions) {
  mpq_class value;
  if (const std::size_t slash = text.find('/'); fractions && slash != text.npos) {
    value.get_num() = integer_of(text.substr(0, slash));
    value.get_den() = natural(text.substr(slash + 1));
    if (value.get_den() == 0) throw Malformed{"denominator 0"};
  } else {
    const std::size_t e = std::min(text.find_first_of("eE"), text.size()), dot = std::min(text.find('.'), e);
    std::string number(text.substr(0, e));
    if (dot < e) number.erase(dot, 1);
    const bool negative = number.starts_with('-');
    if (number.size() == negative || number.find_first_not_of(digits, negative) != number.npos)
      throw Malformed{"not a number"};
    long power = 0;
    if (e < text.size()) {
      std::string_view exponent = text.substr(e + 1);
      if (exponent.starts_with('+') && !exponent.starts_with("+-")) exponent.remove_prefix(1);
      if (exponent.size() > 9) throw Malformed{"limit: power of ten"};
      const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
      if (error != std::errc() || end != exponent.data() + exponent.size()) throw Malformed{"not a number"};
    }
    if (dot < e) power -= static_cast<long>(e - dot - 1);
    if (std::abs(power) > most_power_of_ten) throw Malformed{"limit: power of ten"};
    value.get_num() = from_digits(std::string_view(number).substr(negative));
    if (negative) value.get_num() = -value.get_num();
    spend(16 * static_cast<std::size_t>(std::abs(power)));
    mpz_class scale;
    mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(power)));
    (power < 0 ? value.get_den() : value.get_num()) *= scale;
  }
  spend_gcd(value.get_num(), value.get_den());
  value.canonicalize();
  return value;
}

double nearest_double(std::string_view text) {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (end != last || error == std::errc::invalid_argument) throw Malformed{"not a number"};
  // Out of range it does not say on which side. strtod, in the locale "C", does: 0 or denormal, or infinite.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
  if (!std::isfinite(value)) throw Malformed{"beyond the range of doubles"};  // or "nan", "inf"
  return value == 0 ? 0 : value;                                              // -0 is 0
}

void begin_line() { line_left = std::size_t{1} << 36; }

void spend(std::size_t work) {
  if (work > line_left || work > total_left) throw Malformed{"limit: more work than is stated"};
  line_left -= work;
  total_left -= work;
}

}  // namespace verifier
