// A progress line on standard error, only where that is a terminal, at most ten times a second.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace bezcert::certify {

class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void done(std::size_t count);

 private:
  std::string label_;
  std::size_t total_;
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace bezcert::certify
