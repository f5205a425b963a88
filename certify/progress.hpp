// A progress line on standard error, only where that is a terminal, at most ten times a second.
#pragma once

#include "bezcert/check/observer.hpp"

#include <chrono>
#include <string>

namespace bezcert::certify {

class Progress : public CheckObserver {
 public:
  explicit Progress(std::string label);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const Mesh& mesh) override;
  std::unique_ptr<Block> new_block() override;

 private:
  class CountedBlock;

  void done(std::size_t count);

  std::string label_;
  std::size_t total_ = 0, done_ = 0;
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace bezcert::certify
