// Every file of malformed/ is refused in its own words, and the table there lists every file.
#include "reading.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace bezcert::test {
namespace {

const std::string folder = BEZCERT_SOURCE_DIR "/tests/io/mesh/malformed/";

struct Expected {
  std::size_t line = 0;
  std::string phrase;
};

std::map<std::string, Expected> expected_table() {
  std::map<std::string, Expected> table;
  for (const auto& row : table_of(folder + "expected.tsv", 3)) {
    INFO(row[0]);
    REQUIRE(table.emplace(row[0], Expected{std::stoul(row[1]), row[2]}).second);
    REQUIRE(!row[2].empty());
  }
  return table;
}

}  // namespace

TEST_CASE("the table of malformed files lists what is in the folder") {
  const auto table = expected_table();
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == "expected.tsv" || name == "make.py" || name == "__pycache__") continue;
    INFO(name << " must be in expected.tsv");
    CHECK(table.count(name) == 1);
    ++files;
  }
  CHECK(files == table.size());
  CHECK(files >= 90);
}

TEST_CASE("every malformed file is refused with its line and its own phrase") {
  const auto table = expected_table();
  std::map<std::string, std::string> messages;  // file -> message without file and line
  for (const auto& [name, expected] : table) {
    INFO(name << ": expected line " << expected.line << " and: " << expected.phrase);
    const auto refused = refusal(bytes_of(folder + name), {}, name);
    CHECK(refused.has_value());
    if (!refused) continue;
    INFO("message: " << refused->what.substr(0, 400));
    CHECK(is_one_line(refused->what));
    CHECK(is_printable(refused->what));
    CHECK(refused->what.size() < 400);
    CHECK(refused->line == expected.line);
    const std::string start = name + (expected.line > 0 ? ":" + std::to_string(expected.line) : "") + ": ";
    CHECK(refused->what.starts_with(start));
    CHECK(refused->what.find(expected.phrase) != std::string::npos);
    messages[name] = refused->what.substr(std::min(start.size(), refused->what.size()));
  }
  CHECK(messages.size() == table.size());
  // No two are told in the same words, and each phrase tells its file from all others.
  std::set<std::string> different;
  for (const auto& [name, message] : messages) {
    INFO(name << ": " << message);
    CHECK(different.insert(message).second);
    for (const auto& [other, expected] : table) {
      if (other == name || message.find(expected.phrase) == std::string::npos) continue;
      INFO("the phrase of " << other << " is in this message too: " << expected.phrase);
      CHECK(other == name);
    }
  }
}

}  // namespace bezcert::test
