// The threads of a run: oneTBB's, started when something first asks for them.
#pragma once

#include "bezcert/parallel/executor.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <optional>

namespace bezcert::certify {

class Threads : public Executor {
 public:
  /// 0: as many as there are cores.
  explicit Threads(int jobs);

  std::size_t threads() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override;

 private:
  std::size_t threads_;
  std::optional<oneapi::tbb::global_control> limit_;
  std::optional<oneapi::tbb::task_arena> arena_;
};

}  // namespace bezcert::certify
