#include "bezcert/io/mesh/read.hpp"

#include "bezcert/io/file.hpp"
#include "bezcert/io/format_table.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/mesh/gmsh.hpp"

namespace bezcert {
namespace {

using Format =
    FileFormat<MeshBuilder(const std::string& file, std::string_view bytes, const ReadOptions& options)>;

// One line a format.
constexpr Format formats[] = {
    {"Gmsh .msh (starting with $MeshFormat)", "$", read_gmsh},
    {".bez.json (starting with {)", "{", read_bez_json},
};

}  // namespace

Mesh read_mesh(const std::string& file, std::string_view bytes, const ReadOptions& options) {
  const Format& format = format_of(formats, file, bytes);
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
