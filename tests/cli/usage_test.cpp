// Wrong use: exit code 2, one line on standard error, nothing on standard output.
#include "program.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {

TEST_CASE("wrong options are refused with one line") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{}, "subcommand"},
      {{"chekc", mesh}, ""},
      {{mesh}, ""},
      {{"check"}, "MESH"},
      {{"check", "--frobnicate", mesh}, "--frobnicate"},
      {{"check", mesh, "-x"}, "-x"},
      {{"check", mesh, "--criteria=cone,magic"}, "\"magic\" is no criterion"},
      {{"check", mesh, "--criteria=cone,"}, "is no criterion"},
      {{"check", mesh, "--criteria=all,cone"}, "\"all\" is no criterion"},
      {{"check", mesh, "--criteria="}, "--criteria"},
      {{"check", mesh, "--criteria=Cone"}, "\"Cone\" is no criterion"},
      {{"check", mesh, "--basis=bezier"}, "--basis"},
      {{"check", mesh, "--basis="}, "--basis"},
      {{"check", mesh, "--basis"}, "--basis"},
      {{"check", mesh, "--numbers=float"}, "--numbers"},
      {{"check", mesh, "--numbers="}, "--numbers"},
      {{"check", mesh, "--format=xml"}, "--format"},
      {{"check", mesh, "--format="}, "--format"},
      {{"check", mesh, "--budget=0"}, "--budget"},
      {{"check", mesh, "--budget=-1"}, "--budget"},
      {{"check", mesh, "--budget=many"}, "--budget"},
      {{"check", mesh, "--budget=1.5"}, "--budget"},
      {{"check", mesh, "--budget=100000000000000000000000"}, "--budget"},
      {{"check", mesh, "--budget="}, "--budget"},
      {{"check", mesh, "--fail-on=never"}, "--fail-on"},
      {{"check", mesh, "-o"}, "-o"},
      {{"check", ""}, "no such file"},
      {{"check", "missing.msh"}, "missing.msh: no such file"},
      {{"check", "."}, "folder"},
      {{"check", "missing\xff.msh"}, "no such file"},
      {{"explain"}, ""},
      {{"explain", mesh}, "--element"},
      {{"explain", "--element", "7"}, "MESH"},
      {{"explain", mesh, mesh, "--element", "7"}, ""},
      {{"explain", mesh, "--element"}, "--element"},
      {{"explain", mesh, "--element", "8"}, "no element 8"},
      {{"explain", mesh, "--element", ""}, "element"},
      {{"explain", mesh, "--element", "seven"}, "no element seven"},
      {{"explain", mesh, "--element", "7", "--basis=x"}, "--basis"},
      {{"explain", mesh, "--element", "7", "--budget=0"}, "--budget"},
      {{"explain", "missing.msh", "--element", "7"}, "missing.msh: no such file"},
      {{"criteria", "cone"}, "cone"},
      {{"criteria", "--all"}, "--all"},
  };
  for (const auto& [arguments, phrase] : cases) require_refused(folder, arguments, phrase);
  CHECK(cases.size() == 43);
  CHECK(folder.files() == std::vector<std::string>{"trap.msh"});
}

// The words are the interface. A number that happens to stand for one inside the program is none.
TEST_CASE("numbers are no names of a basis or of what numbers mean") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  std::size_t seen = 0;
  for (const std::string option : {"--basis", "--numbers"}) {
    for (const std::string value : {"0", "1", "2", "-1", "255"}) {
      require_refused(folder, {"check", mesh, option + "=" + value}, option);
      require_refused(folder, {"explain", mesh, "--element=7", option + "=" + value}, option);
      ++seen;
    }
  }
  CHECK(seen == 10);
}

TEST_CASE("help and version are answers, not errors") {
  const Folder folder;
  const std::vector<std::vector<std::string>> cases = {
      {"--help"}, {"-h"}, {"check", "--help"}, {"explain", "--help"}, {"criteria", "-h"}, {"--version"}};
  for (const auto& arguments : cases) {
    const Outcome outcome = folder.run(arguments);
    INFO("certify" << joined(arguments) << "\n" << outcome.out << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    CHECK(!lines_of(outcome.out).empty());
  }
  CHECK(cases.size() == 6);
  // Every subcommand and exit code is named.
  const std::string help = folder.run({"--help"}).out;
  for (const std::string word : {"check", "explain", "criteria", "0", "1", "2", "3", "4"}) {
    INFO(word);
    CHECK(help.find(word) != std::string::npos);
  }
  const std::string options = folder.run({"check", "--help"}).out;
  for (const std::string word :
       {"--basis", "--numbers", "--criteria", "--format", "-o", "--fail-on", "--budget"}) {
    INFO(word);
    CHECK(options.find(word) != std::string::npos);
  }
}

TEST_CASE("a bad mesh is told with its line, and the first one only") {
  const Folder folder;
  std::string bad = trap_mesh;
  bad.replace(bad.find("4 0.5 0.45 0"), 12, "4 0.5 nan 0\n");
  const std::string mesh = folder.write("bad.msh", bad);
  require_refused(folder, {"check", mesh}, mesh + ":9: ");
  require_refused(folder, {"check", mesh, mesh}, mesh + ":9: ");
  require_refused(folder, {"check", mesh, "--format=jsonl"}, mesh + ":9: ");
  require_refused(folder, {"explain", mesh, "--element=7"}, mesh + ":9: ");
  require_refused(folder, {"check", "/dev/null"}, "/dev/null: the file is empty");
}

}  // namespace bezcert::test
