// Text from a file inside a message: short, one line, no control characters.
#pragma once

#include <string>
#include <string_view>

namespace bezcert {

/// The length of the well-formed UTF-8 sequence of a printable character that `text` starts with, 0 if there
/// is none.
inline std::size_t printable_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 128) return byte(0) >= 32 && byte(0) != 127 ? 1 : 0;
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  if (byte(0) == 0xC2 && byte(1) < 0xA0) return 0;  // C1 control characters
  return length;
}

/// At most `longest` bytes of the text; a byte that belongs to no printable character becomes '?'.
inline std::string printable(std::string_view text, std::size_t longest = 40) {
  std::string result;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = printable_length(text.substr(at));
    if (result.size() + (length == 0 ? 1 : length) > longest) return result + "...";
    if (length == 0) {
      result += '?';
      ++at;
    } else {
      result += text.substr(at, length);
      at += length;
    }
  }
  return result;
}

}  // namespace bezcert
