#include "options.hpp"

#include <algorithm>
#include <charconv>

namespace bezcert::certify {
namespace {

std::size_t natural(std::string_view digits, std::size_t low, std::size_t high) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value < low || value > high) {
    throw CLI::ValidationError(
        "--budget", "\"" + std::string(digits) +
                        "\": expected PIECES from 1 to 1000000, or PIECES,BITS with BITS from 0 to "
                        "1000000000000");
  }
  return value;
}

Budget parse_budget(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  Budget budget;
  budget.pieces = natural(std::string_view(text).substr(0, comma), 1, 1000000);
  // In proportion, and none with one piece: the coefficients alone.
  budget.algebra_bits = comma < text.size()
                            ? natural(std::string_view(text).substr(comma + 1), 0, 1000000000000)
                            : (budget.pieces - 1) << 13;
  budget.contact.algebra_bits = budget.algebra_bits;
  return budget;
}

std::vector<const Criterion*> parse_criteria(const std::string& text) {
  std::vector<const Criterion*> result;
  if (text == "none") return result;
  if (text == "all") return all_criteria();
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string one = text.substr(at, comma - at);
    const Criterion* criterion = find_criterion(one);
    if (criterion == nullptr) {
      std::string known;
      for (const Criterion& each : criteria()) known += ", " + std::string(each.name);
      throw CLI::ValidationError("--criteria", "\"" + one + "\" is no criterion: expected all, none" + known);
    }
    if (std::find(result.begin(), result.end(), criterion) == result.end()) result.push_back(criterion);
    at = comma + 1;
  }
  return result;
}

}  // namespace

void add_read_options(CLI::App& command, ReadOptions& options) {
  command
      .add_option_function<std::string>(
          "--basis",
          [&options](const std::string& word) {
            options.basis = word == "lagrange" ? Basis::lagrange : Basis::bernstein;
          },
          "what the points of a .msh are: lagrange nodes (default) or bernstein control points")
      ->check(CLI::IsMember({"lagrange", "bernstein"}))
      ->option_text("lagrange|bernstein");
  command
      .add_option_function<std::string>(
          "--numbers",
          [&options](const std::string& word) {
            options.numbers = word == "binary64" ? Numbers::binary64 : Numbers::decimal;
          },
          "what text coordinates of a .msh mean: the nearest double (default) or their decimal value")
      ->check(CLI::IsMember({"binary64", "decimal"}))
      ->option_text("binary64|decimal");
}

void add_budget(CLI::App& command, Budget& budget) {
  command
      .add_option_function<std::string>(
          "--budget", [&budget](const std::string& text) { budget = parse_budget(text); },
          "pieces of the subdivision of one element (default 4096), and bits of the largest resultant that "
          "algebra is asked about (default 8192 (PIECES - 1); 0: no algebra)")
      ->option_text("PIECES[,BITS]");
}

void add_criteria_choice(CLI::App& command, std::vector<const Criterion*>& chosen) {
  chosen = all_criteria();
  command
      .add_option_function<std::string>(
          "--criteria", [&chosen](const std::string& text) { chosen = parse_criteria(text); },
          "published conditions to hold against the decision (default all)")
      ->option_text("all|none|LIST");
}

}  // namespace bezcert::certify
