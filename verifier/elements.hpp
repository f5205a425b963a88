// The elements file: ASCII Gmsh .msh 2.x and 4.1, and exact .bez.json (docs/formats.md).
#pragma once

#include "polynomial.hpp"

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
  Integers x, y, w;
  mpz_class unit;
};

/// The place, in Element's order, of the k-th point of edge e, from its first corner on, of the `ring`-th
/// ring of points (0: the boundary).
std::size_t edge_place(bool triangle, std::size_t p, std::size_t q, std::size_t e, std::size_t k,
                       std::size_t ring = 0);

/// A file read whole. Exact numbers stay texts until an element is asked for.
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
  bool is_glued_by_nodes() const { return glued_by_nodes_; }
  std::size_t edge_degree(std::size_t i, std::size_t e) const {
    return e % 2 == 0 ? shapes_[i].p : shapes_[i].q;
  }
  /// The place, in the file's list of points, of the k-th point of edge e, from its first corner on.
  std::uint32_t edge_node(std::size_t i, std::size_t e, std::size_t k) const {
    return nodes_[shapes_[i].first + edge_place(shapes_[i].triangle, shapes_[i].p, shapes_[i].q, e, k)];
  }

 private:
  struct Shape {
    bool triangle, lagrange;
    std::uint16_t p, q;
    std::size_t first;  ///< in nodes_
  };
  std::string bytes_;
  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> nodes_;
  struct Column {  ///< of points: either
    std::vector<double> doubles;
    std::vector<std::string_view> texts;
  } x_, y_, w_;  ///< w_ may be empty: all 1
  bool glued_by_nodes_ = true, binary64_, json_;

  void read_msh(bool lagrange);
  void read_json();
  /// Appends the columns' numbers at the element's points as integers, all times the number that is returned.
  mpz_class scaled(std::initializer_list<const Column*> columns, std::size_t i, Integers& all) const;
};

/// SHA-256 in lower-case hex.
std::string sha256(std::string_view bytes);

}  // namespace verifier
