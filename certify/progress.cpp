#include "progress.hpp"

#include "bezcert/mesh/mesh.hpp"

#include <unistd.h>

#include <iostream>

namespace bezcert::certify {

class Progress::CountedBlock : public Block {
 public:
  explicit CountedBlock(Progress& progress) : progress_(progress) {}
  void element(std::size_t, const CheckedElement&) override { ++count_; }
  void finish() override { progress_.done(std::exchange(count_, 0)); }

 private:
  Progress& progress_;
  std::size_t count_ = 0;
};

Progress::Progress(std::string label)
    : label_(std::move(label)),
      enabled_(::isatty(STDERR_FILENO) == 1),
      last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  // Erases the line: plain carriage return and spaces, no escape codes.
  if (shown_) std::cerr << '\r' << std::string(label_.size() + 40, ' ') << '\r' << std::flush;
}

void Progress::begin(const Mesh& mesh) { total_ = mesh.elements().size(); }

std::unique_ptr<CheckObserver::Block> Progress::new_block() {
  return enabled_ ? std::make_unique<CountedBlock>(*this) : nullptr;
}

void Progress::done(std::size_t count) {
  done_ += count;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  std::cerr << '\r' << label_ << ": " << done_ << " of " << total_ << " elements" << std::flush;
}

}  // namespace bezcert::certify
