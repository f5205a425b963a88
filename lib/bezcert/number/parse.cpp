#include "bezcert/number/parse.hpp"

#include "bezcert/number/interval.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>

namespace bezcert {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A decimal taken apart: (-1)^negative * digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;
};

std::optional<Decimal> split_decimal(std::string_view text) {
  if (text.empty() || text.size() > max_number_length) return std::nullopt;
  Decimal result;
  std::size_t at = 0;
  if (text[at] == '-' || text[at] == '+') result.negative = text[at++] == '-';
  while (at < text.size() && is_digit(text[at])) result.digits += text[at++];
  if (at < text.size() && text[at] == '.') {
    ++at;
    while (at < text.size() && is_digit(text[at])) {
      result.digits += text[at++];
      --result.exponent;
    }
  }
  if (result.digits.empty()) return std::nullopt;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && text[at] == '+') {
      ++at;
      if (at < text.size() && text[at] == '-') return std::nullopt;
    }
    long power = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), power);
    if (error != std::errc() || std::labs(power) > max_decimal_exponent) return std::nullopt;
    at = static_cast<std::size_t>(end - text.data());
    result.exponent += power;
  }
  if (at != text.size()) return std::nullopt;
  return result;
}

Integer power_of_ten(long exponent) {
  Integer result;
  mpz_ui_pow_ui(result.backend().data(), 10, static_cast<unsigned long>(exponent));
  return result;
}

Integer integer_of_digits(const std::string& digits) {
  Integer result;
  mpz_set_str(result.backend().data(), digits.c_str(), 10);
  return result;
}

Rational value_of(const Decimal& decimal) {
  Integer digits = integer_of_digits(decimal.digits);
  if (decimal.negative) digits = -digits;
  if (decimal.exponent >= 0) return Rational(Integer(digits * power_of_ten(decimal.exponent)));
  return Rational(digits, power_of_ten(-decimal.exponent));
}

// The double nearest to a number, ties to even, in any rounding mode; nothing beyond the range.
std::optional<double> nearest_to(const Rational& x) {
  const Interval around = to_interval(x);
  const double lower = around.inf(), upper = around.sup();
  const auto end = [](double bound) {
    if (std::isfinite(bound)) return exact(bound);
    return Rational(bound < 0 ? -1 : 1) * power_of_two(1024);
  };
  const Rational middle = (end(lower) + end(upper)) / 2;
  const bool lower_is_even = std::bit_cast<std::uint64_t>(lower) % 2 == 0;
  const double nearest = x < middle || (x == middle && lower_is_even) ? lower : upper;
  return std::isfinite(nearest) ? std::optional(nearest) : std::nullopt;
}

}  // namespace

std::optional<double> parse_binary64(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && std::isfinite(value)) {
    // libstdc++'s from_chars rounds in the current mode where digits and exponent are few.
    if (rounds_to_nearest() || value == 0) return value;
    const auto decimal = split_decimal(text);
    return decimal ? nearest_to(value_of(*decimal)) : value;
  }
  if (error != std::errc::result_out_of_range || end != text.data() + text.size()) return std::nullopt;
  // Out of range both ways is one error code: the exact value tells which.
  const auto decimal = split_decimal(text);
  if (!decimal) return std::nullopt;
  const Rational exact_value = value_of(*decimal);
  if (abs(exact_value) >= 1) return std::nullopt;
  return exact_value.sign() < 0 ? -0.0 : 0.0;
}

std::optional<Rational> parse_decimal(std::string_view text) {
  const auto decimal = split_decimal(text);
  if (!decimal) return std::nullopt;
  return value_of(*decimal);
}

std::optional<Rational> parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_decimal(text);
  const auto is_integer = [](std::string_view part, bool may_be_negative) {
    if (may_be_negative && !part.empty() && part.front() == '-') part.remove_prefix(1);
    if (part.empty() || part.size() > max_number_length) return false;
    for (const char c : part) {
      if (!is_digit(c)) return false;
    }
    return true;
  };
  const std::string_view above = text.substr(0, slash);
  const std::string_view below = text.substr(slash + 1);
  if (!is_integer(above, true) || !is_integer(below, false)) return std::nullopt;
  const Integer denominator = integer_of_digits(std::string(below));
  if (denominator == 0) return std::nullopt;
  return Rational(integer_of_digits(std::string(above)), denominator);
}

}  // namespace bezcert
