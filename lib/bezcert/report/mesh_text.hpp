// The mesh as a whole in text: one line an obstacle, one line for the verdict.
#pragma once

#include "bezcert/surface/domain.hpp"
#include "bezcert/surface/embedding.hpp"

#include <string>
#include <vector>

namespace bezcert {

/// Significant bits of the bounds of an area that is not known exactly.
inline constexpr int area_bits = 16;

/// "non_conforming: ...; hint" for every obstacle kept but invalid elements, then "mesh: embedding, 1
/// component, ...".
std::vector<std::string> mesh_lines(const Mesh& mesh, const MeshResult& result);

/// One line an uncovered curve, then "domain FILE: conforming, 4 of 4 curves covered".
std::vector<std::string> domain_lines(const Mesh& mesh, const std::string& file, const DomainResult& domain);

/// One obstacle without its kind: message and hint.
std::string describe(const Mesh& mesh, const MeshObstacle& obstacle);

}  // namespace bezcert
