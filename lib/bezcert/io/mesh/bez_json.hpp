// Meshes in our own exact format, .bez.json (docs/formats.md). All numbers mean their exact decimal value, or
// p/q.
#pragma once

#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"

#include <iosfwd>
#include <string>
#include <string_view>

namespace bezcert {

/// Throws InputError. Curves are checked for their form and left out: a mesh has elements only. Of the
/// options none matters: the format says all itself.
MeshBuilder read_bez_json(const std::string& file, std::string_view bytes, const ReadOptions& options);

/// A whole mesh, exactly: the same elements in the same order, the same bases, glued in the same way. Numbers
/// that the file gave nodes and elements are replaced by places.
void write_bez_json(std::ostream& stream, const Mesh& mesh);

/// One element with its points as given, exactly; `name` and `source` are left out if empty.
void write_bez_json(std::ostream& stream, const Element& element, const std::string& name,
                    const std::string& source);

}  // namespace bezcert
