// Tables that depend on a shape alone, built on first use and never changed: not state, only saved work.
#pragma once

#include "bezcert/bernstein/shape.hpp"

#include <map>
#include <memory>
#include <mutex>

namespace bezcert {

template <class Table>
class TableCache {
 public:
  /// The table of a shape; `build(shape)` makes it the first time. Safe from several threads.
  template <class Build>
  const Table& get(Shape shape, Build build) {
    const std::lock_guard lock(mutex_);
    auto& slot = tables_[shape];
    if (!slot) slot = std::make_unique<const Table>(build(shape));
    return *slot;
  }

 private:
  std::mutex mutex_;
  std::map<Shape, std::unique_ptr<const Table>> tables_;
};

}  // namespace bezcert
