// The report does not depend on the number of threads: byte for byte, but for the seconds.
#include "program.hpp"

#include <catch2/catch.hpp>

namespace bezcert::test {
namespace {

std::string without_seconds(std::string text) {
  for (std::size_t at = text.find("\"seconds\":"); at != std::string::npos;
       at = text.find("\"seconds\":", at + 1)) {
    const std::size_t end = text.find('}', at);
    REQUIRE(end != std::string::npos);
    text.erase(at, end - at);
  }
  return text;
}

}  // namespace

TEST_CASE("reports are the same for every number of threads") {
  const Folder folder;
  std::vector<std::string> meshes;
  for (const char* at : {"/corpus/meshes", "/corpus/whole"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(BEZCERT_SOURCE_DIR) + at)) {
      const std::string path = entry.path();
      if (path.find("/curves-") != std::string::npos) continue;  // no meshes
      if (path.ends_with(".msh") || path.ends_with(".bez.json")) meshes.push_back(path);
    }
  }
  std::sort(meshes.begin(), meshes.end());
  REQUIRE(meshes.size() > 100);
  std::size_t elements = 0;
  for (const char* format : {"jsonl", "text"}) {
    for (const char* criteria : {"none", "all"}) {
      std::vector<std::string> arguments = {"check", std::string("--format=") + format,
                                            std::string("--criteria=") + criteria, "--jobs=1"};
      arguments.insert(arguments.end(), meshes.begin(), meshes.end());
      const Outcome one = folder.run(arguments);
      INFO("certify" << joined({arguments.begin(), arguments.begin() + 4}) << "\n" << one.err);
      REQUIRE(one.code == 1);
      const std::string expected = without_seconds(one.out);
      for (const char* jobs : {"--jobs=2", "--jobs=5"}) {
        arguments[3] = jobs;
        const Outcome several = folder.run(arguments);
        CHECK(several.code == one.code);
        CHECK((without_seconds(several.out) == expected));
      }
      elements += static_cast<std::size_t>(std::count(expected.begin(), expected.end(), '\n'));
    }
  }
  CHECK(elements > 2000);
}

TEST_CASE("an error is the same one for every number of threads") {
  const Folder folder;
  const std::string mesh = folder.write("short.msh", trap_mesh.substr(0, trap_mesh.size() - 14));
  for (const char* jobs : {"--jobs=1", "--jobs=3"})
    require_refused(folder, {"check", jobs, mesh}, "$EndElements");
  require_refused(folder, {"check", "--jobs=0", mesh}, "--jobs");
}

}  // namespace bezcert::test
