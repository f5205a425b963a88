#include "bezcert/verdict/element_verdict.hpp"

namespace bezcert {

std::string_view name(ElementVerdict verdict) {
  switch (verdict) {
    case ElementVerdict::injective: return "injective";
    case ElementVerdict::regular: return "regular";
    case ElementVerdict::overlapping: return "overlapping";
    case ElementVerdict::degenerate: return "degenerate";
    case ElementVerdict::folded: return "folded";
    case ElementVerdict::reversed: return "reversed";
    case ElementVerdict::undecided: return "undecided";
  }
  return "";
}

bool is_regular(ElementVerdict verdict) {
  return verdict == ElementVerdict::injective || verdict == ElementVerdict::regular ||
         verdict == ElementVerdict::overlapping;
}

bool is_invalid(ElementVerdict verdict) {
  return verdict == ElementVerdict::overlapping || verdict == ElementVerdict::degenerate ||
         verdict == ElementVerdict::folded || verdict == ElementVerdict::reversed;
}

std::string_view name(SignProof proof) {
  switch (proof) {
    case SignProof::coefficients: return "coefficients";
    case SignProof::subdivision: return "subdivision";
    case SignProof::algebra: return "algebra";
  }
  return "";
}

std::string_view name(InjectivityProof proof) {
  switch (proof) {
    case InjectivityProof::none: return "";
    case InjectivityProof::midpoint: return "midpoint";
    case InjectivityProof::jacobian_hull: return "jacobian_hull";
    case InjectivityProof::orientation: return "orientation";
    case InjectivityProof::boundary: return "boundary";
  }
  return "";
}

}  // namespace bezcert
