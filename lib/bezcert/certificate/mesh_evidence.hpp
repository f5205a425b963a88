// The claim of the mesh in a certificate, with its evidence (docs/certificate-format.md, "The claim of the
// mesh").
//
// Of an embedding: how edges are glued that are one curve in different texts, and for any two boundary edges
// whose boxes meet that they meet at joints only; the rest is for the verifier to compute. Of any other
// verdict one refutation (refutation.hpp).
#pragma once

#include "bezcert/surface/embedding.hpp"

#include <iosfwd>
#include <span>
#include <string>

namespace bezcert {

/// What certificates call an edge: the position of its element, counted from 1, and its number in it.
std::string edge_name(const HalfEdges& edges, HalfEdge h);

/// Writes the line `mesh ...` and those that follow it. `claims`: what the certificate claims of each
/// element. False if it claims less than `result` says, because evidence is missing or exceeds the limits;
/// then `mesh undecided` is written. Precondition: `result` is examine_mesh's of the whole mesh.
bool write_mesh_evidence(std::ostream& stream, const MeshResult& result,
                         std::span<const ElementState> claims);

}  // namespace bezcert
