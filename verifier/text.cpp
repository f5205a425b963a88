// Tokens of certificates: strict, one spelling a value; decimals of elements files; the limits of work.
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace verifier {

namespace {

constexpr std::size_t most_digits = 1'262'611;   // of a number: less than 2^22 bits
constexpr std::size_t most_coefficients = 4097;  // of a POLY, and rows of a POLY2
constexpr long most_in_poly2 = 1 << 20;          // coefficients of a POLY2
constexpr long most_power_of_ten = 1'000'000;    // of decimals
constexpr std::size_t most_in_line = std::size_t{1} << 36, most_in_all = std::size_t{1} << 40;  // work
std::size_t line_left = most_in_line, total_left = most_in_all;

/// An optional - and digits.
mpz_class from_digits(std::string_view text) {
  const std::string_view digits = text.substr(text.starts_with('-'));
  if (digits.empty() || digits.find_first_not_of("0123456789") != text.npos) throw Malformed{"not a number"};
  if (digits.size() > most_digits) throw Malformed{"limit: number of more than 2^22 bits"};
  spend(8 * digits.size());
  return mpz_class(std::string(text), 10);
}

mpz_class integer_of(std::string_view text) {
  if (text != "0" && (text.starts_with('0') || text.starts_with("-0")))
    throw Malformed{"not an integer in its one spelling"};
  return from_digits(text);
}

long small_of(std::string_view text, long low, long high) {
  const mpz_class value = integer_of(text);
  if (value < low || value > high) throw Malformed{"integer out of its range"};
  return value.get_si();
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
  f.denominator = integer_of(token.substr(slash + 1));
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

std::string_view Tokens::next() const {
  return at_end() ? std::string_view() : line_.substr(at_, line_.find(' ', at_) - at_);
}

std::string_view Tokens::word() {
  const std::string_view token = next();
  if (token.empty()) throw Malformed{"the line ends too early, or has two blanks"};
  at_ += token.size() + 1;
  return token;
}

bool Tokens::accept(std::string_view word) {
  if (next() != word) return false;
  at_ += word.size() + 1;
  return true;
}

void Tokens::expect_end() const {
  if (!at_end()) throw Malformed{"the line goes on where it should end"};
}

mpz_class Tokens::integer() { return integer_of(word()); }
long Tokens::small(long low, long high) { return small_of(word(), low, high); }
Polynomial Tokens::polynomial() { return polynomial_of(word()); }
RationalPolynomial Tokens::rational_polynomial() { return fraction_of(word()); }

mpq_class Tokens::rational() {
  const RationalPolynomial value = fraction_of(word());
  if (value.numerator.size() > 1) throw Malformed{"expected one number"};
  return value.numerator.empty() ? mpq_class(0) : mpq_class(value.numerator[0], value.denominator);
}

Polynomial2 Tokens::polynomial2() {
  const std::string_view token = word();
  const auto separators =
      std::count(token.begin(), token.end(), ',') + std::count(token.begin(), token.end(), ';');
  if (separators >= most_in_poly2) throw Malformed{"limit: polynomial of more than 2^20 coefficients"};
  Polynomial2 f;
  for (const std::string_view part : split(token, ';')) f.push_back(polynomial_of(part));
  if (f.back().empty()) throw Malformed{"the last coefficient is 0"};
  return f;
}

std::string_view Tokens::bits() {
  const std::string_view token = word();
  if (token.find_first_not_of("01") != token.npos) throw Malformed{"expected a string of 0 and 1"};
  return token;
}

EdgeName Tokens::edge_name() {
  const std::vector<std::string_view> parts = split(word(), '.');
  if (parts.size() != 2) throw Malformed{"expected position.edge"};
  const long position = small_of(parts[0], 1, 0xffffffff);
  return {static_cast<std::size_t>(position - 1), static_cast<int>(small_of(parts[1], 0, 3))};
}

mpq_class exact_number(std::string_view text, bool fractions) {
  mpq_class value;
  if (const std::size_t slash = text.find('/'); fractions && slash != text.npos) {
    value = mpq_class(integer_of(text.substr(0, slash)), integer_of(text.substr(slash + 1)));
    if (value.get_den() <= 0) throw Malformed{"denominator not positive"};
  } else {
    const std::size_t e = std::min(text.find_first_of("eE"), text.size()), dot = std::min(text.find('.'), e);
    std::string number(text.substr(0, e));
    std::string_view exponent = e < text.size() ? text.substr(e + 1) : "0";
    if (exponent.starts_with('+') && !exponent.starts_with("+-")) exponent.remove_prefix(1);
    mpz_class power = from_digits(exponent);
    if (dot < e) number.erase(dot, 1), power -= e - dot - 1;
    if (abs(power) > most_power_of_ten) throw Malformed{"limit: power of ten"};
    const unsigned long zeros = mpz_get_ui(power.get_mpz_t());  // its absolute value
    spend(16 * zeros);
    mpz_class scale;
    mpz_ui_pow_ui(scale.get_mpz_t(), 10, zeros);
    value.get_num() = from_digits(number);
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
  return value;
}

void begin_line() { line_left = most_in_line; }

void spend(std::size_t work) {
  if (work > line_left || work > total_left) throw Malformed{"limit: more work than is stated"};
  line_left -= work;
  total_left -= work;
}

}  // namespace verifier
