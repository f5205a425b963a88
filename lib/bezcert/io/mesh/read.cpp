#include "bezcert/io/mesh/read.hpp"

#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/mesh/gmsh.hpp"
#include "bezcert/io/input_error.hpp"

namespace bezcert {

Mesh read_mesh(const std::string& file, std::string_view bytes, const ReadOptions& options) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) throw InputError(file, 0, "the file is empty");
  if (bytes[start] == '{') return read_bez_json(file, bytes);
  if (bytes[start] == '$') return read_gmsh(file, bytes, options);
  const bool marked = bytes.substr(start).starts_with("\xEF\xBB\xBF");
  throw InputError(file, 0,
                   std::string("the format is not known") +
                       (marked ? " (the file starts with a UTF-8 byte order mark)" : "") +
                       ": expected Gmsh .msh (starting with $MeshFormat) or .bez.json "
                       "(starting with {)");
}

}  // namespace bezcert
