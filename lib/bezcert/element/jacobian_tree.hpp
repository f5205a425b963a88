// The Jacobian numerator on a binary subdivision of the domain: intervals first, exact when asked.
//
// A piece is a triangle cut from its parent through the middle of one side (newest vertex bisection: four
// congruence classes, no thin pieces), or a rectangle halved alternately in u and in v. Corners of pieces
// are dyadic parameters. On a piece, with the Bernstein coefficients C of N over that piece:
//   all C >= 0 and the corner ones > 0   =>  N > 0 on the closed piece,
// because N >= corner coefficients times their basis functions, and at every point of the piece at least
// one corner basis function is positive. With signs exchanged, N < 0.
// All signs and bounds here are functions of the exact coefficients; intervals only save the work.
#pragma once

#include "bezcert/element/determinant_bounds.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/element/parameter.hpp"

#include <array>
#include <deque>
#include <optional>
#include <span>

namespace bezcert {

/// Exact signs of the coefficients of N on one piece.
struct PieceSigns {
  bool none_negative = false;                            ///< every coefficient is >= 0
  bool none_positive = false;                            ///< every coefficient is <= 0
  std::array<signed char, 1 << max_dimension> corner{};  ///< sign at each corner; the rest unused
};

/// N and W on one piece. The coefficients are those of the whole domain's scale times 2^shift: integers are
/// not divided when a piece is cut.
template <class T>
struct PieceForm : JacobianForm<T> {
  int numerator_shift = 0;
  int weight_shift = 0;
};

/// Bits that the exact coefficients of one tree may take (128 MiB): numbers with huge exponents are cut short
/// by this.
inline constexpr std::size_t max_tree_bits = std::size_t{1} << 30;

class JacobianTree {
 public:
  using Piece = std::size_t;

  /// The tree of one piece, the whole domain. Keeps a reference to `forms`.
  explicit JacobianTree(const Forms& forms);

  static constexpr Piece root = 0;
  std::size_t piece_count() const { return nodes_.size(); }
  std::size_t corner_count() const { return corner_count_; }
  int depth(Piece piece) const { return nodes_[piece].depth; }
  /// Whether two more pieces stay within `limit` pieces and within `max_tree_bits`, estimated from the exact
  /// coefficients of the whole domain: a function of the element alone, whether or not they were needed so
  /// far.
  bool may_split(std::size_t limit);

  /// Cuts a piece in two; the children are the two last pieces, in the order of the header.
  std::pair<Piece, Piece> split(Piece piece);

  /// The exact signs of the coefficients on a piece.
  PieceSigns signs(Piece piece);

  /// Whether `signs` proves det J > 0 (or < 0) on the whole closed piece.
  bool proves_positive(const PieceSigns& signs) const;
  bool proves_negative(const PieceSigns& signs) const;

  /// The parameter of a corner of a piece, exactly.
  Parameter corner(Piece piece, std::size_t corner) const;

  /// Bounds of det J over the union of the given pieces, rounded outwards to `bits` bits (outward.hpp).
  /// Precondition: `pieces` is not empty.
  DeterminantBounds bounds(std::span<const Piece> pieces, int bits = report_bits);

 private:
  struct Node {
    Piece parent = 0;
    int depth = 0;
    bool second = false;  // which child of its parent
    std::optional<PieceForm<Interval>> interval;
    std::optional<PieceForm<Integer>> exact;
  };
  template <class T>
  struct Extremes;

  template <class T>
  static std::optional<PieceForm<T>>& slot(Node& node);
  // Witness: a RoundUp for intervals, nothing for integers.
  template <class T, class... Witness>
  const PieceForm<T>& form(Piece piece, const Witness&... up);
  template <class T, class... Witness>
  Extremes<T> extremes(std::span<const Piece> pieces, const Witness&... up);

  const Forms& forms_;
  std::size_t corner_count_;
  std::vector<std::size_t> corners_;  // positions of the corner coefficients of N
  std::deque<Node> nodes_;
  std::size_t affordable_pieces_ = 0;  // 0: not known yet
};

}  // namespace bezcert
