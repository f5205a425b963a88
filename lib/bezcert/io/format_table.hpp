// Telling the format of a file by its first characters.
#pragma once

#include "bezcert/io/input_error.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace bezcert {

/// A format and its reader.
template <class Read>
struct FileFormat {
  std::string_view name;    ///< with what its files start with, for people
  std::string_view starts;  ///< the first bytes behind white space
  Read* read;
};

/// The format of a file's bytes. Throws InputError if it is none of them.
template <class Read, std::size_t count>
const FileFormat<Read>& format_of(const FileFormat<Read> (&formats)[count], const std::string& file,
                                  std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) throw InputError(file, 0, "the file is empty");
  const std::string_view begin = bytes.substr(start);
  const auto* const found =
      std::find_if(std::begin(formats), std::end(formats),
                   [&](const FileFormat<Read>& format) { return begin.starts_with(format.starts); });
  if (found != std::end(formats)) return *found;
  std::string names;
  for (const FileFormat<Read>& format : formats)
    names += (names.empty() ? "" : " or ") + std::string(format.name);
  const bool marked = begin.starts_with("\xEF\xBB\xBF");
  throw InputError(file, 0,
                   std::string("the format is not known") +
                       (marked ? " (the file starts with a UTF-8 byte order mark)" : "") + ": expected " +
                       names);
}

}  // namespace bezcert
