#include "bezcert/number/outward.hpp"

#include <cmath>

namespace bezcert {
namespace {

template <class Round>
std::optional<Dyadic> common(const Interval& enclosure, Round round) {
  const double lower = enclosure.inf();
  const double upper = enclosure.sup();
  if (!std::isfinite(lower) || !std::isfinite(upper)) return std::nullopt;
  if (!certain_sign(enclosure)) return std::nullopt;
  const Dyadic at_lower = round(lower);
  // Equal grid points at both ends with equal steps: the rounding is constant in between.
  if (at_lower != round(upper)) return std::nullopt;
  return at_lower;
}

}  // namespace

std::optional<Dyadic> round_down(const Interval& enclosure, int bits) {
  return common(enclosure, [&](double x) { return round_down(x, bits); });
}
std::optional<Dyadic> round_up(const Interval& enclosure, int bits) {
  return common(enclosure, [&](double x) { return round_up(x, bits); });
}

}  // namespace bezcert
