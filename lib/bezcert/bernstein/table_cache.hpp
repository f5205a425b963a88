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
  /// wait for each other where a table of small degree is there.
  template <class Build>
  const Table& get(Shape shape, Build build) {
    std::atomic<const Table*>* quick = small_slot(shape);
    if (quick) {
      if (const Table* table = quick->load(std::memory_order_acquire)) return *table;
    }
    const std::lock_guard lock(mutex_);
    auto& slot = tables_[shape];
    if (!slot) slot = std::make_unique<const Table>(build(shape));
    if (quick) quick->store(slot.get(), std::memory_order_release);
    return *slot;
  }

 private:
  static constexpr int small = 32;

  std::atomic<const Table*>* small_slot(Shape shape) {
    if (shape.p < 0 || shape.p >= small || shape.q < 0 || shape.q >= small) return nullptr;
    return &small_[(static_cast<std::size_t>(shape.domain) * small + static_cast<std::size_t>(shape.p)) *
                       small +
                   static_cast<std::size_t>(shape.q)];
  }

  std::mutex mutex_;
  std::map<Shape, std::unique_ptr<const Table>> tables_;
  std::array<std::atomic<const Table*>, std::size_t{3} * small * small> small_{};
};

}  // namespace bezcert
