#include "bezcert/criterion/coefficients.hpp"

#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/element/jacobian_tree.hpp"

namespace bezcert {

Verdict coefficients(const Forms& forms) {
  Verdict verdict = begin_verdict(coefficients_info, Status::inconclusive);
  JacobianTree tree(forms);
  const PieceSigns signs = tree.signs(JacobianTree::root);
  if (tree.proves_positive(signs)) {
    verdict.status = Status::proved;
    return verdict;
  }
  for (std::size_t corner = 0; corner < tree.corner_count(); ++corner) {
    if (signs.corner[corner] > 0) continue;
    verdict.status = Status::refuted;
    verdict.reason = "det J <= 0 at corner " + std::to_string(corner);
    verdict.witness = make_witness(forms.exact(), tree.corner(JacobianTree::root, corner));
    return verdict;
  }
  verdict.reason = "a Bernstein coefficient of N is negative";
  return verdict;
}

std::optional<Status> quick_coefficients(const QuickNet& net) {
  const QuickNet::NumeratorSigns signs = net.numerator_signs();
  if (!signs.certain) return std::nullopt;
  if (signs.all_positive) return Status::proved;
  return signs.corners_positive ? Status::inconclusive : Status::refuted;
}

}  // namespace bezcert
