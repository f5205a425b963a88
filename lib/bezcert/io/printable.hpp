// Text from a file inside a message: short, one line, no control characters.
#pragma once

#include <string>
#include <string_view>

namespace bezcert {

/// At most `longest` bytes of the text, every byte that is no printable ASCII as '?'.
inline std::string printable(std::string_view text, std::size_t longest = 40) {
  std::string result;
  for (const char c : text.substr(0, longest)) result += c >= 32 && c < 127 ? c : '?';
  return text.size() > longest ? result + "..." : result;
}

}  // namespace bezcert
