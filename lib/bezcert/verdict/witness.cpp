#include "bezcert/verdict/witness.hpp"

#include "bezcert/element/map.hpp"

namespace bezcert {

Witness make_witness(const ExactNet& net, Parameter parameter) {
  Rational determinant = evaluate_map(net, parameter).determinant;
  return {std::move(parameter), std::move(determinant)};
}

}  // namespace bezcert
