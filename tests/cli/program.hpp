// Runs the real programs in a folder of its own and keeps what they said.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace bezcert::test {

inline const std::string elements_folder = BEZCERT_SOURCE_DIR "/corpus/elements/";
inline const std::string meshes_folder = BEZCERT_SOURCE_DIR "/corpus/meshes/";

inline std::string corpus_element(const std::string& name) { return elements_folder + name + ".bez.json"; }

inline std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  INFO("file " << path);
  REQUIRE(stream.good());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The lines of a text; every one must be ended.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  INFO(text);
  REQUIRE((text.empty() || text.back() == '\n'));
  return lines;
}

struct Outcome {
  int code = -1;  ///< exit code; 128 + signal if it was killed
  std::string out;
  std::string err;
};

/// A new folder, removed at the end; programs run in it.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bezcert-cli-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
    std::filesystem::create_directory(path_ / "work");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// The path of a file in it.
  std::string operator/(const std::string& name) const { return (path_ / "work" / name).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(*this / name, std::ios::binary) << bytes;
    return *this / name;
  }

  /// The names of the files in it, sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_ / "work"))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Runs certify here; standard output goes to `output` if given, memory is limited to `memory` bytes.
  Outcome run(const std::vector<std::string>& arguments, const std::string& output = "",
              rlim_t memory = RLIM_INFINITY) const {
    return run_program(CERTIFY_PROGRAM, arguments, output, memory);
  }

  /// Runs verifier here.
  Outcome verify(const std::string& elements, const std::string& certificate) const {
    return run_program(VERIFIER_PROGRAM, {elements, certificate}, "", RLIM_INFINITY);
  }

  /// Becomes a program: for children.
  [[noreturn]] static void execute(const std::vector<std::string>& arguments,
                                   const char* program = CERTIFY_PROGRAM) {
    std::vector<std::string> words = {program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(program, pointers.data());
    ::_exit(127);
  }

 private:
  Outcome run_program(const char* program, const std::vector<std::string>& arguments,
                      const std::string& output, rlim_t memory) const {
    const std::string out = (path_ / "out").string();
    const std::string err = (path_ / "err").string();
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      limit_memory(memory);
      redirect(0, "/dev/null", O_RDONLY);
      redirect(1, output.empty() ? out : output, O_WRONLY | O_CREAT | O_TRUNC);
      redirect(2, err, O_WRONLY | O_CREAT | O_TRUNC);
      if (::chdir((path_ / "work").c_str()) != 0) ::_exit(127);
      execute(arguments, program);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (output.empty()) outcome.out = bytes_of(out);
    outcome.err = bytes_of(err);
    return outcome;
  }

  static void limit_memory([[maybe_unused]] rlim_t bytes) {
    // A sanitizer needs terabytes of address space for its own tables.
#if !defined(__SANITIZE_ADDRESS__)
    const rlimit limit = {bytes, bytes};
    if (bytes != RLIM_INFINITY && ::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(125);
#endif
  }
  static void redirect(int to, const std::string& path, int flags) {
    const int file = ::open(path.c_str(), flags, 0600);
    if (file < 0 || ::dup2(file, to) < 0) ::_exit(126);
    ::close(file);
  }

  std::filesystem::path path_;
};

inline std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " '" + word + "'";
  return text;
}

/// Requires exit code 2, one line on standard error that holds `phrase`, nothing on standard output.
inline void require_refused(const Folder& folder, const std::vector<std::string>& arguments,
                            const std::string& phrase) {
  const Outcome outcome = folder.run(arguments);
  INFO("certify" << joined(arguments) << "\nstdout: " << outcome.out << "\nstderr: " << outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK((!outcome.err.empty() && outcome.err.back() == '\n'));
  CHECK(outcome.err.find(phrase) != std::string::npos);
}

/// A .msh 2.2 of one quadratic triangle, element 7 in line 15: corners (0,0), (1,0), (0,1), edge point
/// (0.5, 0.45) between the first two, the middles on the others.
inline const std::string trap_mesh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0.5 0.45 0\n5 0.5 0.5 "
    "0\n6 0 0.5 0\n"
    "$EndNodes\n$Elements\n1\n7 9 0 1 2 3 4 5 6\n$EndElements\n";

/// A .msh 2.2 of one straight triangle with its first corner at (0, 0).
inline std::string straight_mesh(const std::string& second, const std::string& third) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 " + second + " 0\n3 " + third +
         " 0\n$EndNodes\n$Elements\n1\n1 2 0 1 2 3\n$EndElements\n";
}

}  // namespace bezcert::test
