#include "progress.hpp"

#include <unistd.h>

#include <iostream>

namespace bezcert::certify {

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      enabled_(::isatty(STDERR_FILENO) == 1),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  // Erases the line: plain carriage return and spaces, no escape codes.
  if (shown_) std::cerr << '\r' << std::string(label_.size() + 40, ' ') << '\r' << std::flush;
}

void Progress::done(std::size_t count) {
  if (!enabled_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  std::cerr << '\r' << label_ << ": " << count << " of " << total_ << " elements" << std::flush;
}

}  // namespace bezcert::certify
