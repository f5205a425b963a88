#include "bezcert/proof/verdict.hpp"

namespace bezcert {

Witness make_witness(const Element& element, Parameter parameter) {
  Rational determinant = jacobian_determinant(element, parameter);
  return {std::move(parameter), std::move(determinant)};
}

std::string_view name(Claim claim) { return claim == Claim::regular ? "regular" : "injective"; }

std::string_view name(Status status) {
  switch (status) {
    case Status::proved: return "proved";
    case Status::refuted: return "refuted";
    case Status::inconclusive: return "inconclusive";
    case Status::not_applicable: return "not_applicable";
  }
  return "";
}

std::string to_string(const Parameter& parameter) {
  std::string text = "(";
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    if (i > 0) text += ", ";
    text += to_string(parameter[i]);
  }
  return text + ")";
}

}  // namespace bezcert
