// Threads change nothing: every block is made once, blocks are taken in order, errors come through.
#include "bezcert/parallel/in_order.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace bezcert;

namespace {

// A thread each for so many works at a time; with `one_by_one` the works follow each other on the calling
// thread, which an executor may do as well.
class TestThreads : public Executor {
 public:
  explicit TestThreads(std::size_t threads, bool one_by_one = false)
      : threads_(threads), one_by_one_(one_by_one) {}

  std::size_t threads() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override {
    if (one_by_one_) {
      for (std::size_t i = 0; i < count; ++i) work(i);
      return;
    }
    std::vector<std::exception_ptr> errors(count);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count; ++i) {
      threads.emplace_back([&, i] {
        try {
          work(i);
        } catch (...) {
          errors[i] = std::current_exception();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
  }

 private:
  std::size_t threads_;
  bool one_by_one_;
};

// What a block of numbers adds up to; busy while it is being made or waits to be taken.
struct Sum {
  std::size_t first = 0, sum = 0;
  std::unique_ptr<std::atomic<bool>> busy = std::make_unique<std::atomic<bool>>(false);
};

void check_sums(Executor* executor, std::size_t count) {
  std::atomic<int> clashes = 0, firsts = 0;
  std::size_t expected_first = 0, total = 0;
  InOrder<Sum>(count, 256, [] { return Sum(); })
      .run(
          executor, [&] { ++firsts; },
          [&](std::size_t begin, std::size_t end, Sum& block) {
            if (block.busy->exchange(true)) ++clashes;
            // Blocks that take longer must not be passed.
            if (begin / 256 % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
            block.first = begin;
            block.sum = 0;
            for (std::size_t i = begin; i < end; ++i) block.sum += i;
          },
          [&](Sum& block) {
            CHECK(block.first == expected_first);
            expected_first += 256;
            total += block.sum;
            if (!block.busy->exchange(false)) ++clashes;
          });
  CHECK(clashes == 0);
  CHECK(firsts == 1);
  CHECK(total == (count == 0 ? 0 : count * (count - 1) / 2));
  CHECK(expected_first == (count + 255) / 256 * 256);
}

}  // namespace

TEST_CASE("blocks are made once, taken in order, and their places used by one at a time") {
  for (const std::size_t count : {0, 1, 255, 256, 257, 100000}) {
    INFO(count);
    check_sums(nullptr, count);
    for (const std::size_t threads : {1, 2, 3, 7}) {
      INFO(threads << " threads");
      TestThreads side_by_side(threads), one_by_one(threads, true);
      check_sums(&side_by_side, count);
      check_sums(&one_by_one, count);
    }
  }
}

TEST_CASE("what any part throws comes through, and nothing is taken after it") {
  const auto nothing = [] {};
  for (const std::size_t threads : {1, 2, 4}) {
    TestThreads executor(threads);
    const auto run = [&](const std::function<void()>& first, std::size_t bad_prepare, std::size_t bad_take) {
      std::size_t taken = 0;
      CHECK_THROWS_AS(InOrder<std::size_t>(1000, 10, [] { return std::size_t{0}; })
                          .run(
                              &executor, first,
                              [&](std::size_t begin, std::size_t, std::size_t& block) {
                                if (begin == bad_prepare) throw std::runtime_error("prepare");
                                block = begin;
                              },
                              [&](std::size_t& block) {
                                if (block == bad_take) throw std::runtime_error("take");
                                ++taken;
                              }),
                      std::runtime_error);
      return taken;
    };
    constexpr std::size_t never = 1;  // no block begins there
    CHECK(run(nothing, 500, never) <= 50);
    CHECK(run(nothing, never, 500) == 50);
    run([] { throw std::runtime_error("first"); }, never, never);
  }
}

TEST_CASE("ranges cover a loop once, with or without threads") {
  for (const std::size_t threads : {1, 2, 5}) {
    TestThreads executor(threads);
    for (Executor* lent : {static_cast<Executor*>(nullptr), static_cast<Executor*>(&executor)}) {
      std::vector<std::atomic<int>> times(500);
      run_ranges(lent, times.size(), 7, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++times[k];
      });
      CHECK(std::all_of(times.begin(), times.end(), [](const std::atomic<int>& one) { return one == 1; }));
    }
  }
}
