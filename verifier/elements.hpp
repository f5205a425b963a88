// The elements file: ASCII Gmsh .msh 2.x and 4.1, and exact .bez.json (docs/formats.md).
#pragma once

#include "text.hpp"

#include <array>
#include <cstdint>

namespace verifier {

/// The elements file is malformed; `why` begins with the place, "12: ..." or " element 3: ...".
struct MalformedElements : Malformed {};

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
  /// `basis` and `numbers` are words of the certificate's header. Throws Malformed if they do not fit the
  /// kind of file, else MalformedElements, as element() does.
  Elements(std::string bytes, std::string_view basis, std::string_view numbers);
  Elements(const Elements&) = delete;
  Elements& operator=(const Elements&) = delete;

  std::size_t count() const { return shapes_.size(); }
  Element element(std::size_t i) const;
  int corner_count(std::size_t i) const { return shapes_[i].triangle ? 3 : 4; }
  /// Whether corners are one vertex by common nodes; else by equal points.
  bool glued_by_nodes() const { return glued_by_nodes_; }
  /// The places (in the file's list of points) of the element's points, in the order of Element.
  std::vector<std::uint32_t> nodes(std::size_t i) const;
  /// A bound of nodes.
  std::size_t node_count() const { return x_.size(); }
  bool lagrange(std::size_t i) const { return shapes_[i].lagrange; }

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
  bool glued_by_nodes_ = true, binary64_ = false, json_ = false;

  void read_msh(bool lagrange);
  void read_json();
};

/// The number of points, and the place of the point at column u of row v, in Element's order.
std::size_t point_count(bool triangle, std::size_t p, std::size_t q);
std::size_t point_place(bool triangle, std::size_t p, std::size_t u, std::size_t v);
/// Column and row of the k-th point of edge e, from its first corner (k = 0) to the next.
std::array<std::size_t, 2> along_edge(bool triangle, std::size_t p, std::size_t q, std::size_t e,
                                      std::size_t k);
/// Positions in Element's order of the points along edge e, from its first corner to the next.
std::vector<std::size_t> edge_positions(const Element& element, int e);

}  // namespace verifier
