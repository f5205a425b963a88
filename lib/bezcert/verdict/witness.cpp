#include "bezcert/verdict/witness.hpp"

#include "bezcert/element/jacobian.hpp"

namespace bezcert {

Witness make_witness(const Element& element, Parameter parameter) {
  Rational determinant = jacobian_determinant(element, parameter);
  return {std::move(parameter), std::move(determinant)};
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
