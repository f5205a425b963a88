// Tables that depend on a shape alone, built on first use and never changed: not state, only saved work.
#pragma once

#include "bezcert/bernstein/shape.hpp"

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>

namespace bezcert {

template <class Table>
class TableCache {
 public:
  /// The table of a shape; `build(shape)` makes it the first time. Safe from several threads, which do not
  /// wait for each other where the table is the first of its slot, as those of small planar shapes are.
  template <class Build>
  const Table& get(Shape shape, Build build) {
    std::atomic<const Entry*>& slot = slots_[slot_of(shape)];
    const Entry* quick = slot.load(std::memory_order_acquire);
    if (quick && quick->first == shape) return *quick->second;
    const std::lock_guard lock(mutex_);
    Entry& entry = *tables_.try_emplace(shape).first;  // stays where it is
    if (!entry.second) entry.second = std::make_unique<const Table>(build(shape));
    if (!quick) slot.store(&entry, std::memory_order_release);
    return *entry.second;
  }

 private:
  using Tables = std::map<Shape, std::unique_ptr<const Table>>;
  using Entry = typename Tables::value_type;

  static constexpr std::size_t slot_count = 4 * 32 * 32;

  // No two of segments, triangles and squares of degrees below 32 share a slot.
  static std::size_t slot_of(Shape shape) {
    const Domain domain = shape.domain;
    const int kind = domain.simplex(0) ^ domain.simplex(1) << 1 ^ domain.simplex(2);
    return static_cast<std::size_t>((kind * 32 + shape.degree(0)) * 32 + shape.degree(1) + shape.degree(2)) %
           slot_count;
  }

  std::mutex mutex_;
  Tables tables_;
  std::array<std::atomic<const Entry*>, slot_count> slots_{};
};

}  // namespace bezcert
