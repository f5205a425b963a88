#include "bezcert/curve/box_sweep.hpp"

#include <algorithm>
#include <numeric>

namespace bezcert {

void for_overlapping_boxes(std::span<const Box> boxes,
                           const std::function<bool(std::size_t, std::size_t)>& visit) {
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
