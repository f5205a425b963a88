// The one way input is refused: which file, which line, what is wrong and what would be right.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace bezcert {

class InputError : public std::runtime_error {
 public:
  /// `line` is 0 where there is none (a binary file, the file as a whole).
  InputError(const std::string& file, std::size_t line, const std::string& message)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message),
        file_(file),
        line_(line) {}

  const std::string& file() const { return file_; }
  std::size_t line() const { return line_; }

 private:
  std::string file_;
  std::size_t line_;
};

}  // namespace bezcert
