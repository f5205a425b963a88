// The map of an element and its Jacobian determinant at one parameter, exactly: evidence that stands on its
// own.
//
// De Casteljau's algorithm straight on the control net, nothing of the polynomial N (jacobian.hpp).
#pragma once

#include "bezcert/element/net.hpp"
#include "bezcert/element/parameter.hpp"

#include <vector>

namespace bezcert {

/// The image of a parameter, one number a coordinate in the units of the element, and det J there.
struct MapValue {
  std::vector<Rational> place;
  Rational determinant;
};

/// Throws std::invalid_argument if the parameter is of another domain. Precondition: W is not 0 there (true
/// on the closed domain, where W > 0).
MapValue evaluate_map(const ExactNet& net, const Parameter& parameter);

/// The same, with a net made for this alone.
MapValue evaluate_map(const Element& element, const Parameter& parameter);

}  // namespace bezcert
