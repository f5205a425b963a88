// Where reports go: whole files or none, only what may be written, nothing on a terminal's behalf.
#include "program.hpp"

#include <sys/stat.h>

#include <pty.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace bezcert::test {
namespace {

namespace fs = std::filesystem;

// Many straight-sided cubic triangles apart from each other, so that checking takes a while.
std::string large_mesh(int count) {
  std::string nodes, elements;
  // The grid points (i, j) of the cubic in gmsh's order: corners, edges, the inner one.
  const int grid[10][2] = {{0, 0}, {3, 0}, {0, 3}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  for (int i = 0; i < count; ++i) {
    elements += std::to_string(i + 1) + " 21 0";
    for (int k = 0; k < 10; ++k) {
      const std::string node = std::to_string(10 * i + k + 1);
      nodes += node + " " + std::to_string(4 * i + grid[k][0]) + " " + std::to_string(grid[k][1]) + " 0\n";
      elements += " " + node;
    }
    elements += "\n";
  }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(10 * count) + "\n" + nodes +
         "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements + "$EndElements\n";
}

// What certify writes to a terminal as its standard error; standard output goes to a file.
std::string terminal_output(const Folder& folder, const std::vector<std::string>& arguments) {
  const std::string out = folder / "terminal.out";
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    const int file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || ::dup2(file, 1) < 0) ::_exit(126);
    Folder::execute(arguments);
  }
  std::string text;
  char block[4096];
  for (ssize_t count = 0; (count = ::read(terminal, block, sizeof block)) > 0;)
    text.append(block, static_cast<std::size_t>(count));
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  ::close(terminal);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  return text;
}

}  // namespace

TEST_CASE("option -o writes what would have been printed, and prints nothing") {
  const Folder folder;
  const std::string mesh = meshes_folder + "notch_q2_22b.msh";
  const Outcome printed = folder.run({"check", mesh});
  const Outcome written = folder.run({"check", mesh, "-o", "report.txt"});
  CHECK(printed.code == 1);
  CHECK(written.code == 1);
  CHECK(written.out.empty());
  CHECK(written.err.empty());
  CHECK(!printed.out.empty());
  CHECK(bytes_of(folder / "report.txt") == printed.out);
  CHECK(folder.files() == std::vector<std::string>{"report.txt"});
  // A second report takes the place of the first.
  CHECK(folder.run({"check", corpus_element("affine"), "-o", "report.txt", "--format=jsonl"}).code == 0);
  CHECK(lines_of(bytes_of(folder / "report.txt")).size() == 3);
  CHECK(folder.files() == std::vector<std::string>{"report.txt"});
}

TEST_CASE("option -o leaves an existing file as it was when the input is wrong") {
  const Folder folder;
  const std::string report = folder.write("report.txt", "what was here\n");
  const std::string bad = folder.write("bad.msh", trap_mesh.substr(0, 80));
  const std::string good = corpus_element("affine");
  const std::vector<std::vector<std::string>> cases = {
      {"check", bad, "-o", report},
      {"check", good, bad, "-o", report},
      {"check", "none.msh", "-o", report},
      {"check", good, "none.msh", good, "-o", report, "--format=jsonl"}};
  for (const auto& arguments : cases) {
    require_refused(folder, arguments, "");
    CHECK(bytes_of(report) == "what was here\n");
    CHECK(folder.files() == std::vector<std::string>{"bad.msh", "report.txt"});
  }
  CHECK(cases.size() == 4);
  require_refused(folder, {"check", bad, "-o", "new.txt"}, "bad.msh");
  CHECK(folder.files() == std::vector<std::string>{"bad.msh", "report.txt"});
}

TEST_CASE("option -o onto an input is refused, by whatever name") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  const std::string other = folder.write("other.msh", trap_mesh);
  fs::create_symlink(mesh, folder / "symbolic.msh");
  fs::create_hard_link(mesh, folder / "hard.msh");
  const std::vector<std::vector<std::string>> cases = {
      {"check", mesh, "-o", mesh},           {"check", mesh, "-o", "trap.msh"},
      {"check", mesh, "-o", "./trap.msh"},   {"check", other, mesh, "-o", "../work/trap.msh"},
      {"check", mesh, "-o", "symbolic.msh"}, {"check", "symbolic.msh", "-o", mesh},
      {"check", mesh, "-o", "hard.msh"}};
  for (const auto& arguments : cases) {
    require_refused(folder, arguments, "input");
    CHECK(bytes_of(mesh) == trap_mesh);
  }
  CHECK(cases.size() == 7);
  CHECK(fs::is_symlink(folder / "symbolic.msh"));
  CHECK(folder.files().size() == 4);
}

TEST_CASE("option -o where nothing can be written is refused with one line") {
  const Folder folder;
  const std::string mesh = corpus_element("affine");
  fs::create_directory(folder / "sub");
  require_refused(folder, {"check", mesh, "-o", "missing/report.txt"}, "missing/report.txt");
  require_refused(folder, {"check", mesh, "-o", "sub"}, "sub");
  require_refused(folder, {"check", mesh, "-o", "sub/"}, "sub/");
  require_refused(folder, {"check", mesh, "-o", mesh + "/report.txt"}, "report.txt");
  CHECK(fs::is_empty(folder / "sub"));
  CHECK(folder.files() == std::vector<std::string>{"sub"});
}

// Root may rename a file onto /dev/null. Here a pipe stands for it.
TEST_CASE("option -o onto a device writes to it or is refused, but never replaces it") {
  const Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int both = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);  // so that writing does not wait
  REQUIRE(both >= 0);
  const Outcome outcome = folder.run({"check", corpus_element("affine"), "-o", pipe});
  CHECK((outcome.code == 0 || outcome.code == 2));
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.files() == std::vector<std::string>{"pipe"});
  ::close(both);
}

TEST_CASE("a full disk under standard output is an error") {
  const Folder folder;
  const std::string mesh = folder.write("trap.msh", trap_mesh);
  const std::vector<std::vector<std::string>> cases = {
      {"check", mesh}, {"check", mesh, "--format=jsonl"}, {"explain", mesh, "--element=7"}, {"criteria"}};
  for (const auto& arguments : cases) {
    const Outcome outcome = folder.run(arguments, "/dev/full");
    INFO("certify" << joined(arguments) << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(lines_of(outcome.err).size() == 1);
  }
  CHECK(cases.size() == 4);
}

TEST_CASE("progress is for terminals only") {
  const Folder folder;
  const std::string mesh = folder.write("large.msh", large_mesh(30000));
  const Outcome outcome = folder.run({"check", mesh});
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find('\r') == std::string::npos);
  CHECK(outcome.out.find("30000 elements: 30000 injective") != std::string::npos);
  // Each has the area 9/2.
  CHECK(outcome.out.find("mesh: embedding, 30000 components, 0 holes, 30000 boundary loops, area 135000") !=
        std::string::npos);
  // Without filters half a second at least; the first sign of progress is due after a tenth.
  const std::string progress = terminal_output(folder, {"check", "--exact", mesh});
  INFO(progress);
  CHECK(progress.find(" of 30000 elements") != std::string::npos);
  CHECK(bytes_of(folder / "terminal.out") == outcome.out);
}

TEST_CASE("a text report has one line for each bad element, whatever its name") {
  const Folder folder;
  const std::string mesh = folder.write(
      "named.bez.json",
      "{\"bezcert\":1,\"elements\":[\n"
      R"({"name":"first\nsecond\u001b[31m\r","kind":"triangle","degree":1,"points":[[0,0],[0,1],[1,0]]}]})");
  const Outcome outcome = folder.run({"check", mesh, "--criteria=none"});
  CHECK(outcome.code == 1);
  const auto lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].starts_with(mesh + ":2: element 1 "));
  for (const std::string& line : lines) {
    for (const char c : line) CHECK((c < 0 || c >= 32));
  }
  CHECK(lines[1] == mesh + ": 1 element: 1 reversed");
  CHECK(lines[2].starts_with(mesh + ": mesh: invalid_element"));
}

}  // namespace bezcert::test
