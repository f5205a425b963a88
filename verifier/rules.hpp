// The rules of docs/certificate-format.md. Every check reads its evidence and throws Rejected or Malformed.
#pragma once

#include "map.hpp"

#include <functional>

namespace verifier {

enum class Claim { injective, regular, overlapping, degenerate, folded, reversed, invalid, undecided };

/// The claim that `tokens` (after the position) make of the element.
Claim check_element(const Element& element, Tokens& tokens);

/// The mesh's claim: `line` begins after the word `mesh`; `next_line` gives the lines after it, the last one
/// is "end". Returns the words of the claim ("embedding", "refuted cover", ...). `claims`: of all elements.
std::string check_mesh(const Elements& elements, const std::vector<Claim>& claims, Tokens& line,
                       const std::function<std::string_view()>& next_line);
/// What follows `refuted`; its first word is returned.
std::string check_refutation(const Elements& elements, const std::vector<Claim>& claims, Tokens& line);

/// SIGN: f > 0, or f >= 0 if not strict, on the triangle or square. `degree` is for `coefficients` and
/// `tree`; a factor of `factors` has no `factors` itself.
void check_sign(Tokens& tokens, const Polynomial2& f, bool triangle, std::array<int, 2> degree, bool strict,
                bool factors = true);

/// x in `at` and `root`: the roots of m in [low, high], of which there is one; if m = 0, any number.
struct Root {
  Polynomial m{};
  mpq_class low = 0, high = 0;

  Root() = default;
  /// Reads `at`, or `root` POLY RAT RAT.
  explicit Root(Tokens& tokens);
  /// Reads a parameter, as a function of x: a RAT if m = 0, else a RATPOLY.
  RationalPolynomial parameter(Tokens& tokens) const;
  /// Whether f(x) is 0, >= 0, > 0.
  bool zero(const Polynomial& f) const;
  bool not_negative(const Polynomial& f) const;
  bool positive(const Polynomial& f) const;
};

/// Common end points that are no contact.
struct Joints {
  bool end_to_begin = false;  ///< a ends where b begins
  bool begin_to_end = false;  ///< a begins where b ends
};
/// PAIR: a and b meet at the joints only.
void check_pair(Tokens& tokens, const Curve& a, const Curve& b, Joints joints, int depth = 0);
/// INJECTIVE `boundary`, of an element's edges.
void check_boundary(Tokens& tokens, const std::vector<Curve>& edges);

/// Two edges, and which of their ends are one point of the domain: common[i][j]: end i of the first (0: t =
/// 0, 1: t = 1) with end j of the second.
struct MeetingEdges {
  Curve first, second;
  bool same = false;
  bool common[2][2] = {{false, false}, {false, false}};
};
/// MEET; edges are numbers (element 0) or, if `in_mesh`, EDGEs, and `find` looks them up.
void check_meet(Tokens& tokens, bool in_mesh,
                const std::function<MeetingEdges(const EdgeName&, const EdgeName&)>& find);

}  // namespace verifier
