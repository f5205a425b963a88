#include "bezcert/io/bez_json_values.hpp"

#include "bezcert/element/element.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/io/printable.hpp"
#include "bezcert/number/parse.hpp"

#include <algorithm>

namespace bezcert {

using Kind = JsonValue::Kind;

BezJsonValues::BezJsonValues(std::string file, const JsonValue& root) : file_(std::move(file)) {
  expect(root, Kind::object, "the file");
  check_keys(root, {"bezcert", "elements", "curves", "points", "weights"});
  const JsonValue& version = required(root, "bezcert", "the file");
  if (version.kind != Kind::number || version.text != "1")
    fail(version, "\"bezcert\" must be 1, the format's version");
}

void BezJsonValues::fail(const JsonValue& where, const std::string& message) const {
  throw InputError(file_, where.line, message);
}

void BezJsonValues::expect(const JsonValue& value, Kind kind, const std::string& what) const {
  if (value.kind != kind) {
    fail(value, what + " must be " + std::string(name(kind)) + ", not " + std::string(name(value.kind)));
  }
}

void BezJsonValues::check_keys(const JsonValue& object, std::initializer_list<std::string_view> known) const {
  for (const auto& [key, value] : object.members) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string list;
    for (const std::string_view k : known) list += (list.empty() ? "" : ", ") + std::string(k);
    fail(value, "the key \"" + printable(key) + "\" is not known: expected one of " + list);
  }
}

const JsonValue& BezJsonValues::required(const JsonValue& object, std::string_view key,
                                         const std::string& what) const {
  const JsonValue* value = object.find(key);
  if (value == nullptr) fail(object, what + " has no \"" + std::string(key) + "\"");
  return *value;
}

Rational BezJsonValues::number(const JsonValue& value, const std::string& what) const {
  if (value.kind == Kind::number || value.kind == Kind::string) {
    // A JSON number keeps its text, so both mean the exact value.
    if (const auto result =
            value.kind == Kind::number ? parse_decimal(value.text) : parse_rational(value.text)) {
      return *result;
    }
  }
  fail(value,
       what + " is " +
           (value.text.empty() ? std::string(name(value.kind)) : "\"" + printable(value.text) + "\"") +
           ": expected a finite decimal or \"p/q\", of at most 20000 characters and exponents up to 5000");
}

int BezJsonValues::degree(const JsonValue& value) const {
  const auto result = value.kind == Kind::number ? parse_decimal(value.text) : std::nullopt;
  if (!result || denominator(*result) != 1 || *result < 1 || *result > max_degree) {
    fail(value, "a degree must be an integer from 1 to " + std::to_string(max_degree));
  }
  return static_cast<int>(numerator(*result).convert_to<long>());
}

void BezJsonValues::expect_point(const JsonValue& value) const {
  if (value.kind != Kind::array || value.items.size() != 2) fail(value, "a point must be [x, y]");
}

std::string BezJsonValues::optional_text(const JsonValue& object, std::string_view key) const {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return "";
  expect(*value, Kind::string, "\"" + std::string(key) + "\"");
  return value->text;
}

}  // namespace bezcert
