// Points that elements cover: the refutation `cover` of certificates.
//
// An injective element covers a point in its interior if and only if its boundary runs around it once
// (curve/winding.hpp). Points are looked for beside edges and near vertices, nearer and nearer, and are given
// by short rationals.
#pragma once

#include "bezcert/surface/embedding.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace bezcert {

/// Whether halving tells, within the limits of a verifier, that the point is not on the curve.
bool is_off(const CurveNet<Integer>& curve, const Point& point);

class Coverage {
 public:
  /// `claims`: elements that are not claimed to be injective cover nothing. Keeps references.
  Coverage(const HalfEdges& edges, std::span<const ElementState> claims) : edges_(edges), claims_(claims) {}

  /// Whether the element is injective and has the point in its interior, by winding numbers within the limits
  /// of a verifier.
  bool covers(std::uint32_t element, const Point& point) const;

  /// `cover` by the elements of two half-edges that run in one direction along one curve.
  std::optional<std::string> beside_edge(HalfEdge a, HalfEdge b) const;
  /// `cover` by two elements of a fan that turns too far around its vertex.
  std::optional<std::string> around_vertex(const Fan& fan) const;
  /// `cover` by the element and any other one.
  std::optional<std::string> with_any(std::uint32_t element) const;

 private:
  /// Points beside the middle of a half-edge, on its left, nearer and nearer, until one is accepted.
  std::optional<Point> left_of(HalfEdge h, const std::function<bool(const Point&)>& accepts) const;
  std::optional<std::string> in_sliver(HalfEdge leaving, HalfEdge arriving) const;

  const HalfEdges& edges_;
  std::span<const ElementState> claims_;
};

}  // namespace bezcert
