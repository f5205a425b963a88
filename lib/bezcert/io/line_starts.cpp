#include "bezcert/io/line_starts.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace bezcert {
namespace {

// Sixteen characters at a time, in sums of bytes for as long as these hold them.
using Bytes [[gnu::vector_size(16)]] = signed char;

std::size_t count_ends(std::string_view text) {
  constexpr std::size_t width = sizeof(Bytes), longest = 127;
  std::size_t count = 0, at = 0;
  while (text.size() - at >= width) {
    Bytes sums{};
    const std::size_t vectors = std::min((text.size() - at) / width, longest);
    for (std::size_t i = 0; i < vectors; ++i, at += width) {
      Bytes bytes;
      std::memcpy(&bytes, text.data() + at, width);
      sums -= bytes == '\n';  // -1 where it is one
    }
    for (std::size_t k = 0; k < width; ++k) count += static_cast<std::size_t>(sums[k]);
  }
  text.remove_prefix(at);
  return count + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

LineStarts::LineStarts(std::string_view text, Executor* executor)
    : text_(text), before_((text.size() + piece - 1) / piece + 1, 0) {
  constexpr std::size_t at_once = 64;
  run_ranges(executor, before_.size() - 1, at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) before_[i + 1] = count_ends(text.substr(i * piece, piece));
  });
  std::partial_sum(before_.begin(), before_.end(), before_.begin());
}

std::size_t LineStarts::start(std::size_t line) const {
  if (line == 0) return 0;
  // The piece that holds the line-th end: the last one with fewer before it.
  const auto found = std::lower_bound(before_.begin(), before_.end(), line) - 1;
  std::size_t at = static_cast<std::size_t>(found - before_.begin()) * piece;
  for (std::size_t ends = *found; ends < line; ++ends) at = text_.find('\n', at) + 1;
  return at;
}

}  // namespace bezcert
