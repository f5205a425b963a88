// oneTBB's threads as an executor: every work is run once, also from a work, and errors come through.
#include "threads.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace bezcert;
using certify::Threads;

TEST_CASE("works are run once, also from a work") {
  for (const int jobs : {1, 2, 5}) {
    Threads threads(jobs);
    CHECK(threads.threads() == static_cast<std::size_t>(jobs));
    std::vector<std::atomic<int>> times(500);
    threads.run(5, [&](std::size_t i) {
      run_ranges(&threads, 100, 7, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) ++times[100 * i + k];
      });
    });
    CHECK(std::all_of(times.begin(), times.end(), [](const std::atomic<int>& one) { return one == 1; }));
  }
  CHECK(Threads(0).threads() >= 1);
}

TEST_CASE("what a work throws comes through") {
  for (const int jobs : {1, 2}) {
    Threads threads(jobs);
    CHECK_THROWS_AS(threads.run(10,
                                [](std::size_t i) {
                                  if (i == 7) throw std::runtime_error("stop");
                                }),
                    std::runtime_error);
  }
}
