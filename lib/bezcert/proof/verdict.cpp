#include "bezcert/proof/verdict.hpp"

#include "bezcert/element/map.hpp"

namespace bezcert {

Witness make_witness(const Element& element, Parameter parameter) {
  Rational determinant = evaluate_map(element, parameter).determinant;
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

}  // namespace bezcert
