// Whole files: reading, SHA-256, writing that is never half done.
#include "bezcert/io/file.hpp"

#include "mesh/reading.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <thread>

namespace bezcert::test {
namespace {

namespace fs = std::filesystem;

// A new folder, removed at the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "bezcert-io-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

}  // namespace

// FIPS 180-2, appendix B, and the digest of no bytes.
TEST_CASE("sha256 of the standard's examples") {
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a file is written whole and read back byte for byte") {
  const Folder folder;
  std::string bytes;
  for (unsigned i = 0; i < 300000; ++i) bytes += static_cast<char>(i * i % 256);
  write_file(folder / "a", [&](std::ostream& stream) { stream << bytes; });
  CHECK(read_file(folder / "a") == bytes);
  write_file(folder / "a", [](std::ostream& stream) { stream << "short\r\n"; });
  CHECK(read_file(folder / "a") == "short\r\n");
  write_file(folder / "empty", [](std::ostream&) {});
  CHECK(read_file(folder / "empty").empty());
  CHECK(folder.count() == 2);
}

TEST_CASE("the bytes of a file, mapped or read, and whether it was written to meanwhile") {
  const Folder folder;
  const std::string bytes = std::string(5000, 'a') + '\0' + "end";
  write_file(folder / "a", [&](std::ostream& stream) { stream << bytes; });
  const FileBytes file(folder / "a");
  CHECK(file.view() == bytes);
  CHECK_NOTHROW(file.check_unchanged());
  // Replaced by renaming, the bytes stay; written in place they do not.
  write_file(folder / "a", [&](std::ostream& stream) { stream << "other"; });
  CHECK(file.view() == bytes);
  CHECK_NOTHROW(file.check_unchanged());
  const FileBytes other(folder / "a");
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // coarser clocks of file systems
  std::ofstream(folder / "a", std::ios::app) << "more";
  CHECK_THROWS_AS(other.check_unchanged(), InputError);

  write_file(folder / "empty", [](std::ostream&) {});
  CHECK(FileBytes(folder / "empty").view().empty());
  CHECK_THROWS_AS(FileBytes(folder / "none"), InputError);
  CHECK_THROWS_AS(FileBytes(folder / "."), InputError);

  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  std::thread writer([&] { std::ofstream(folder / "pipe", std::ios::binary) << bytes; });
  CHECK(FileBytes(folder / "pipe").view() == bytes);
  writer.join();
}

TEST_CASE("a file whose writing fails keeps what it held, and nothing is left behind") {
  const Folder folder;
  write_file(folder / "a", [](std::ostream& stream) { stream << "before"; });
  const auto fails = [](std::ostream& stream) {
    stream << "half of it" << std::flush;
    throw std::runtime_error("in the middle");
  };
  CHECK_THROWS_WITH(write_file(folder / "a", fails), "in the middle");
  CHECK(read_file(folder / "a") == "before");
  CHECK_THROWS_WITH(write_file(folder / "b", fails), "in the middle");
  CHECK(folder.count() == 1);
  CHECK_THROWS_AS(write_file(folder / "a", [](std::ostream& stream) { stream.setstate(std::ios::failbit); }),
                  InputError);
  CHECK(read_file(folder / "a") == "before");
  CHECK(folder.count() == 1);
}

TEST_CASE("files that cannot be read or written are input errors that name them") {
  const Folder folder;
  const auto message = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const InputError& error) {
      CHECK(is_one_line(error.what()));
      CHECK(error.line() == 0);
      return error.what();
    }
    return "";
  };
  const auto ignore = [](std::ostream&) {};
  const std::string missing = folder / "none";
  CHECK(message([&] { read_file(missing); }) == missing + ": no such file");
  CHECK(message([&] { read_file(folder / "."); }).find("folder") != std::string::npos);
  CHECK(message([&] { write_file(missing + "/x", ignore); }).starts_with(missing + "/x: cannot be written"));
  fs::create_directory(folder / "sub");
  CHECK(message([&] { write_file(folder / "sub", ignore); }).starts_with((folder / "sub") + ": "));
  CHECK(fs::is_directory(folder / "sub"));
  CHECK(folder.count() == 1);
}

TEST_CASE("writing to a link writes to the file behind it and keeps permissions") {
  const Folder folder;
  write_file(folder / "a", [](std::ostream& stream) { stream << "before"; });
  fs::create_symlink("a", folder / "link");
  fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
  write_file(folder / "link", [](std::ostream& stream) { stream << "after"; });
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_file(folder / "a") == "after");
  CHECK(fs::status(folder / "a").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(folder.count() == 2);
}

// Renaming onto /dev/null, which root may, would take it away from everybody.
TEST_CASE("what is no file, such as a device, is never replaced by one") {
  const Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  // Open for both ends: writing to the pipe is possible and does not wait.
  const int both = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  REQUIRE(both >= 0);
  try {
    write_file(pipe, [](std::ostream& stream) { stream << "x"; });
  } catch (const InputError&) {  // refused is as good
  }
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.count() == 1);
  ::close(both);
}

}  // namespace bezcert::test
