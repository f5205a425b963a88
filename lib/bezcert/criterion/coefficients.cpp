#include "bezcert/criterion/coefficients.hpp"

#include "bezcert/criterion/quick_net.hpp"

#include <algorithm>

namespace bezcert {
namespace {

bool is_positive(signed char sign) { return sign > 0; }

}  // namespace

Status coefficient_status(const PieceSigns& signs, std::size_t corner_count) {
  if (!std::all_of(signs.corner.begin(), signs.corner.begin() + corner_count, is_positive))
    return Status::refuted;
  return signs.none_negative ? Status::proved : Status::inconclusive;
}

Verdict coefficients(const Forms& forms) {
  JacobianTree tree(forms);
  const PieceSigns signs = tree.signs(JacobianTree::root);
  Verdict verdict = begin_verdict(coefficients_info, coefficient_status(signs, tree.corner_count()));
  if (verdict.status == Status::refuted) {
    const auto corner = static_cast<std::size_t>(
        std::find_if_not(signs.corner.begin(), signs.corner.end(), is_positive) - signs.corner.begin());
    verdict.reason = "det J <= 0 at corner " + std::to_string(corner);
    verdict.witness = make_witness(forms.exact(), tree.corner(JacobianTree::root, corner));
  } else if (verdict.status == Status::inconclusive) {
    verdict.reason = "a Bernstein coefficient of N is negative";
  }
  return verdict;
}

std::optional<Status> quick_coefficients(const QuickNet& net) {
  const auto signs = net.numerator_signs();
  if (!signs) return std::nullopt;
  return coefficient_status(*signs, 3);
}

}  // namespace bezcert
