// Threads of one run: work side by side, and blocks of work whose results are taken in order.
//
// Nothing that is computed depends on how many there are. With one job everything runs on the calling thread.
#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace bezcert::certify {

class Workers {
 public:
  /// 0: as many as there are cores.
  explicit Workers(int jobs) {
    if (jobs == 0) jobs = oneapi::tbb::info::default_concurrency();
    if (jobs > 1) {
      // More than there are cores too: without this the library warns on standard error.
      limit_.emplace(oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
      arena_.emplace(jobs);
    }
    jobs_ = static_cast<std::size_t>(std::max(jobs, 1));
  }

  std::size_t jobs() const { return jobs_; }

  /// Runs both, side by side if there are threads for it; the first, which is to be the one that takes much
  /// memory (memory.hpp), on the calling thread.
  template <class First, class Second>
  void both(First first, Second second) {
    if (!arena_) {
      first();
      second();
      return;
    }
    arena_->execute([&] {
      oneapi::tbb::task_group other;
      other.run(second);
      try {
        first();
      } catch (...) {
        other.cancel();
        other.wait();
        throw;
      }
      other.wait();
    });
  }

  /// Runs work(i) for i below `count`.
  template <class Work>
  void each(std::size_t count, Work work) {
    if (!arena_) {
      for (std::size_t i = 0; i < count; ++i) work(i);
      return;
    }
    arena_->execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, count, work); });
  }

  /// Cuts [0, count) into blocks, calls prepare(begin, end) for each from any thread, and take(its result) in
  /// the order of the blocks, one at a time. Few blocks are alive at once.
  template <class Prepare, class Take>
  void in_order(std::size_t count, std::size_t block, Prepare prepare, Take take) {
    if (!arena_) {
      for (std::size_t begin = 0; begin < count; begin += block) {
        take(prepare(begin, std::min(begin + block, count)));
      }
      return;
    }
    namespace tbb = oneapi::tbb;
    using Result = decltype(prepare(count, count));
    std::size_t next = 0;
    arena_->execute([&] {
      tbb::parallel_pipeline(
          jobs_ + 1,
          tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                              [&](tbb::flow_control& control) {
                                                const std::size_t begin = next;
                                                if (begin >= count) {
                                                  control.stop();
                                                } else {
                                                  next = begin + block;
                                                }
                                                return begin;
                                              }) &
              tbb::make_filter<std::size_t, Result>(
                  tbb::filter_mode::parallel,
                  [&](std::size_t begin) { return prepare(begin, std::min(begin + block, count)); }) &
              tbb::make_filter<Result, void>(tbb::filter_mode::serial_in_order,
                                             [&](Result result) { take(std::move(result)); }));
    });
  }

 private:
  std::size_t jobs_ = 1;
  std::optional<oneapi::tbb::global_control> limit_;
  std::optional<oneapi::tbb::task_arena> arena_;
};

}  // namespace bezcert::certify
