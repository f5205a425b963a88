// The bytes of a .msh file as lines of text and blocks of binary numbers.
#pragma once

#include "bezcert/io/input_error.hpp"
#include "bezcert/io/line_starts.hpp"
#include "bezcert/io/mesh/read.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

class PlainLine;

/// Calls read_round(first, size) for [0, count) in rounds of at most `round`; where that returns false,
/// read_one(i) for each.
template <class Round, class One>
void read_rounds(std::size_t count, std::size_t round, Round read_round, One read_one) {
  for (std::size_t first = 0; first < count; first += round) {
    const std::size_t size = std::min(round, count - first);
    if (read_round(first, size)) continue;
    for (std::size_t i = first; i < first + size; ++i) read_one(i);
  }
}

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

  /// The lines from here on, to be read plainly; what was read is then to be taken.
  PlainLine plain() const;
  void take_line(const PlainLine& line);
  /// Reads `count` lines plainly, read(line, i) the i-th, from any thread. Returns false, and nothing has
  /// been read, if `read` returns false or a line does not end behind what it read.
  bool read_plainly(std::size_t count, Executor* executor,
                    const std::function<bool(PlainLine&, std::size_t)>& read);

  /// Where the next byte is; and the same, taking so many bytes. Precondition: the file has them.
  const char* next_bytes() const { return bytes_.data() + at_; }
  const char* take_bytes(std::size_t count) {
    at_ += count;
    return bytes_.data() + at_ - count;
  }
  /// The binary number at a place.
  template <class T>
  T number_at(const char* place) const {
    T value;
    std::memcpy(&value, place, sizeof(T));
    if (swap_bytes)
      std::reverse(reinterpret_cast<char*>(&value), reinterpret_cast<char*>(&value) + sizeof(T));
    return value;
  }
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
  std::optional<LineStarts> line_starts_;  // once threads need it
};

/// The numbers of lines that are written plainly: separated by blanks, integers as 1 to 18 digits. What it
/// refuses may be right all the same: GmshSource::read_tokens tells.
class PlainLine {
 public:
  PlainLine(const char* begin, const char* end) : at_(begin), end_(end) {}

  bool natural(std::uint64_t& value) {
    skip_blanks();
    value = 0;
    const char* const start = at_;
    for (; at_ != end_ && static_cast<unsigned char>(*at_ - '0') < 10; ++at_) {
      value = value * 10 + static_cast<std::uint64_t>(*at_ - '0');
      if (at_ - start >= 18) return false;
    }
    return at_ != start && at_separator();
  }
  /// The double nearest to a decimal, as parse_binary64 gives it.
  bool number(double& value);
  /// Whether the line ends here; then the next one begins.
  bool ends() {
    skip_blanks();
    if (at_ == end_) return true;
    return *at_++ == '\n';
  }
  const char* place() const { return at_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }
  bool at_separator() const { return at_ == end_ || is_blank(*at_) || *at_ == '\n'; }

  const char* at_;
  const char* end_;
};

}  // namespace bezcert
