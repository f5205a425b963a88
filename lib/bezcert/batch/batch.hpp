// What floating point proves of many elements at once: most elements of most meshes.
//
// An element that comes out settled is injective, and every field of its Decision is known: the sign is
// proved by the "coefficients" of the whole domain, injectivity by the named proof, and the bounds of det J
// are the grid points (number/dyadic.hpp) that the exact extremes round to. All three are functions of the
// exact element: the same element decided with intervals or integers gives the same answer. What is not
// settled is open.
#pragma once

#include "bezcert/batch/block.hpp"
#include "bezcert/batch/table.hpp"
#include "bezcert/element/determinant_bounds.hpp"
#include "bezcert/verdict/element_verdict.hpp"

#include <span>

namespace bezcert::batch {

struct Settled {
  bool settled = false;
  DeterminantBounds bounds;
  InjectivityProof injectivity_proof = InjectivityProof::none;
};

/// Tries the elements whose nodes begin at the given places of the connectivity; results[i] answers for
/// first_node[i]. All have the table's shape and basis; weights are positive. Thread-safe.
void settle(const BlockTable& table, const Nodes& nodes, std::span<const std::size_t> first_node,
            std::span<Settled> results);

}  // namespace bezcert::batch
