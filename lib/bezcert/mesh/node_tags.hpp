// What a file calls its nodes: numbers that follow each other, nearly always, which take no memory; or a
// list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bezcert {

class NodeTags {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Whether each is one more than the one before.
  bool consecutive() const { return list_.empty(); }
  /// Precondition: i < size().
  std::uint64_t operator[](std::size_t i) const { return list_.empty() ? first_ + i : list_[i]; }

  void push_back(std::uint64_t tag) {
    if (size_ == 0) first_ = tag;
    if (list_.empty() && tag != first_ + size_) {
      for (std::size_t i = 0; i < size_; ++i) list_.push_back(first_ + i);
    }
    if (!list_.empty()) list_.push_back(tag);
    ++size_;
  }

  /// Appends first, first + 1, ..., so many.
  void append_consecutive(std::uint64_t first, std::size_t count) {
    if (count == 0) return;
    push_back(first);
    if (list_.empty()) {
      size_ += count - 1;
    } else {
      for (std::size_t i = 1; i < count; ++i) push_back(first + i);
    }
  }

  bool operator==(const NodeTags&) const = default;

 private:
  std::uint64_t first_ = 0;
  std::size_t size_ = 0;
  std::vector<std::uint64_t> list_;  // empty while they are consecutive
};

}  // namespace bezcert
