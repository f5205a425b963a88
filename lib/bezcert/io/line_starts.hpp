// Where the lines of a text begin, so that threads can read it in parts: ends of lines are counted piece by
// piece, side by side, and a line is then looked for in its piece alone.
#pragma once

#include "bezcert/parallel/executor.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace bezcert {

class LineStarts {
 public:
  /// Keeps a view: `text` must outlive this.
  LineStarts(std::string_view text, Executor* executor);

  /// Ends of lines in the text.
  std::size_t ends() const { return before_.back(); }
  /// Where line `line` begins, counted from 0: behind so many ends of lines. Precondition: line <= ends().
  std::size_t start(std::size_t line) const;

 private:
  static constexpr std::size_t piece = std::size_t{1} << 12;

  std::string_view text_;
  std::vector<std::size_t> before_;  // ends of lines before each piece, and in the whole
};

}  // namespace bezcert
