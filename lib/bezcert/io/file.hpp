// Whole files: reading, naming by SHA-256, writing so that nothing is ever half written.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace bezcert {

/// The bytes of a file. Throws InputError if it cannot be read.
std::string read_file(const std::string& path);

/// SHA-256 in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// Writes a file through a temporary one in the same folder, renamed at the end: `path` holds either what
/// it held before or all that `write` wrote, and keeps its mode. A symbolic link is followed; what is no
/// regular file (a pipe, a device) is written to as it is. Throws InputError if the file cannot be written,
/// and what `write` throws.
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace bezcert
