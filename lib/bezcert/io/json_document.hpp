// JSON with two things our format needs and ordinary readers lose: the line of every value, and the text of
// every number, so that 0.1 is one tenth. Parsing itself is nlohmann-json's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

struct JsonMember;

struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  std::size_t line = 0;
  std::string text;                 ///< of a string, or of a number as written
  std::vector<JsonValue> items;     ///< of an array
  std::vector<JsonMember> members;  ///< of an object, in file order, keys unique

  /// The member of that key, or nullptr.
  const JsonValue* find(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// What a value is, for messages: "a string".
std::string_view name(JsonValue::Kind kind);

/// Throws InputError on a syntax error, a repeated key, or nesting deeper than 32.
JsonValue parse_json(const std::string& file, std::string_view bytes);

}  // namespace bezcert
