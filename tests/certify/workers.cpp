// Threads change nothing: every part is done once, results are taken in order, errors come through.
#include "workers.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace bezcert::certify {
namespace {

// What a block of numbers adds up to; busy while it is being made or waits to be taken.
struct Sum {
  std::size_t first = 0, sum = 0;
  std::atomic<bool> busy = false;
};

}  // namespace

TEST_CASE("blocks are made once, taken in order, and their places used by one at a time") {
  for (const int jobs : {1, 2, 3, 7}) {
    for (const std::size_t count : {0, 1, 255, 256, 257, 100000}) {
      INFO(jobs << " jobs, " << count);
      Workers workers(jobs);
      std::atomic<int> clashes = 0;
      std::size_t expected_first = 0, total = 0;
      workers.in_order<Sum>(
          count, 256,
          [&](std::size_t begin, std::size_t end, Sum& result) {
            if (result.busy.exchange(true)) ++clashes;
            // Blocks that take longer must not be passed.
            if (begin / 256 % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
            result.first = begin;
            result.sum = 0;
            for (std::size_t i = begin; i < end; ++i) result.sum += i;
          },
          [&](Sum& result) {
            CHECK(result.first == expected_first);
            expected_first += 256;
            total += result.sum;
            if (!result.busy.exchange(false)) ++clashes;
          });
      CHECK(clashes == 0);
      CHECK(total == (count == 0 ? 0 : count * (count - 1) / 2));
      CHECK(expected_first == (count + 255) / 256 * 256);
    }
  }
}

TEST_CASE("a loop is run whole, also from a loop, with or without threads") {
  for (const int jobs : {1, 2, 5}) {
    Workers workers(jobs);
    const Parallel parallel = workers.parallel();
    CHECK(static_cast<bool>(parallel) == (jobs > 1));
    std::vector<std::atomic<int>> times(500);
    run(parallel, 5, [&](std::size_t i) {
      run_ranges(parallel, 100, 7, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++times[100 * i + k];
      });
    });
    CHECK(std::all_of(times.begin(), times.end(), [](const std::atomic<int>& one) { return one == 1; }));
  }
}

TEST_CASE("both are run, and what either throws comes through") {
  for (const int jobs : {1, 2}) {
    Workers workers(jobs);
    std::atomic<int> done = 0;
    workers.both([&] { ++done; }, [&] { ++done; });
    workers.at_once([&] { ++done; }, [&] { ++done; });
    CHECK(done == 4);
    const auto fails = [] { throw std::runtime_error("stop"); };
    const auto works = [] {};
    CHECK_THROWS_AS(workers.both(fails, works), std::runtime_error);
    CHECK_THROWS_AS(workers.both(works, fails), std::runtime_error);
    CHECK_THROWS_AS(workers.at_once(fails, works), std::runtime_error);
    CHECK_THROWS_AS(workers.at_once(works, fails), std::runtime_error);
    CHECK_THROWS_AS(workers.in_order<int>(
                        1000, 10,
                        [](std::size_t begin, std::size_t, int&) {
                          if (begin == 500) throw std::runtime_error("stop");
                        },
                        [](int&) {}),
                    std::runtime_error);
  }
}

}  // namespace bezcert::certify
