// Blocks of work that are prepared side by side and taken one after another, in their order.
//
// There are few blocks at a time, whose memory is used again and again: threads that ask for memory at every
// element wait for each other. No thread waits for one that does not run: the first block that is not taken
// yet is always held by a thread that works on it, so an executor may run its works one after another as
// well.
#pragma once

#include "bezcert/parallel/executor.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace bezcert {

template <class Block>
class InOrder {
 public:
  using Prepare = std::function<void(std::size_t begin, std::size_t end, Block&)>;
  using Take = std::function<void(Block&)>;

  /// Blocks of at most `size` items of [0, count). `make()` makes a block of memory.
  InOrder(std::size_t count, std::size_t size, std::function<Block()> make)
      : count_(count), size_(size), make_(std::move(make)) {}

  /// Calls prepare(begin, end, block) for all blocks, from any thread, and take(block) in their order, one at
  /// a time. `first` is called once, before or beside them. Throws what one of the three throws.
  void run(Executor* executor, const std::function<void()>& first, const Prepare& prepare, const Take& take) {
    if (!has_threads(executor)) {
      first();
      Block block = make_();
      for (std::size_t begin = 0; begin < count_; begin += size_) {
        prepare(begin, std::min(begin + size_, count_), block);
        take(block);
      }
      return;
    }
    const std::size_t threads = executor->threads();
    for (std::size_t i = 0; i < 2 * threads; ++i) places_.emplace_back(make_);
    executor->run(threads, [&](std::size_t thread) {
      try {
        if (thread == 0) first();
        work(prepare, take);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failed_ = true;
        changed_.notify_all();
        throw;
      }
    });
  }

 private:
  struct Place {
    explicit Place(const std::function<Block()>& make) : block(make()) {}
    Block block;
    bool is_ready = false;
  };

  void work(const Prepare& prepare, const Take& take) {
    std::unique_lock lock(mutex_);
    while (!failed_ && next_ * size_ < count_) {
      const std::size_t number = next_++, begin = number * size_;
      changed_.wait(lock, [&] { return failed_ || number < taken_ + places_.size(); });
      if (failed_) return;
      Place& own = places_[number % places_.size()];
      lock.unlock();
      prepare(begin, std::min(begin + size_, count_), own.block);
      lock.lock();
      own.is_ready = true;
      take_ready(take, lock);
    }
  }

  // The blocks that are next in order, unless another thread is at it: that one sees this block as well.
  void take_ready(const Take& take, std::unique_lock<std::mutex>& lock) {
    if (is_taking_) return;
    is_taking_ = true;
    for (Place* place = &places_[taken_ % places_.size()]; place->is_ready && !failed_;
         place = &places_[taken_ % places_.size()]) {
      lock.unlock();
      take(place->block);
      lock.lock();
      place->is_ready = false;
      ++taken_;
      changed_.notify_all();
    }
    is_taking_ = false;
  }

  std::size_t count_, size_;
  std::function<Block()> make_;
  std::deque<Place> places_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0, taken_ = 0;
  bool is_taking_ = false, failed_ = false;
};

}  // namespace bezcert
