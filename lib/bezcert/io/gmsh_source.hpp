// The bytes of a .msh file as lines of text and blocks of binary numbers.
#pragma once

#include "bezcert/io/input_error.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

class GmshSource {
 public:
  GmshSource(std::string file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {}

  /// What a file says of its own form, from $MeshFormat.
  bool binary = false;
  bool swap_bytes = false;

  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

  bool at_end() const { return at_ >= bytes_.size(); }
  /// Bytes that are left: no count in the file can be larger.
  std::size_t remaining() const { return bytes_.size() - at_; }
  /// Line of the last line read, 0 in a binary file.
  std::size_t line() const { return binary ? 0 : line_; }

  /// The next line that is not blank, without its end; empty at the end of the file.
  std::string_view next_line();
  /// The same, split at spaces into `tokens()`. Fails at the end of the file, saying what was expected.
  void read_tokens(std::string_view expected);
  const std::vector<std::string_view>& tokens() const { return tokens_; }
  /// Fails unless the last line read has `count` tokens.
  void expect_tokens(std::size_t count, std::string_view what) const;
  /// A token as an integer.
  std::int64_t integer(std::size_t token, std::string_view what) const;
  /// A token as an integer that is not negative.
  std::uint64_t natural(std::size_t token, std::string_view what) const;

  /// A binary number.
  std::int32_t read_int32(std::string_view what) { return read<std::int32_t>(what); }
  std::uint64_t read_uint64(std::string_view what) { return read<std::uint64_t>(what); }
  double read_double(std::string_view what) { return read<double>(what); }

  /// Reads the line "$End<section>" that must come next.
  void expect_end(std::string_view section);
  /// Moves behind the line "$End<section>".
  void skip_section(std::string_view section);

 private:
  template <class T>
  T read(std::string_view what);

  std::string file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> tokens_;
};

}  // namespace bezcert
