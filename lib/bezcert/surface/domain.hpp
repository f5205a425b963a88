// Whether a mesh conforms to the input curves of its domain: each curve is covered exactly by consecutive
// mesh edges.
//
// From t = 0 on: a vertex lies at c(t); of the mesh edges that begin or end there, one is the same curve
// (same_curve.hpp) as c from t to some t' > t; then from t' on. The parameters t' where c passes an edge's
// other end are rational roots, found exactly; the part of c is made by blossoming. No tolerance anywhere.
#pragma once

#include "bezcert/curve/input_curve.hpp"
#include "bezcert/curve/distance.hpp"
#include "bezcert/surface/element_edge.hpp"

#include <optional>
#include <span>

namespace bezcert {

class Surface;

/// Why no edge covers a curve any further. All but the first: from a vertex on the curve.
enum class DomainCause {
  no_corner,             ///< no element has a corner there
  other_way,             ///< `edge` ends on the curve, but is not that part of it: `distance`
  ends_inside_edge,      ///< the curve ends at `end`, inside `edge`
  irrational_parameter,  ///< `edge` ends on the curve, but at an irrational parameter
  no_edge                ///< no edge leads to another point of the curve
};

/// Where the coverage of a curve stops.
struct DomainFailure {
  std::size_t curve = 0;                ///< its place among the input curves
  std::string curve_name;               ///< empty if it has none
  Rational parameter = 0;               ///< covered from 0 to there
  Point point;                          ///< the curve's point there
  std::vector<std::uint32_t> nodes;     ///< vertices at that point (empty if glued by points, or none)
  std::vector<std::uint32_t> elements;  ///< that have a corner there
  DomainCause cause = DomainCause::no_corner;
  ElementEdge edge;
  bool forward = true;                     ///< whether `edge` begins there, rather than ends
  std::optional<DistanceBounds> distance;  ///< largest at equal parameters
  Point end;
};

struct DomainResult {
  std::size_t curves = 0;
  std::size_t covered = 0;
  std::vector<DomainFailure> failures;

  bool conforming() const { return covered == curves; }
};

/// Of a mesh that need not be an embedding.
DomainResult check_domain(const Surface& surface, std::span<const InputCurve> curves);

}  // namespace bezcert
