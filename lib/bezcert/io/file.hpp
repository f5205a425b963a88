// Whole files: reading, naming by SHA-256, writing so that nothing is ever half written.
#pragma once

#include <array>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace bezcert {

/// The bytes of a file. Throws InputError if it cannot be read.
std::string read_file(const std::string& path);

/// The bytes of a file without a copy of them: a regular file is mapped, anything else (a pipe) is read.
class FileBytes {
 public:
  /// Throws InputError if the file cannot be read.
  explicit FileBytes(const std::string& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::string_view view() const { return bytes_; }

  /// Throws InputError if the file has been written to since: then what was made of its bytes, and their
  /// hash, may be of different states of it. (Bytes that are cut off while they are read end the program.)
  void check_unchanged() const;

 private:
  std::string path_;
  int descriptor_ = -1;
  std::string read_;  // if not mapped
  std::string_view bytes_;
  bool is_mapped_ = false;
  std::array<long, 3> state_{};
};

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// Writes a file through a temporary one in the same folder, renamed at the end: `path` holds either what
/// it held before or all that `write` wrote, and keeps its mode. A symbolic link is followed; what is no
/// regular file (a pipe, a device) is written to as it is. Throws InputError if the file cannot be written,
/// and what `write` throws.
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace bezcert
