// Whether a mesh conforms to the input curves of its domain: each curve is covered exactly by consecutive
// mesh edges.
//
// From t = 0 on: a vertex lies at c(t); of the mesh edges that begin or end there, one is the same curve
// (same_curve.hpp) as c from t to some t' > t; then from t' on. The parameters t' where c passes an edge's
// other end are rational roots, found exactly; the part of c is made by blossoming. No tolerance anywhere.
#pragma once

#include "bezcert/mesh/gluing.hpp"
#include "bezcert/mesh/input_curve.hpp"

#include <span>

namespace bezcert {

/// Where the coverage of a curve stops.
struct DomainFailure {
  std::size_t curve = 0;                ///< its place among the input curves
  std::string curve_name;               ///< empty if it has none
  Rational parameter = 0;               ///< covered from 0 to there
  Point point;                          ///< the curve's point there
  std::vector<std::uint32_t> nodes;     ///< vertices at that point (empty if glued by points, or none)
  std::vector<std::uint32_t> elements;  ///< that have a corner there
  std::string message;
};

struct DomainResult {
  std::size_t curves = 0;
  std::size_t covered = 0;
  std::vector<DomainFailure> failures;

  bool conforming() const { return covered == curves; }
};

/// Of a mesh that need not be an embedding.
DomainResult check_domain(const Mesh& mesh, std::span<const InputCurve> curves);

}  // namespace bezcert
