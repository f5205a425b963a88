// The values of a .bez.json file (docs/formats.md), each with what is said if it is another: what the readers
// of its meshes and of its curves share. All numbers mean their exact decimal value, or p/q.
#pragma once

#include "bezcert/io/json_document.hpp"
#include "bezcert/number/rational.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace bezcert {

/// Every function throws InputError, with the line of the value.
class BezJsonValues {
 public:
  /// `file` names the file in errors. Checks what the file says of itself.
  BezJsonValues(std::string file, const JsonValue& root);

  [[noreturn]] void fail(const JsonValue& where, const std::string& message) const;
  void expect(const JsonValue& value, JsonValue::Kind kind, const std::string& what) const;
  void check_keys(const JsonValue& object, std::initializer_list<std::string_view> known) const;
  const JsonValue& required(const JsonValue& object, std::string_view key, const std::string& what) const;

  Rational number(const JsonValue& value, const std::string& what) const;
  int degree(const JsonValue& value) const;
  /// Checks that a value is [x, y].
  void expect_point(const JsonValue& value) const;
  /// The text of a member, empty if there is none.
  std::string optional_text(const JsonValue& object, std::string_view key) const;

 private:
  std::string file_;
};

}  // namespace bezcert
