// A sound criterion contradicts the decision: a defect of bezcert. The element is kept, so that it can be
// found.
#pragma once

#include "bezcert/check/observer.hpp"
#include "bezcert/mesh/mesh.hpp"

#include <string>

namespace bezcert::certify {

/// Writes bezcert-contradiction-INPUT-ELEMENT.bez.json into the current folder for each such element.
class Reproducers : public CheckObserver {
 public:
  explicit Reproducers(std::string input) : input_(std::move(input)) {}

  void begin(const Mesh& mesh) override { mesh_ = &mesh; }
  std::unique_ptr<Block> new_block() override;

 private:
  class BlockOfDefects;

  void write(std::size_t i, const CheckedElement& checked) const;

  std::string input_;
  const Mesh* mesh_ = nullptr;
};

}  // namespace bezcert::certify
