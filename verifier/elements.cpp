// Elements of both formats, and the reader of .bez.json: known keys, none twice, indices and counts checked.
#include "elements.hpp"

#include <algorithm>
#include <cmath>
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

/// Appends the numbers as integers, all times the power of two that is returned.
mpz_class scale_doubles(const std::vector<std::string_view>& texts, std::vector<mpz_class>& integers) {
  std::vector<double> values;
  int least = 0, exponent = 0;
  for (const std::string_view text : texts) {
    values.push_back(nearest_double(text));
    std::frexp(values.back(), &exponent);
    least = std::min(least, exponent - 53);
  }
  for (const double value : values) {
    integers.emplace_back(std::ldexp(std::frexp(value, &exponent), 53));
    integers.back() <<= static_cast<unsigned>(exponent - 53 - least);
  }
  return mpz_class(1) << static_cast<unsigned>(-least);
}

/// The same with the least common denominator.
mpz_class scale_exact(const std::vector<std::string_view>& texts, bool fractions,
                      std::vector<mpz_class>& integers) {
  std::vector<mpq_class> values;
  mpz_class unit = 1;
  const auto work = [&] { spend(1024 * (1 + mpz_size(unit.get_mpz_t()))); };
  for (const std::string_view text : texts) {
    values.push_back(exact_number(text, fractions));
    work(), unit = lcm(unit, values.back().get_den());
  }
  for (const mpq_class& value : values) work(), integers.push_back(unit / value.get_den() * value.get_num());
  return unit;
}

}  // namespace

std::size_t point_count(bool triangle, std::size_t p, std::size_t q) {
  return triangle ? (p + 1) * (p + 2) / 2 : (p + 1) * (q + 1);
}

std::size_t edge_place(bool triangle, std::size_t p, std::size_t q, std::size_t e, std::size_t k,
                       std::size_t ring) {
  const std::size_t lost = ring * (triangle ? 3 : 2), a = p - lost, b = q - lost;  // degrees of the ring
  const std::size_t us[] = {0, a, triangle ? 0 : a, 0, 0}, vs[] = {0, 0, b, triangle ? 0 : b, 0};  // corners
  const std::size_t n = std::max<std::size_t>(1, e % 2 == 0 ? a : b);
  const std::size_t u = ring + (us[e] * (n - k) + us[e + 1] * k) / n;
  const std::size_t v = ring + (vs[e] * (n - k) + vs[e + 1] * k) / n;
  return triangle ? v * (2 * p + 3 - v) / 2 + u : v * (p + 1) + u;
}

std::vector<std::size_t> edge_positions(const Element& element, int e) {
  const auto p = static_cast<std::size_t>(element.p), q = static_cast<std::size_t>(element.q);
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k <= (e % 2 == 0 ? p : q); ++k)
    places.push_back(edge_place(element.triangle, p, q, static_cast<std::size_t>(e), k));
  return places;
}

Elements::Elements(std::string bytes, std::string_view basis, std::string_view numbers)
    : bytes_(std::move(bytes)), binary64_(numbers == "binary64"), json_(Json{bytes_}.peek() == '{') {
  const bool lagrange = basis == "lagrange", decimal = numbers == "decimal";
  if (!(json_ ? basis == "mixed" && decimal : (lagrange || basis == "bernstein") && (binary64_ || decimal)))
    throw Malformed{"basis and numbers do not fit the elements file"};
  if (bytes_.size() > 0xffffffff) throw Malformed{"limit: elements file of more than 4 GiB"};
  json_ ? read_json() : read_msh(lagrange);
  if (shapes_.empty()) throw Malformed{"elements file: no triangles, no quadrilaterals"};
}

std::vector<std::uint32_t> Elements::nodes(std::size_t i) const {
  const Shape& shape = shapes_[i];
  const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(shape.first);
  return {begin, begin + static_cast<std::ptrdiff_t>(point_count(shape.triangle, shape.p, shape.q))};
}

Element Elements::element(std::size_t i) const {
  const Shape& shape = shapes_[i];
  const std::vector<std::uint32_t> places = nodes(i);
  const auto scaled = [&](const std::vector<std::string_view>& column, std::vector<mpz_class>& integers) {
    std::vector<std::string_view> texts;
    for (const std::uint32_t place : places) texts.push_back(column[place]);
    return binary64_ ? scale_doubles(texts, integers) : scale_exact(texts, json_, integers);
  };
  Element e{shape.triangle, shape.p, shape.q, shape.lagrange, false, {}, {}, {}, {}};
  const mpz_class unit_x = scaled(x_, e.x), unit_y = scaled(y_, e.y);
  e.unit = lcm(unit_x, unit_y);
  const mpz_class factor_x = e.unit / unit_x, factor_y = e.unit / unit_y;
  for (mpz_class& x : e.x) x *= factor_x;
  for (mpz_class& y : e.y) y *= factor_y;
  if (!w_.empty()) scaled(w_, e.w);
  for (const mpz_class& w : e.w) {
    if (w <= 0) throw Malformed{"weight not positive"};
    e.rational = e.rational || w != e.w[0];
  }
  if (!e.rational) e.w.assign(places.size(), 1);
  return e;
}

void Elements::read_json() {
  Json json{bytes_};
  const auto add_points = [&](const Json::Keys& keys) {
    const std::size_t before = x_.size();
    json.go(keys, "points");
    json.list('[', ']', [&] {
      json.expect('['), x_.push_back(json.number());
      json.expect(','), y_.push_back(json.number());
      json.expect(']');
    });
    if (!keys.contains("weights")) return;
    w_.resize(before, "1");
    json.go(keys, "weights");
    json.list('[', ']', [&] { w_.push_back(json.number()); });
    if (w_.size() != x_.size()) json.fail("not one weight a point");
  };
  const Json::Keys file = json.object({"bezcert", "points", "weights", "elements", "curves"});
  if (json.peek(), json.at < bytes_.size()) json.fail("text after the object");
  json.go(file, "bezcert");
  json.integer(1, 1);
  if (file.contains("points") || file.contains("weights")) add_points(file);
  const long file_points = static_cast<long>(x_.size());
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
