// Evidence that a mesh is no embedding, or not conforming: one of the refutations of certificates
// (docs/certificate-format.md).
//
// The obstacles of examine_mesh say where to look; what is written is found anew from the edges they name,
// and checked as the verifier will: a point that two elements cover, two places of the surface with one
// image, a vertex whose elements fall apart, or edges that are close to each other and yet different.
#pragma once

#include "bezcert/surface/embedding.hpp"

#include <optional>
#include <span>
#include <string>

namespace bezcert {

/// What follows `mesh refuted`: of the first obstacle that has any. `claims`: what the certificate claims of
/// each element.
std::optional<std::string> find_refutation(const MeshResult& result, std::span<const ElementState> claims);

}  // namespace bezcert
