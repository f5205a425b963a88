#include "bezcert/curve/box.hpp"

#include <limits>
#include <numeric>

namespace bezcert {

Box box_of(const RoundUp&, const CurveNet<Interval>& net) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box box{infinite, -infinite, infinite, -infinite};
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Interval x = net.x[i] / net.w[i], y = net.y[i] / net.w[i];
    const bool known = x.inf() <= x.sup() && y.inf() <= y.sup();
    if (!known) return {-infinite, infinite, -infinite, infinite};  // a NaN: overflow
    box.add({x.inf(), x.sup(), y.inf(), y.sup()});
  }
  return box;
}

void for_overlapping_boxes(std::span<const Box> boxes,
                           const std::function<bool(std::size_t, std::size_t)>& visit) {
  // A sweep along x with a list of the boxes that are open there.
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(boxes[a].x_low, a) < std::pair(boxes[b].x_low, b);
  });
  std::vector<std::size_t> open;
  for (const std::size_t box : order) {
    std::size_t kept = 0;
    for (const std::size_t other : open) {
      if (boxes[other].x_high < boxes[box].x_low) continue;
      open[kept++] = other;
      if (!boxes[other].overlaps(boxes[box])) continue;
      if (!visit(std::min(other, box), std::max(other, box))) return;
    }
    open.resize(kept);
    open.push_back(box);
  }
}

}  // namespace bezcert
