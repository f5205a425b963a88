// Threads of one run: work side by side, and blocks of work whose results are taken in order.
//
// Nothing that is computed depends on how many there are. With one job everything runs on the calling thread.
#pragma once

#include "bezcert/io/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <optional>
#include <thread>
#include <vector>

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

  /// Runs both, side by side if there are threads for it: the first on the calling thread, the second on one
  /// of its own, which begins sooner than the first of the others.
  template <class First, class Second>
  void at_once(First first, Second second) {
    if (!arena_) {
      first();
      second();
      return;
    }
    std::future<void> other = std::async(std::launch::async, second);  // waits when it is destroyed
    first();
    other.get();
  }

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

  /// How the library may use these threads; empty if there is one. Precondition: this outlives it.
  Parallel parallel() {
    if (!arena_) return {};
    return [this](std::size_t count, const std::function<void(std::size_t)>& work) {
      // Isolated: a thread that waits for the last parts must not begin something long instead.
      arena_->execute([&] {
        oneapi::tbb::this_task_arena::isolate([&] {
          oneapi::tbb::parallel_for(std::size_t{0}, count, work, oneapi::tbb::simple_partitioner());
        });
      });
    };
  }

  /// Cuts [0, count) into blocks, calls prepare(begin, end, result) for each from any thread, and
  /// take(result) in the order of the blocks, one at a time. There are few results, used again and again.
  template <class Result, class Prepare, class Take>
  void in_order(std::size_t count, std::size_t block, Prepare prepare, Take take) {
    if (!arena_) {
      Result result;
      for (std::size_t begin = 0; begin < count; begin += block) {
        prepare(begin, std::min(begin + block, count), result);
        take(result);
      }
      return;
    }
    namespace tbb = oneapi::tbb;
    // The blocks under way follow each other, since they are taken in order: one place each. A place is free
    // when its block has been taken; the flag makes what was done with it known to the next.
    struct Place {
      std::atomic<bool> is_free = true;
      Result result;
    };
    const std::size_t at_once = jobs_ + 1;
    std::vector<Place> places(at_once);
    const auto place = [&](std::size_t begin) -> Place& { return places[begin / block % at_once]; };
    std::size_t next = 0;
    const auto input = [&](tbb::flow_control& control) {
      const std::size_t begin = next;
      if (begin >= count) {
        control.stop();
      } else {
        next = begin + block;
      }
      return begin;
    };
    const auto work = [&](std::size_t begin) {
      Place& own = place(begin);
      while (!own.is_free.exchange(false, std::memory_order_acquire)) std::this_thread::yield();
      prepare(begin, std::min(begin + block, count), own.result);
      return begin;
    };
    const auto output = [&](std::size_t begin) {
      Place& own = place(begin);
      take(own.result);
      own.is_free.store(true, std::memory_order_release);
    };
    constexpr auto in_order = tbb::filter_mode::serial_in_order;
    arena_->execute([&] {
      tbb::parallel_pipeline(
          at_once, tbb::make_filter<void, std::size_t>(in_order, input) &
                       tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, work) &
                       tbb::make_filter<std::size_t, void>(in_order, output));
    });
  }

 private:
  std::size_t jobs_ = 1;
  std::optional<oneapi::tbb::global_control> limit_;
  std::optional<oneapi::tbb::task_arena> arena_;
};

}  // namespace bezcert::certify
