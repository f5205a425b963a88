// The hidden switch --exact: integers alone decide, and the report is the same to the byte, but for its
// seconds.
#include "program.hpp"

#include <catch2/catch.hpp>

#include <regex>

namespace bezcert::test {
namespace {

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (path.ends_with(".msh") || path.ends_with(".bez.json")) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string without_seconds(const std::string& report) {
  return std::regex_replace(report, std::regex("\"seconds\":[^,}]*"), "\"seconds\":0");
}

}  // namespace

TEST_CASE("the switch --exact changes no byte of a report on the corpus") {
  const Folder folder;
  std::size_t files = 0;
  for (const std::string& corpus : {elements_folder, meshes_folder}) {
    for (const std::string& file : files_in(corpus)) {
      const Outcome filtered =
          folder.run({"check", "--format=jsonl", "--criteria=none", "--budget=64,0", file});
      const Outcome exact =
          folder.run({"check", "--format=jsonl", "--criteria=none", "--budget=64,0", "--exact", file});
      INFO(file);
      REQUIRE(filtered.code == exact.code);
      REQUIRE(without_seconds(filtered.out) == without_seconds(exact.out));
      ++files;
    }
  }
  CHECK(files > 200);
}

TEST_CASE("the switch --exact is not listed") {
  const Folder folder;
  CHECK(folder.run({"check", "--help"}).out.find("--exact") == std::string::npos);
}

}  // namespace bezcert::test
