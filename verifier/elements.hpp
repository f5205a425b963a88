// The elements file: ASCII Gmsh .msh 2.x and 4.1, and exact .bez.json (docs/formats.md).
#pragma once

#include "text.hpp"

#include <cstdint>

namespace verifier {

/// One element as the file gives it. Point i is (x[i] / unit, y[i] / unit), unit > 0; its weight is w[i] > 0
/// times a positive number common to all of them (all 1 if not rational). Order (formats.md): triangle rows r
/// = 0..n of columns c = 0..n-r; quadrilateral rows r = 0..q along v of columns c = 0..p along u.
struct Element {
  bool triangle;
  int p, q;       ///< degrees in u and v, 1 to 64; p = q = n for triangles
  bool lagrange;  ///< points are equispaced nodes, else control points
  bool rational;  ///< weights are not all equal
  std::vector<mpz_class> x, y, w;
  mpz_class unit;
};

/// A file read whole; numbers stay texts in it until an element is asked for.
class Elements {
 public:
  /// `basis` and `numbers` are words of the certificate's header. Throws Malformed, as element() does.
  Elements(std::string bytes, std::string_view basis, std::string_view numbers);
  Elements(const Elements&) = delete;

  std::size_t count() const { return shapes_.size(); }
  Element element(std::size_t i) const;
  int corner_count(std::size_t i) const { return shapes_[i].triangle ? 3 : 4; }
  bool lagrange(std::size_t i) const { return shapes_[i].lagrange; }
  /// Whether corners are one vertex by common nodes; else by equal points.
  bool glued_by_nodes() const { return glued_by_nodes_; }
  /// The places (in the file's list of points) of the element's points, in the order of Element.
  std::vector<std::uint32_t> nodes(std::size_t i) const;

 private:
  struct Shape {
    bool triangle, lagrange;
    std::uint16_t p, q;
    std::size_t first;  ///< in nodes_
  };
  std::string bytes_;
  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::string_view> x_, y_, w_;  ///< w_ may be empty: all 1
  bool glued_by_nodes_ = true, binary64_, json_;

  void read_msh(bool lagrange);
  void read_json();
};

std::size_t point_count(bool triangle, std::size_t p, std::size_t q);
/// The place, in Element's order, of the k-th point of edge e, from its first corner on, of the `ring`-th
/// ring of points (0: the boundary).
std::size_t edge_place(bool triangle, std::size_t p, std::size_t q, std::size_t e, std::size_t k,
                       std::size_t ring = 0);
/// The places of all points of edge e, from its first corner to the next.
std::vector<std::size_t> edge_positions(const Element& element, int e);

}  // namespace verifier
