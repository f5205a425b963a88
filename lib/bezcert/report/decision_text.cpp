#include "bezcert/report/decision_text.hpp"

namespace bezcert {
namespace {

constexpr std::size_t longest_exact_text = 40;

// Exact if that is short, else decimal: the exact value is in the JSON report and in `explain`.
std::string determinant_text(const Rational& value) {
  const std::string exactly = to_string(value);
  return exactly.size() <= longest_exact_text ? "= " + exactly : "~ " + to_decimal(value);
}

std::string range_text(const BoundaryRange& range) {
  std::string text = "edge " + std::to_string(range.edge);
  if (range.lower == range.upper) return text + " at " + to_string(range.lower);
  return text + " in [" + to_string(range.lower) + ", " + to_string(range.upper) + "]";
}

std::string coordinate_text(const RealRoot& x) {
  if (x.is_rational()) return to_string(x.lower);
  return "in [" + to_decimal(x.lower, 13) + ", " + to_decimal(x.upper, 13) + "]";
}

// The zero set of det J of a degenerate element; a rational zero is shown as the witness already.
std::string zero_text(const AlgebraicZero& zero) {
  std::string text;
  if (!zero.at.is_rational()) {
    text = ", det J = 0 at u " + coordinate_text(zero.at.u) + ", v " + coordinate_text(zero.at.v);
  }
  switch (zero.dimension) {
    case 0: return text + ", finitely many zeros";
    case 1: return text + ", zeros along a curve";
    case 2: return text + ", zero everywhere";
    default: return text;
  }
}

template <class Write>
std::string list_text(const std::vector<Rational>& numbers, Write write) {
  std::string text = "(";
  for (const Rational& number : numbers) text += (text.size() > 1 ? ", " : "") + write(number);
  return text + ")";
}

}  // namespace

std::string decimal_text(const std::vector<Rational>& numbers) {
  return list_text(numbers, [](const Rational& number) { return to_decimal(number); });
}

std::string exact_text(const std::vector<Rational>& numbers) {
  return list_text(numbers, [](const Rational& number) { return to_string(number); });
}

std::string text_of(const ExhaustedBudget& budget) {
  using Limit = ExhaustedBudget::Limit;
  const std::string allowed = std::to_string(budget.allowed), needed = std::to_string(budget.needed);
  switch (budget.limit) {
    case Limit::depth: return "subdivision depth " + allowed;
    case Limit::pieces: return "subdivision pieces " + allowed;
    case Limit::memory_bits: return "subdivision bits " + allowed + " (the numbers are too long)";
    case Limit::factoring_bits:
      return "algebra bits " + allowed + " (N has " + needed +
             " bits, to be factored within a sixteenth of that)";
    case Limit::factor_bits:
      return "algebra bits " + allowed + " (a factor of N of degree " + std::to_string(budget.degree_u) +
             " in u and " + std::to_string(budget.degree_v) + " in v needs " + needed + ")";
    case Limit::contact_bits:
      return "algebra bits " + allowed + " (the contact of two edges needs " + needed + ")";
  }
  return "";
}

std::string open_text(const Decision& decision) {
  std::string text;
  for (const ExhaustedBudget& budget : decision.exhausted) {
    text += (text.empty() ? "budget: " : "; budget: ") + text_of(budget);
  }
  if (decision.verdict == ElementVerdict::regular) text += " (det J > 0, injectivity open)";
  if (decision.verdict == ElementVerdict::undecided && decision.witness &&
      decision.witness->determinant.sign() < 0) {
    text += " (folded or reversed)";
  }
  return text;
}

std::string describe(const Decision& decision) {
  std::string text(name(decision.verdict));
  if (decision.verdict == ElementVerdict::reversed) text += " (clockwise: det J < 0 everywhere)";
  if (decision.witness) {
    text += ", det J " + determinant_text(decision.witness->determinant) + " at " +
            to_string(decision.witness->parameter) + ", the point " + decimal_text(decision.witness->place);
  }
  if (decision.zero) text += zero_text(*decision.zero);
  if (decision.overlap) {
    text += std::string(", det J > 0 but the boundary ") +
            (decision.overlap->along_a_piece ? "runs along itself: " : "meets itself: ") +
            range_text(decision.overlap->first) + " and " + range_text(decision.overlap->second);
  }
  if (const std::string open = open_text(decision); !open.empty()) text += "; open: " + open;
  return text;
}

}  // namespace bezcert
