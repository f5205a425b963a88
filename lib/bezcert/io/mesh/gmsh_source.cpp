#include "bezcert/io/mesh/gmsh_source.hpp"

#include "bezcert/io/printable.hpp"
#include "bezcert/number/interval.hpp"

#include <atomic>
#include <charconv>
#include <cmath>
#include <system_error>

namespace bezcert {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string quoted(std::string_view text) { return "'" + printable(text, 30) + "'"; }

}  // namespace

void GmshSource::fail(const std::string& message) const { fail_at(line(), message); }

void GmshSource::fail_at(std::size_t line, const std::string& message) const {
  throw InputError(file_, line, binary ? message + " (at byte " + std::to_string(at_) + ")" : message);
}

std::string_view GmshSource::next_line() {
  while (at_ < bytes_.size()) {
    std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) end = bytes_.size();
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    ++line_;
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    if (!text.empty()) return text;
  }
  return {};
}

void GmshSource::read_tokens(std::string_view expected) {
  const std::string_view text = next_line();
  tokens_.clear();
  if (text.empty()) fail("the file ends early: expected " + std::string(expected));
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = at;
    while (end < text.size() && !is_space(text[end])) ++end;
    tokens_.push_back(text.substr(at, end - at));
    at = end;
    while (at < text.size() && is_space(text[at])) ++at;
  }
  if (tokens_[0].front() == '$') fail("expected " + std::string(expected) + ", found " + quoted(text));
}

void GmshSource::expect_tokens(std::size_t count, std::string_view what) const {
  if (tokens_.size() != count) {
    fail("expected " + std::to_string(count) + " numbers for " + std::string(what) + ", found " +
         std::to_string(tokens_.size()));
  }
}

std::int64_t GmshSource::integer(std::size_t token, std::string_view what) const {
  if (token >= tokens_.size()) fail("the " + std::string(what) + " is missing");
  const std::string_view text = tokens_[token];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail("the " + std::string(what) + " is " + quoted(text) + ", expected an integer below 2^63");
  }
  return value;
}

std::uint64_t GmshSource::natural(std::size_t token, std::string_view what) const {
  const std::int64_t value = integer(token, what);
  if (value < 0) fail("the " + std::string(what) + " is " + std::to_string(value) + ", expected at least 0");
  return static_cast<std::uint64_t>(value);
}

template <class T>
T GmshSource::read(std::string_view what) {
  if (remaining() < sizeof(T)) fail("the file ends early: expected the " + std::string(what));
  return number_at<T>(take_bytes(sizeof(T)));
}

template std::int32_t GmshSource::read(std::string_view);
template std::uint64_t GmshSource::read(std::string_view);
template double GmshSource::read(std::string_view);

bool PlainLine::number(double& value) {
  skip_blanks();
  if (at_ != end_ && *at_ == '0') {  // the third coordinate, nearly always
    ++at_;
    value = 0;
    if (at_separator()) return true;
    --at_;
  }
  if (!rounds_to_nearest()) return false;
  const auto [end, error] = std::from_chars(at_, end_, value);
  at_ = end;
  return error == std::errc() && std::isfinite(value) && at_separator();
}

PlainLine GmshSource::plain() const { return {bytes_.data() + at_, bytes_.data() + bytes_.size()}; }

void GmshSource::take_line(const PlainLine& line) {
  at_ = static_cast<std::size_t>(line.place() - bytes_.data());
  ++line_;
}

bool GmshSource::read_plainly(std::size_t count, Executor* executor,
                              const std::function<bool(PlainLine&, std::size_t)>& read) {
  constexpr std::size_t part = 2048;
  const char* const end = bytes_.data() + bytes_.size();
  // Returns where the last of the lines ends, or null.
  const auto read_lines = [&](std::size_t at, std::size_t first, std::size_t last) -> const char* {
    PlainLine line(bytes_.data() + at, end);
    for (std::size_t i = first; i < last; ++i) {
      if (!read(line, i) || !line.ends()) return nullptr;
    }
    return line.place();
  };
  if (!has_threads(executor) || count <= part) {
    const char* const behind = read_lines(at_, 0, count);
    if (behind == nullptr) return false;
    at_ = static_cast<std::size_t>(behind - bytes_.data());
  } else {
    if (!line_starts_) line_starts_.emplace(bytes_, executor);
    if (line_ + count > line_starts_->ends()) return false;
    std::atomic<bool> all = true;
    run_ranges(executor, count, part, [&](std::size_t first, std::size_t last) {
      if (read_lines(line_starts_->start(line_ + first), first, last) == nullptr) all = false;
    });
    if (!all) return false;
    at_ = line_starts_->start(line_ + count);
  }
  line_ += count;
  return true;
}

void GmshSource::expect_end(std::string_view section) {
  const std::string end = "$End" + std::string(section);
  const std::string_view text = next_line();
  if (text.empty()) fail("the file ends early: expected " + end);
  if (text != end)
    fail("expected " + end + " after what $" + std::string(section) + " announced, found " + quoted(text));
}

void GmshSource::skip_section(std::string_view section) {
  const std::string end = "$End" + std::string(section);
  if (!binary) {
    for (std::string_view text = next_line(); !text.empty(); text = next_line()) {
      if (text == end) return;
    }
  } else {
    // The end stands at the start of a line; the section's own bytes may hold anything.
    std::size_t found = bytes_.find(end, at_);
    while (found != std::string_view::npos) {
      const std::size_t behind = found + end.size();
      const bool line_starts = bytes_[found - 1] == '\n';
      const bool line_ends = behind >= bytes_.size() || bytes_[behind] == '\n' || bytes_[behind] == '\r';
      if (line_starts && line_ends) {
        at_ = std::min(behind + 1, bytes_.size());
        return;
      }
      found = bytes_.find(end, behind);
    }
  }
  fail("section $" + printable(section) + " has no $End" + printable(section));
}

}  // namespace bezcert
