// A report in JSON Lines, taken apart: one part a mesh.
#pragma once

#include "bezcert/number/rational.hpp"
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <regex>
#include <string>
#include <vector>

namespace bezcert::test {

using Json = nlohmann::ordered_json;

struct MeshReport {
  Json header;
  std::vector<Json> elements;
  Json summary;
};

inline std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return keys;
}

/// Header, elements, summary, and again for the next mesh; every line is one object.
inline std::vector<MeshReport> parse_report(const std::string& text) {
  std::vector<MeshReport> reports;
  bool open = false;
  for (const std::string& line : lines_of(text)) {
    INFO(line.substr(0, 300));
    const Json object = Json::parse(line);
    REQUIRE(object.is_object());
    if (object.contains("schema")) {
      REQUIRE(!open);
      reports.push_back({object, {}, {}});
      open = true;
    } else if (object.contains("summary")) {
      REQUIRE(open);
      REQUIRE(keys_of(object) == std::vector<std::string>{"summary"});
      reports.back().summary = object["summary"];
      open = false;
    } else {
      REQUIRE(open);
      reports.back().elements.push_back(object);
    }
  }
  REQUIRE(!open);
  return reports;
}

/// A number of a report: a string "p/q" in lowest terms with q > 1, or "p".
inline Rational rational_of(const Json& value) {
  REQUIRE(value.is_string());
  const std::string text = value.get<std::string>();
  INFO("number " << text);
  REQUIRE(std::regex_match(text, std::regex("(0|-?[1-9][0-9]*)(/[1-9][0-9]*)?")));
  const std::size_t slash = text.find('/');
  const Integer above(text.substr(0, slash));
  if (slash == std::string::npos) return Rational(above);
  const Integer below(text.substr(slash + 1));
  REQUIRE(below > 1);
  REQUIRE(gcd(above, below) == 1);
  return Rational(above, below);
}

}  // namespace bezcert::test
