#include "reproducers.hpp"

#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/file.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace bezcert::certify {

class Reproducers::BlockOfDefects : public Block {
 public:
  explicit BlockOfDefects(const Reproducers& owner) : owner_(owner) {}

  void element(std::size_t i, const CheckedElement& checked) override {
    const bool is_defect = std::any_of(checked.criteria.begin(), checked.criteria.end(),
                                       [](const CheckedCriterion& one) { return one.is_defect(); });
    if (is_defect) defects_.emplace_back(i, checked);
  }
  void finish() override {
    for (const auto& [i, checked] : defects_) owner_.write(i, checked);
    defects_.clear();
  }

 private:
  const Reproducers& owner_;
  std::vector<std::pair<std::size_t, CheckedElement>> defects_;
};

std::unique_ptr<CheckObserver::Block> Reproducers::new_block() {
  return std::make_unique<BlockOfDefects>(*this);
}

void Reproducers::write(std::size_t i, const CheckedElement& checked) const {
  std::string what;
  for (const CheckedCriterion& one : checked.criteria) {
    if (one.is_defect())
      what += std::string(one.criterion->name) + " says " + std::string(name(one.verdict.status)) + "; ";
  }
  const std::string number = std::to_string(mesh_->origin().number(i));
  const std::string stem = std::filesystem::path(input_).filename().string();
  const std::string path = "bezcert-contradiction-" + stem + "-" + number + ".bez.json";
  write_file(path, [&](std::ostream& stream) {
    write_bez_json(stream, mesh_->element(i), "element " + number,
                   input_ + ": " + what + "decision " + std::string(name(checked.decision.verdict)));
  });
  std::cerr << "certify: a sound criterion contradicts the exact decision; reproducer written to " << path
            << '\n';
}

}  // namespace bezcert::certify
