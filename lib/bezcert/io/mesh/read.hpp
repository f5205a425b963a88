// Reading a mesh file of any known format.
#pragma once

#include "bezcert/mesh/mesh.hpp"
#include "bezcert/parallel/executor.hpp"

#include <string>
#include <string_view>

namespace bezcert {

struct ReadOptions {
  /// What the points of a format mean that does not say it itself (.msh).
  Basis basis = Basis::lagrange;
  /// What text coordinates mean in a format that does not say it itself (.msh).
  Numbers numbers = Numbers::binary64;
  /// Threads that may help; the mesh, and what is refused, do not depend on it.
  Executor* executor = nullptr;
};

/// Reads a mesh from the bytes of a file; the format is told by the first characters. `file` names it in
/// errors. Throws InputError.
Mesh read_mesh(const std::string& file, std::string_view bytes, const ReadOptions& options = {});

/// The same for a file by its path.
Mesh read_mesh_file(const std::string& path, const ReadOptions& options = {});

}  // namespace bezcert
