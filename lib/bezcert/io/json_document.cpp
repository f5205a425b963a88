#include "bezcert/io/json_document.hpp"

#include "bezcert/io/input_error.hpp"
#include "bezcert/io/printable.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace bezcert {
namespace {

constexpr std::size_t max_depth = 32;

// Where the parser is. It takes characters one by one, and one too many behind a number: the line of what it
// has just understood is the line before a line end that was taken last.
struct Position {
  std::size_t lines = 1;
  bool at_line_end = false;

  std::size_t line() const { return at_line_end ? lines - 1 : lines; }
};

// Characters that count the lines passed.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    position_->at_line_end = *at_ == '\n';
    if (position_->at_line_end) ++position_->lines;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Position* position_;
};

class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(const std::string& file, const Position& position) : file_(file), position_(position) {}

  JsonValue root;

  bool null() override { return scalar(JsonValue::Kind::null, ""); }
  bool boolean(bool value) override { return scalar(JsonValue::Kind::boolean, value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override {
    return scalar(JsonValue::Kind::number, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(JsonValue::Kind::number, std::to_string(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    return scalar(JsonValue::Kind::number, text);
  }
  bool string(string_t& text) override { return scalar(JsonValue::Kind::string, text); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& text) override {
    JsonValue& object = *open_.back();
    if (object.find(text) != nullptr) {
      throw InputError(file_, position_.line(), "the key \"" + printable(text) + "\" is repeated");
    }
    object.members.push_back({text, JsonValue{}});
    return true;
  }
  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      throw InputError(file_, position_.line(),
                       "the number " + printable(token) +
                           " is beyond the range of doubles: expected a string, which is exact");
    }
    std::string why = error.what();
    // "[json.exception...] parse error at line 3, column 5: syntax error ...": the part that says why.
    const std::size_t colon = why.find(": ");
    if (colon != std::string::npos) why = why.substr(colon + 2);
    throw InputError(file_, position_.line(), "no JSON: " + printable(why, 200));
  }

 private:
  // The place of the value that comes next: under the last key, at the end of the array, or the root.
  JsonValue& place() {
    if (open_.empty()) return root;
    JsonValue& parent = *open_.back();
    if (parent.kind == JsonValue::Kind::object) return parent.members.back().value;
    return parent.items.emplace_back();
  }
  bool scalar(JsonValue::Kind kind, std::string text) {
    JsonValue& value = place();
    value.kind = kind;
    value.line = position_.line();
    value.text = std::move(text);
    return true;
  }
  bool open(JsonValue::Kind kind) {
    if (open_.size() == max_depth) {
      throw InputError(file_, position_.line(), "values are nested deeper than " + std::to_string(max_depth));
    }
    JsonValue& value = place();
    value.kind = kind;
    value.line = position_.line();
    open_.push_back(&value);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& file_;
  const Position& position_;
  // Pointers stay valid: a value only grows while it is the innermost open one.
  std::vector<JsonValue*> open_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const JsonMember& member) { return member.key == key; });
  return found == members.end() ? nullptr : &found->value;
}

std::string_view name(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::null: return "null";
    case JsonValue::Kind::boolean: return "a boolean";
    case JsonValue::Kind::number: return "a number";
    case JsonValue::Kind::string: return "a string";
    case JsonValue::Kind::array: return "an array";
    case JsonValue::Kind::object: return "an object";
  }
  return "";
}

JsonValue parse_json(const std::string& file, std::string_view bytes) {
  Position position;
  Builder builder(file, position);
  CountingIterator begin(bytes.data(), &position);
  const CountingIterator end(bytes.data() + bytes.size(), &position);
  if (!nlohmann::json::sax_parse(begin, end, &builder)) throw InputError(file, position.line(), "no JSON");
  return std::move(builder.root);
}

}  // namespace bezcert
