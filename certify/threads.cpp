#include "threads.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include <thread>

namespace bezcert::certify {

Threads::Threads(int jobs) : threads_(static_cast<std::size_t>(jobs)) {
  if (jobs == 0) threads_ = std::max(1U, std::thread::hardware_concurrency());
}

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (!arena_ && threads_ > 1) {
    // More than there are cores too: without this the library warns on standard error.
    limit_.emplace(oneapi::tbb::global_control::max_allowed_parallelism, threads_);
    arena_.emplace(static_cast<int>(threads_));
  }
  if (!arena_) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  // Isolated: a thread that waits for the last parts must not begin something long instead.
  arena_->execute([&] {
    oneapi::tbb::this_task_arena::isolate(
        [&] { oneapi::tbb::parallel_for(std::size_t{0}, count, work, oneapi::tbb::simple_partitioner()); });
  });
}

}  // namespace bezcert::certify
