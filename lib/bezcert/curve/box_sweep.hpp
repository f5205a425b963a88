// Pairs of overlapping boxes: a sweep along x with a list of the boxes that are open there.
#pragma once

#include "bezcert/surface/half_edges.hpp"

#include <functional>
#include <span>

namespace bezcert {

/// Calls visit(i, j), i < j, for every pair of boxes that overlap or touch, in an order that depends on the
/// boxes only; stops when it returns false.
void for_overlapping_boxes(std::span<const Box> boxes,
                           const std::function<bool(std::size_t, std::size_t)>& visit);

}  // namespace bezcert
