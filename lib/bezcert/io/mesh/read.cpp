#include "bezcert/io/mesh/read.hpp"

#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/mesh/gmsh.hpp"

#include <algorithm>

namespace bezcert {
namespace {

struct Format {
  std::string_view name;    // with what its files start with, for people
  std::string_view starts;  // the first bytes behind white space
  MeshBuilder (*read)(const std::string& file, std::string_view bytes, const ReadOptions& options);
};

constexpr Format formats[] = {
    {"Gmsh .msh (starting with $MeshFormat)", "$", read_gmsh},
    {".bez.json (starting with {)", "{", read_bez_json},
};

const Format& format_of(const std::string& file, std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) throw InputError(file, 0, "the file is empty");
  const std::string_view begin = bytes.substr(start);
  const auto* const found = std::find_if(std::begin(formats), std::end(formats), [&](const Format& format) {
    return begin.starts_with(format.starts);
  });
  if (found != std::end(formats)) return *found;
  std::string names;
  for (const Format& format : formats) names += (names.empty() ? "" : " or ") + std::string(format.name);
  const bool marked = begin.starts_with("\xEF\xBB\xBF");
  throw InputError(file, 0,
                   std::string("the format is not known") +
                       (marked ? " (the file starts with a UTF-8 byte order mark)" : "") + ": expected " +
                       names);
}

}  // namespace

Mesh read_mesh(const std::string& file, std::string_view bytes, const ReadOptions& options) {
  const Format& format = format_of(file, bytes);
  MeshBuilder builder;
  try {
    builder = format.read(file, bytes, options);
    return std::move(builder).build();
  } catch (const MeshError& error) {
    if (!error.element()) throw InputError(file, 0, error.problem());
    const MeshOrigin& origin = builder.origin();
    throw InputError(file, origin.line(*error.element()),
                     "element " + std::to_string(origin.number(*error.element())) + ": " + error.problem());
  }
}

Mesh read_mesh_file(const std::string& path, const ReadOptions& options) {
  const FileBytes file(path);
  Mesh mesh = read_mesh(path, file.view(), options);
  file.check_unchanged();
  return mesh;
}

}  // namespace bezcert
