// Help from threads, which the library does not start itself: whoever has them lends them as a function.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace bezcert {

/// Runs work(i) for all i below a count, in any order or side by side, and returns when all are done; throws
/// what one of them throws. Empty: no threads.
using Parallel = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

/// The same, with or without threads.
inline void run(const Parallel& parallel, std::size_t count, const std::function<void(std::size_t)>& work) {
  if (parallel) return parallel(count, work);
  for (std::size_t i = 0; i < count; ++i) work(i);
}

/// Cuts [0, count) into ranges of at most `size` and runs work(begin, end) for each.
inline void run_ranges(const Parallel& parallel, std::size_t count, std::size_t size,
                       const std::function<void(std::size_t, std::size_t)>& work) {
  run(parallel, (count + size - 1) / size,
      [&](std::size_t i) { work(i * size, std::min(count, (i + 1) * size)); });
}

}  // namespace bezcert
