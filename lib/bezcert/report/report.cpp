#include "bezcert/report/report.hpp"

#include <ostream>

namespace bezcert {
namespace {

class BlockOfText : public CheckObserver::Block {
 public:
  using Append = std::function<void(std::size_t, const CheckedElement&, std::string&)>;
  BlockOfText(std::ostream& stream, Append append) : stream_(stream), append_(std::move(append)) {}

  void element(std::size_t i, const CheckedElement& checked) override { append_(i, checked, text_); }
  void finish() override {
    stream_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

 private:
  std::ostream& stream_;
  Append append_;
  std::string text_;
};

}  // namespace

void Report::begin(const Mesh& mesh) {
  mesh_ = &mesh;
  write_header(mesh);
}

std::unique_ptr<CheckObserver::Block> Report::new_block() {
  return std::make_unique<BlockOfText>(
      stream_, [this](std::size_t i, const CheckedElement& checked, std::string& text) {
        append_element(*mesh_, i, checked, text);
      });
}

void Report::end(const Mesh& mesh, const MeshReport& report) { write_summary(mesh, report); }

double Report::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - source_.started).count();
}

}  // namespace bezcert
