// Directions of few digits in an open cone: the n of the rules `m`, `s` and `j` of certificates.
//
// A rule asks for n with n . v > 0 for its `strict` vectors and n . v >= 0 for the others. The middle of the
// cone of such n is found in doubles and rounded to integers, the shortest first; the caller decides exactly
// whether one of them holds. So doubles decide only what is tried, and in which order. They must be rounded
// from exact coordinates, not from intervals: then the direction found does not depend on the filter. Where
// the cone is too thin for doubles, or just a line, it is found exactly.
#pragma once

#include "bezcert/curve/vector.hpp"
#include "bezcert/number/rational.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bezcert {

using Direction = Vector2<Integer>;

/// "x y".
std::string text_of(const Direction& n);

/// A vector that is asked about: n . v > 0 if strict, else n . v >= 0.
template <class T>
struct AskedVector {
  Vector2<T> v;
  bool strict = true;
};

/// A direction that `holds`. `rounded` and `exact()` are the same vectors up to positive factors, of any size
/// each; `holds` must be exact. Nothing if there is none (or, at the worst, if it is not found). Always to be
/// called in the same rounding mode.
std::optional<Direction> find_direction(const std::vector<AskedVector<double>>& rounded,
                                        const std::function<std::vector<AskedVector<Integer>>()>& exact,
                                        const std::function<bool(const Direction&)>& holds);

}  // namespace bezcert
