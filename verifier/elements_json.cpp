// Reader of .bez.json: known keys, none twice, indices and counts checked.
#include "elements.hpp"

#include <algorithm>
#include <map>

namespace verifier {

namespace {

/// JSON, read where `at` is. Objects are read in two steps: the places of their values, then these by name.
struct Json {
  using Keys = std::map<std::string_view, std::size_t>;

  std::string_view text;
  std::size_t at = 0;

  [[noreturn]] void fail(const std::string& why) const {
    const std::string_view before = text.substr(0, at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    throw Malformed{"elements file, line " + std::to_string(line) + ": " + why};
  }
  /// The next character that is not blank; 0 at the end.
  char peek() {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    return at < text.size() ? text[at] : '\0';
  }
  bool accept(char c) { return peek() == c ? (++at, true) : false; }
  void expect(char c) {
    if (!accept(c)) fail(std::string("expected ") + c);
  }
  /// Escapes stay as they are: no word of the format needs them.
  std::string_view string() {
    expect('"');
    const std::size_t begin = at;
    while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
    if (at >= text.size()) fail("string without end");
    return text.substr(begin, at++ - begin);
  }
  /// Checked when it is read: exact_number.
  std::string_view number() {
    if (peek() == '"') return string();
    const std::size_t begin = at;
    at = std::min(text.find_first_not_of("+-.0123456789eE", at), text.size());
    if (at == begin) fail("expected a number");
    return text.substr(begin, at - begin);
  }
  long integer(long low, long high) {
    if (peek() == '"') fail("expected an integer");
    return Tokens(number()).small(low, high);
  }
  template <class Each>
  void list(char open, char close, const Each& each) {
    expect(open);
    if (accept(close)) return;
    do each();
    while (accept(','));
    expect(close);
  }
  std::string_view key() {
    const std::string_view name = string();
    expect(':');
    return name;
  }
  void skip(int depth) {
    if (depth > 16) fail("nested too deeply");
    if (peek() == '[')
      list('[', ']', [&] { skip(depth + 1); });
    else if (peek() == '{')
      list('{', '}', [&] { key(), skip(depth + 1); });
    else
      number();
  }
  Keys object(std::initializer_list<std::string_view> known) {
    Keys keys;
    list('{', '}', [&] {
      const std::string_view name = key();
      const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
      if (!is_known || !keys.emplace(name, at).second) fail("unknown or repeated key");
      skip(0);
    });
    return keys;
  }
  /// Goes to a value.
  void go(const Keys& keys, std::string_view name) {
    const auto found = keys.find(name);
    if (found == keys.end()) fail("key missing: " + std::string(name));
    at = found->second;
  }
};

}  // namespace

void Elements::read_json() {
  Json json{bytes_};
  const auto add_points = [&](const Json::Keys& keys) {
    const std::size_t before = x_.texts.size();
    json.go(keys, "points");
    json.list('[', ']', [&] {
      json.expect('['), x_.texts.push_back(json.number());
      json.expect(','), y_.texts.push_back(json.number());
      json.expect(']');
    });
    if (!keys.contains("weights")) return;
    w_.texts.resize(before, "1");
    json.go(keys, "weights");
    json.list('[', ']', [&] { w_.texts.push_back(json.number()); });
    if (w_.texts.size() != x_.texts.size()) json.fail("not one weight a point");
  };
  const Json::Keys file = json.object({"bezcert", "points", "weights", "elements", "curves"});
  if (json.peek(), json.at < bytes_.size()) json.fail("text after the object");
  json.go(file, "bezcert");
  json.integer(1, 1);
  if (file.contains("points") || file.contains("weights")) add_points(file);
  const long file_points = static_cast<long>(x_.texts.size());
  json.go(file, "elements");
  json.list('[', ']', [&] {
    const Json::Keys keys =
        json.object({"kind", "degree", "basis", "points", "nodes", "weights", "name", "expect", "source"});
    const std::size_t end = json.at;
    const auto word = [&](std::string_view key, std::string_view first, std::string_view second) {
      json.go(keys, key);
      const std::string_view found = json.string();
      if (found != first && found != second) json.fail("unknown " + std::string(key));
      return found == first;
    };
    const auto degree = [&] { return static_cast<std::uint16_t>(json.integer(1, 64)); };
    Shape shape{word("kind", "triangle", "quadrilateral"), false, 0, 0, nodes_.size()};
    shape.lagrange = keys.contains("basis") && word("basis", "lagrange", "bernstein");
    json.go(keys, "degree");
    const bool pair = !shape.triangle && json.accept('[');
    shape.p = shape.q = degree();
    if (pair) json.expect(','), shape.q = degree(), json.expect(']');
    if (keys.contains("nodes")) {
      if (keys.contains("points") || keys.contains("weights")) json.fail("nodes with points or weights");
      json.go(keys, "nodes");
      json.list('[', ']',
                [&] { nodes_.push_back(static_cast<std::uint32_t>(json.integer(0, file_points - 1))); });
    } else {
      glued_by_nodes_ = false;
      auto place = static_cast<std::uint32_t>(x_.texts.size());
      add_points(keys);
      while (place < x_.texts.size()) nodes_.push_back(place++);
    }
    if (nodes_.size() - shape.first != point_count(shape.triangle, shape.p, shape.q))
      json.fail("number of points does not fit the degree");
    shapes_.push_back(shape);
    json.at = end;
  });
  if (!w_.texts.empty()) w_.texts.resize(x_.texts.size(), "1");
}

}  // namespace verifier
