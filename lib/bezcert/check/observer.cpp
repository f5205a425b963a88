#include "bezcert/check/observer.hpp"

namespace bezcert {
namespace {

class BlockOfSeveral : public CheckObserver::Block {
 public:
  explicit BlockOfSeveral(std::vector<std::unique_ptr<Block>> blocks) : blocks_(std::move(blocks)) {}

  void element(std::size_t i, const CheckedElement& checked) override {
    for (const auto& block : blocks_) block->element(i, checked);
  }
  void finish() override {
    for (const auto& block : blocks_) block->finish();
  }

 private:
  std::vector<std::unique_ptr<Block>> blocks_;
};

class BlockOfCopies : public CheckObserver::Block {
 public:
  explicit BlockOfCopies(const EachElement::Visit& visit) : visit_(visit) {}

  void element(std::size_t i, const CheckedElement& checked) override { copies_.emplace_back(i, checked); }
  void finish() override {
    for (const auto& [i, checked] : copies_) visit_(i, checked);
    copies_.clear();
  }

 private:
  const EachElement::Visit& visit_;
  std::vector<std::pair<std::size_t, CheckedElement>> copies_;
};

}  // namespace

void Observers::begin(const Mesh& mesh) {
  for (CheckObserver* observer : observers_) observer->begin(mesh);
}

std::unique_ptr<CheckObserver::Block> Observers::new_block() {
  std::vector<std::unique_ptr<Block>> blocks;
  for (CheckObserver* observer : observers_) {
    if (auto block = observer->new_block()) blocks.push_back(std::move(block));
  }
  if (blocks.empty()) return nullptr;
  if (blocks.size() == 1) return std::move(blocks.front());
  return std::make_unique<BlockOfSeveral>(std::move(blocks));
}

void Observers::end(const Mesh& mesh, const MeshReport& report) {
  for (CheckObserver* observer : observers_) observer->end(mesh, report);
}

std::unique_ptr<CheckObserver::Block> EachElement::new_block() {
  return std::make_unique<BlockOfCopies>(visit_);
}

}  // namespace bezcert
