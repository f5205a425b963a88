#include "bezcert/certificate/sign_evidence.hpp"

#include "bezcert/certificate/column_evidence.hpp"
#include "bezcert/certificate/evidence_text.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// As in the decision: factoring is dear for long coefficients alone.
constexpr std::size_t max_bits_to_factor = std::size_t{1} << 21;

std::string tree_text(const std::string& bits) { return bits == "0" ? "coefficients" : "tree " + bits; }

// SIGN of an irreducible polynomial. For weak signs the subdivision is a short try: it meets its depth at the
// first zero.
std::optional<std::string> irreducible_evidence(const Bivariate& h, Domain domain, Strictness wanted) {
  TreeLimits limits;
  if (wanted == Strictness::weak) limits.pieces = 1024;
  if (const auto bits = sign_tree(to_bernstein(h, domain), wanted, limits)) return tree_text(*bits);
  return column_evidence(h, domain, wanted);
}

Bivariate negated(const Bivariate& f) { return Bivariate() - f; }

std::optional<std::string> algebraic_evidence(const Polynomial<Integer>& n, int direction,
                                              Strictness wanted) {
  std::size_t bits = 0;
  for (const Integer& c : n.coefficients) bits += mpz_sizeinbase(c.backend().data(), 2);
  if (bits > max_bits_to_factor) return std::nullopt;
  const Domain domain = n.shape.domain;
  const Bivariate powers = to_power_basis(n);
  const auto factors = irreducible_factors(powers);
  if (factors.size() == 1 && factors[0].second == 1) {
    return column_evidence(direction > 0 ? powers : negated(powers), domain, wanted);
  }
  std::string text = "factors " + std::to_string(factors.size());
  for (const auto& [factor, multiplicity] : factors) {
    text += ' ' + std::to_string(multiplicity) + ' ' + text_of_polynomial2(factor) + ' ';
    if (multiplicity % 2 == 0 && wanted == Strictness::weak) {
      text += "none";
      continue;
    }
    const int s = some_sign(factor);  // it has one sign on the domain
    const auto proof = irreducible_evidence(s > 0 ? factor : negated(factor), domain, wanted);
    if (!proof) return std::nullopt;
    text += (s > 0 ? "+ " : "- ") + *proof;
  }
  return text;
}

std::optional<std::string> find_evidence(const Forms& forms, const Decision& decision, int direction,
                                         Strictness wanted) {
  if (decision.sign_proof == SignProof::coefficients) return "coefficients";
  TreeLimits limits;
  if (decision.sign_proof == SignProof::subdivision) {
    // The same pieces, in another order.
    limits.pieces = max_tree_pieces;
    limits.depth = max_tree_depth;
  }
  // The decision by algebra has spent pieces on N before: for a weak sign more of them do not help.
  if (decision.sign_proof == SignProof::subdivision || wanted == Strictness::strict) {
    if (const auto bits = sign_tree(forms, direction, wanted, limits)) return tree_text(*bits);
  }
  return algebraic_evidence(forms.exact_jacobian().numerator, direction, wanted);
}

}  // namespace

std::optional<std::string> sign_evidence(const Forms& forms, const Decision& decision, WantedSign wanted) {
  auto text = find_evidence(forms, decision, wanted == WantedSign::negative ? -1 : 1,
                            wanted == WantedSign::nonnegative ? Strictness::weak : Strictness::strict);
  if (text && !within_limits(*text)) return std::nullopt;
  return text;
}

}  // namespace bezcert
