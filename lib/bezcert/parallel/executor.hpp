// Threads that the library is lent: it starts none itself.
//
// Whoever calls the library and has threads gives an Executor; results never depend on it. A null pointer
// stands for the calling thread alone. An example with oneTBB: certify/threads.hpp; with std::thread:
// examples/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace bezcert {

class Executor {
 public:
  virtual ~Executor() = default;

  /// How many works may run side by side, at least 1.
  virtual std::size_t threads() const = 0;

  /// Runs work(i) for all i < count, in any order or side by side, and returns when all are done; then throws
  /// what one of them threw, if one did.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& work) = 0;
};

/// Whether there is anything to gain from an executor.
inline bool has_threads(const Executor* executor) { return executor != nullptr && executor->threads() > 1; }

/// Cuts [0, count) into ranges of at most `size` and runs work(begin, end) for each.
inline void run_ranges(Executor* executor, std::size_t count, std::size_t size,
                       const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t ranges = (count + size - 1) / size;
  const auto range = [&](std::size_t i) { work(i * size, std::min(count, (i + 1) * size)); };
  if (has_threads(executor)) return executor->run(ranges, range);
  for (std::size_t i = 0; i < ranges; ++i) range(i);
}

}  // namespace bezcert
