// Elements of both formats, and the reader of .bez.json: known keys, none twice, indices and counts checked.
#include "elements.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>

namespace verifier {

namespace {

/// JSON, read where `at` is. Objects are read in two steps, first the places of their values, then these by
/// name.
struct Json {
  using Keys = std::map<std::string_view, std::size_t>;

  std::string_view text;
  std::size_t at = 0;

  [[noreturn]] void fail(const std::string& why) const {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw MalformedElements{{std::to_string(line) + ": " + why}};
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
    if (at >= text.size()) at = begin, fail("string without end");
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
  std::uint32_t index(std::uint32_t low, std::uint32_t high) {
    if (peek() == '"') fail("expected an integer, not a string");
    const std::string_view digits = number();
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < low || value > high)
      fail("expected an integer from " + std::to_string(low) + " to " + std::to_string(high));
    return value;
  }
  template <class Each>
  void array(const Each& each) {
    expect('[');
    if (accept(']')) return;
    do each();
    while (accept(','));
    expect(']');
  }
  void skip(int depth) {
    if (depth > 16) fail("nested too deeply");
    const auto entry = [&] { string(), expect(':'), skip(depth + 1); };
    if (peek() == '[') {
      array([&] { skip(depth + 1); });
    } else if (accept('{')) {
      if (accept('}')) return;
      do entry();
      while (accept(','));
      expect('}');
    } else {
      number();
    }
  }
  Keys object(std::initializer_list<std::string_view> known) {
    Keys keys;
    expect('{');
    do {
      const std::string_view key = string();
      expect(':');
      const bool is_known = std::find(known.begin(), known.end(), key) != known.end();
      if (!is_known || !keys.emplace(key, at).second) fail("unknown or repeated key: " + std::string(key));
      skip(0);
    } while (accept(','));
    expect('}');
    return keys;
  }
  /// Goes to a value.
  void go(const Keys& keys, std::string_view key) {
    const auto found = keys.find(key);
    if (found == keys.end()) fail("key missing: " + std::string(key));
    at = found->second;
  }
};

/// Appends integers that are the values times what is returned, a power of two.
mpz_class scale(const std::vector<double>& values, std::vector<mpz_class>& integers) {
  const auto split = [](double value, int& exponent) {  // odd integer times a power of two
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    exponent += zeros - 53;
    return mantissa >> zeros;
  };
  int least = 0, e = 0;
  for (const double value : values)
    if (value != 0) split(value, e), least = std::min(least, e);
  for (const double value : values) {
    integers.emplace_back(value == 0 ? 0 : split(value, e));
    if (value != 0) integers.back() <<= static_cast<unsigned>(e - least);
  }
  return mpz_class(1) << static_cast<unsigned>(-least);
}

/// The same for fractions, with their least common denominator.
mpz_class scale(const std::vector<mpq_class>& values, std::vector<mpz_class>& integers) {
  mpz_class unit = 1;
  const auto work = [&] { spend(1024 * (1 + mpz_size(unit.get_mpz_t()))); };
  for (const mpq_class& value : values) work(), unit = lcm(unit, value.get_den());
  for (const mpq_class& value : values) work(), integers.push_back(unit / value.get_den() * value.get_num());
  return unit;
}

}  // namespace

std::size_t point_count(bool triangle, std::size_t p, std::size_t q) {
  return triangle ? (p + 1) * (p + 2) / 2 : (p + 1) * (q + 1);
}

std::size_t point_place(bool triangle, std::size_t p, std::size_t u, std::size_t v) {
  return triangle ? v * (2 * p + 3 - v) / 2 + u : v * (p + 1) + u;
}

std::array<std::size_t, 2> along_edge(bool triangle, std::size_t p, std::size_t q, std::size_t e,
                                      std::size_t k) {
  const std::size_t u[] = {0, p, triangle ? 0 : p, 0, 0}, v[] = {0, 0, q, triangle ? 0 : q, 0};  // corners
  const std::size_t n = std::max<std::size_t>(1, triangle || e % 2 == 0 ? p : q);
  return {(u[e] * (n - k) + u[e + 1] * k) / n, (v[e] * (n - k) + v[e + 1] * k) / n};
}

std::vector<std::size_t> edge_positions(const Element& element, int e) {
  const auto p = static_cast<std::size_t>(element.p), q = static_cast<std::size_t>(element.q);
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k <= (element.triangle || e % 2 == 0 ? p : q); ++k) {
    const auto [u, v] = along_edge(element.triangle, p, q, static_cast<std::size_t>(e), k);
    places.push_back(point_place(element.triangle, p, u, v));
  }
  return places;
}

Elements::Elements(std::string bytes, std::string_view basis, std::string_view numbers)
    : bytes_(std::move(bytes)), binary64_(numbers == "binary64") {
  const char first = Json{bytes_}.peek();
  json_ = first == '{';
  if (!json_ && first != '$') throw MalformedElements{{"1: neither .msh nor .bez.json"}};
  const bool lagrange = basis == "lagrange", decimal = numbers == "decimal";
  if (!(json_ ? basis == "mixed" && decimal : (lagrange || basis == "bernstein") && (binary64_ || decimal)))
    throw Malformed{"basis and numbers do not fit the elements file"};
  if (bytes_.size() > 0xffffffff) throw MalformedElements{{"1: limit: more than 4 GiB"}};
  json_ ? read_json() : read_msh(lagrange);
  if (shapes_.empty()) throw MalformedElements{{"1: no triangles, no quadrilaterals"}};
}

std::vector<std::uint32_t> Elements::nodes(std::size_t i) const {
  const Shape& shape = shapes_[i];
  const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(shape.first);
  return {begin, begin + static_cast<std::ptrdiff_t>(point_count(shape.triangle, shape.p, shape.q))};
}

Element Elements::element(std::size_t i) const try {
  const Shape& shape = shapes_[i];
  const std::vector<std::uint32_t> places = nodes(i);
  Element e{shape.triangle, shape.p, shape.q, shape.lagrange, false, {}, {}, {}, {}};
  const auto exact = [&](std::string_view text) { return exact_number(text, json_); };
  const auto read = [&](auto number, std::initializer_list<const std::vector<std::string_view>*> lists) {
    std::vector<decltype(number(std::string_view()))> values;
    values.reserve(lists.size() * places.size());
    for (const auto* texts : lists)
      for (const std::uint32_t place : places) values.push_back(number((*texts)[place]));
    return values;
  };
  e.x.reserve(2 * places.size());
  e.unit = binary64_ ? scale(read(nearest_double, {&x_, &y_}), e.x) : scale(read(exact, {&x_, &y_}), e.x);
  const auto middle = e.x.begin() + static_cast<std::ptrdiff_t>(places.size());
  e.y.assign(std::make_move_iterator(middle), std::make_move_iterator(e.x.end()));
  e.x.erase(middle, e.x.end());
  if (!w_.empty()) scale(read(exact, {&w_}), e.w);
  for (const mpz_class& w : e.w) {
    if (w <= 0) throw Malformed{"weight not positive"};
    e.rational = e.rational || w != e.w[0];
  }
  if (!e.rational) e.w.assign(places.size(), 1);
  return e;
} catch (const Malformed& error) {
  throw MalformedElements{{" element " + std::to_string(i + 1) + ": " + error.why}};
}

void Elements::read_json() {
  Json json{bytes_};
  const auto add_points = [&](const Json::Keys& keys) {
    const std::size_t before = x_.size();
    json.go(keys, "points");
    json.array([&] {
      json.expect('['), x_.push_back(json.number());
      json.expect(','), y_.push_back(json.number());
      json.expect(']');
    });
    if (!keys.contains("weights")) return;
    w_.resize(before, "1");
    json.go(keys, "weights");
    json.array([&] { w_.push_back(json.number()); });
    if (w_.size() != x_.size()) json.fail("not one weight a point");
  };
  const Json::Keys file = json.object({"bezcert", "points", "weights", "elements", "curves"});
  if (json.peek(), json.at < bytes_.size()) json.fail("text after the object");
  json.go(file, "bezcert");
  json.index(1, 1);
  if (file.contains("points") || file.contains("weights")) add_points(file);
  const auto file_points = static_cast<std::uint32_t>(x_.size());
  json.go(file, "elements");
  json.array([&] {
    const Json::Keys keys =
        json.object({"kind", "degree", "basis", "points", "nodes", "weights", "name", "expect", "source"});
    const std::size_t end = json.at;
    const auto word = [&](std::string_view key, std::string_view first, std::string_view second) {
      json.go(keys, key);
      const std::string_view found = json.string();
      if (found != first && found != second) json.fail("unknown " + std::string(key));
      return found == first;
    };
    Shape shape{word("kind", "triangle", "quadrilateral"), false, 0, 0, nodes_.size()};
    shape.lagrange = keys.contains("basis") && word("basis", "lagrange", "bernstein");
    json.go(keys, "degree");
    const bool pair = !shape.triangle && json.accept('[');
    shape.p = shape.q = static_cast<std::uint16_t>(json.index(1, 64));
    if (pair) json.expect(','), shape.q = static_cast<std::uint16_t>(json.index(1, 64)), json.expect(']');
    if (keys.contains("nodes")) {
      if (keys.contains("points") || keys.contains("weights")) json.fail("nodes with points or weights");
      json.go(keys, "nodes");
      json.array([&] { nodes_.push_back(json.index(0, file_points - 1)); });
      if (file_points == 0) json.fail("nodes without points");
    } else {
      glued_by_nodes_ = false;
      auto place = static_cast<std::uint32_t>(x_.size());
      add_points(keys);
      while (place < x_.size()) nodes_.push_back(place++);
    }
    if (nodes_.size() - shape.first != point_count(shape.triangle, shape.p, shape.q))
      json.fail("number of points does not fit the degree");
    shapes_.push_back(shape);
    json.at = end;
  });
  if (!w_.empty()) w_.resize(x_.size(), "1");
}

}  // namespace verifier
