// Binary subdivisions that prove the sign of a polynomial, as certificates hold them
// (docs/certificate-format.md, "SIGN"): depth first, a cut written before what is in its two parts.
//
// The search ends where the Bernstein coefficients prove the sign, or with its limits: on a zero of the
// polynomial that is no corner of any piece subdivision never ends, and a path to the largest depth is all
// that it costs.
#pragma once

#include "bezcert/algebra/bivariate.hpp"
#include "bezcert/element/forms.hpp"

#include <optional>
#include <string>

namespace bezcert {

/// What is to be shown of a polynomial on a closed domain: > 0 or >= 0.
enum class Strictness { strict, weak };

/// Limits of a search: counts, so that results do not depend on the machine.
struct TreeLimits {
  std::size_t pieces = 4096;  ///< cut or not
  int depth = 128;
  /// Additions of 64-bit words while pieces are cut.
  std::size_t work = std::size_t{1} << 31;
};

/// Half of what a checker takes ("Limits").
inline constexpr std::size_t max_tree_pieces = std::size_t{1} << 15;
inline constexpr int max_tree_depth = 256;

/// A positive multiple of the Bernstein coefficients in f's own total degree (triangle), or its degrees in u
/// and in v (square). Precondition: f is not 0.
Polynomial<Integer> to_bernstein(const Bivariate& f, Domain domain);

/// Whether the coefficients alone show the sign.
bool coefficients_show(const Polynomial<Integer>& f, Strictness wanted);

/// The splits of a subdivision whose leaves show the sign of f: "1" for a cut, "0" for a leaf, in preorder;
/// "0" alone if the coefficients do. Nothing if the limits are met first or f has another sign at a corner.
std::optional<std::string> sign_tree(const Polynomial<Integer>& f, Strictness wanted, TreeLimits limits = {});

/// The same for N (direction 1) or -N (direction -1) of an element; intervals are tried before integers.
std::optional<std::string> sign_tree(const Forms& forms, int direction, Strictness wanted,
                                     TreeLimits limits = {});

/// Whether halving the square across v alone shows f > 0 on it, by at most `pieces` pieces.
bool positive_by_rows(const Polynomial<Integer>& f, std::size_t pieces = 2048);

/// Whether halving [0, 1] shows f > 0 on it, by at most `pieces` pieces. Precondition: f is not 0.
bool positive_on_segment(const Univariate& f, std::size_t pieces = 2048);

}  // namespace bezcert
