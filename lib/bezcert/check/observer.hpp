// Whoever wants to follow a check: reports, certificates, pictures, progress.
//
// What an observer says of an element is a function of that element, so it is prepared on any thread, block
// by block; blocks are finished in mesh order, one at a time.
#pragma once

#include "bezcert/check/cross_check.hpp"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace bezcert {

struct MeshReport;

class CheckObserver {
 public:
  /// Follows consecutive elements of the mesh.
  class Block {
   public:
    virtual ~Block() = default;
    /// Every element of the block in mesh order. On any thread: only this block's own memory may be changed.
    virtual void element(std::size_t i, const CheckedElement& checked) = 0;
    /// After the last one, when all blocks before have been finished; one block at a time. Then the object is
    /// used for another block.
    virtual void finish() = 0;
  };

  virtual ~CheckObserver() = default;

  virtual void begin(const Mesh&) {}
  /// A block for this observer, which outlives it; null if it does not look at elements.
  virtual std::unique_ptr<Block> new_block() { return nullptr; }
  virtual void end(const Mesh&, const MeshReport&) {}
};

/// Several observers as one, called in the order in which they were added.
class Observers : public CheckObserver {
 public:
  /// Keeps a reference.
  void add(CheckObserver& observer) { observers_.push_back(&observer); }

  void begin(const Mesh& mesh) override;
  std::unique_ptr<Block> new_block() override;
  void end(const Mesh& mesh, const MeshReport& report) override;

 private:
  std::vector<CheckObserver*> observers_;
};

/// Calls a function for every element in mesh order, one at a time. For few elements or little work: what was
/// found of them is copied.
class EachElement : public CheckObserver {
 public:
  using Visit = std::function<void(std::size_t i, const CheckedElement& checked)>;
  explicit EachElement(Visit visit) : visit_(std::move(visit)) {}

  std::unique_ptr<Block> new_block() override;

 private:
  Visit visit_;
};

}  // namespace bezcert
