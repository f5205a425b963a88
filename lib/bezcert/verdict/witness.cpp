#include "bezcert/verdict/witness.hpp"

#include "bezcert/element/map.hpp"

namespace bezcert {

Witness make_witness(const ExactNet& net, Parameter parameter) {
  MapValue value = evaluate_map(net, parameter);
  return {std::move(parameter), std::move(value.determinant), std::move(value.place)};
}

}  // namespace bezcert
