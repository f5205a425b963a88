#include "bezcert/decide/decide.hpp"

#include "bezcert/decide/algebraic.hpp"
#include "bezcert/decide/boundary.hpp"
#include "bezcert/decide/injectivity.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <algorithm>

namespace bezcert {
namespace {

struct CornerOfPiece {
  JacobianTree::Piece piece = 0;
  std::size_t corner = 0;
};

// Breadth-first subdivision that collects the signs of N.
class SignSearch {
 public:
  SignSearch(const Forms& forms, const Budget& budget) : budget_(budget), tree_(forms) {}

  // Goes on up to `pieces` pieces in all.
  void run(std::size_t pieces) {
    if (tree_.piece_count() == 1 && open_.empty() && settled_.empty()) visit(JacobianTree::root);
    while (done_ < open_.size() && !folded()) {
      const JacobianTree::Piece piece = open_[done_];
      if (tree_.depth(piece) >= budget_.depth) {
        exhausted_ = {ExhaustedBudget::Limit::depth, static_cast<std::size_t>(budget_.depth)};
      } else if (!tree_.may_split(pieces)) {
        exhausted_ = tree_.piece_count() + 2 > pieces
                         ? ExhaustedBudget{ExhaustedBudget::Limit::pieces, pieces}
                         : ExhaustedBudget{ExhaustedBudget::Limit::memory_bits, max_tree_bits};
      } else {
        const auto [first, second] = tree_.split(piece);
        visit(first);
        visit(second);
        ++done_;
        continue;
      }
      break;
    }
  }

  bool settled() const { return done_ == open_.size(); }
  bool folded() const { return negative_ && (zero_ || positive_); }
  const std::optional<CornerOfPiece>& negative() const { return negative_; }
  const std::optional<CornerOfPiece>& zero() const { return zero_; }
  const std::optional<CornerOfPiece>& positive() const { return positive_; }
  /// Precondition: not settled.
  const ExhaustedBudget& exhausted() const { return exhausted_; }
  const JacobianTree& tree() const { return tree_; }

  // Cuts pieces whose smallest coefficient is 0 although N > 0 there, so that the lower bound says so too.
  // Precondition: det J > 0 is proved. Ends because the coefficients converge to N.
  void raise_lower_bound() {
    for (std::size_t i = 0; i < settled_.size() && tree_.may_split(budget_.pieces);) {
      if (sign(tree_.bounds({&settled_[i], 1}).min_lower) > 0) {
        ++i;
        continue;
      }
      const auto [first, second] = tree_.split(settled_[i]);
      settled_[i] = first;
      settled_.push_back(second);
    }
  }

  // The ranges of a coordinate (0: u, 1: v) of the pieces where N may vanish.
  Strips strips(std::size_t coordinate) const {
    Strips result;
    const auto add = [&](JacobianTree::Piece piece) {
      Rational lower = tree_.corner(piece, 0).affine()[coordinate], upper = lower;
      for (std::size_t k = 1; k < tree_.corner_count(); ++k) {
        const Rational x = tree_.corner(piece, k).affine()[coordinate];
        lower = std::min(lower, x);
        upper = std::max(upper, x);
      }
      result.emplace_back(lower, upper);
    };
    for (const JacobianTree::Piece piece : with_zero_) add(piece);
    for (std::size_t i = done_; i < open_.size(); ++i) add(open_[i]);
    return merged(std::move(result));
  }

  DeterminantBounds bounds() {
    std::vector<JacobianTree::Piece> leaves(settled_);
    leaves.insert(leaves.end(), open_.begin() + static_cast<std::ptrdiff_t>(done_), open_.end());
    return tree_.bounds(leaves);
  }

 private:
  void visit(JacobianTree::Piece piece) {
    const PieceSigns signs = tree_.signs(piece);
    bool corner_is_zero = false;
    for (std::size_t k = 0; k < tree_.corner_count(); ++k) {
      auto& slot = signs.corner[k] < 0 ? negative_ : signs.corner[k] == 0 ? zero_ : positive_;
      if (!slot) slot = CornerOfPiece{piece, k};
      corner_is_zero |= signs.corner[k] == 0;
    }
    // A piece is settled if the signs met at its corners are the signs of N on it, as far as the verdict
    // asks: coefficients of one strict sign at the corners leave only that sign; coefficients >= 0 with a
    // zero corner leave 0 and perhaps +, which is degenerate either way; coefficients <= 0 leave 0 and -,
    // where the - must have been met.
    const bool strict = tree_.proves_positive(signs) || tree_.proves_negative(signs);
    const bool weak = corner_is_zero && (signs.none_negative || (signs.none_positive && negative_));
    if (strict || weak) {
      settled_.push_back(piece);
      if (!strict) with_zero_.push_back(piece);
    } else {
      open_.push_back(piece);
    }
  }

  const Budget& budget_;
  JacobianTree tree_;
  std::vector<JacobianTree::Piece> settled_;
  std::vector<JacobianTree::Piece> with_zero_;  // those settled ones where N vanishes
  std::vector<JacobianTree::Piece> open_;       // in breadth-first order; the first done_ are split
  std::size_t done_ = 0;
  std::optional<CornerOfPiece> negative_, zero_, positive_;
  ExhaustedBudget exhausted_;
};

ElementVerdict verdict_of(const SignSearch& search) {
  if (search.folded()) return ElementVerdict::folded;
  if (!search.settled()) return ElementVerdict::undecided;
  if (search.negative()) return ElementVerdict::reversed;
  return search.zero() ? ElementVerdict::degenerate : ElementVerdict::regular;
}

// Two independent computations of one sign: evidence that does not hold is never given out.
Witness checked_witness(const Forms& forms, Parameter parameter, int expected) {
  Witness witness = make_witness(forms.exact(), std::move(parameter));
  if (sign(witness.determinant) != expected || !witness.parameter.is_inside()) {
    throw std::logic_error("decide: a witness does not hold");
  }
  return witness;
}

// The pieces that are looked at before algebra is asked: most elements are settled by a handful, and where N
// touches zero more of them do not help.
constexpr std::size_t pieces_before_algebra = 512;

// A strict sign that N takes: one met at a corner, else anywhere on a grid that is fine enough for N's
// degree.
int some_sign(const SignSearch& search, const Polynomial<Integer>& n) {
  if (search.negative()) return -1;
  if (search.positive()) return 1;
  return some_sign(to_power_basis(n));
}

// What subdivision left open, or the dimension of the zero set where it did not.
void decide_by_algebra(const Forms& forms, const Budget& budget, const SignSearch& search,
                       Decision& decision) {
  const Polynomial<Integer>& n = forms.exact_jacobian().numerator;
  const bool open = decision.verdict == ElementVerdict::undecided;
  if (std::all_of(n.coefficients.begin(), n.coefficients.end(),
                  [](const Integer& c) { return c.is_zero(); })) {
    const RealRoot third = rational_root(Rational(1, 3));
    decision.zero = AlgebraicZero{{third, third}, 2};
    return;
  }
  const int met = some_sign(search, n);
  AlgebraicSigns signs = algebraic_signs(n, -met, search.strips(0), search.strips(1), budget.algebra_bits);
  if (signs.exhausted) {
    decision.exhausted = {*signs.exhausted};
    return;
  }
  decision.zero = std::move(signs.zero);
  if (!open) return;
  decision.sign_proof = SignProof::algebra;
  const auto witness_at = [&](const std::array<Rational, 2>& uv, int expected) {
    return checked_witness(forms, Parameter::at(n.shape.domain, {uv[0], uv[1]}), expected);
  };
  if (signs.opposite) {
    decision.verdict = ElementVerdict::folded;
    (met > 0 ? decision.witness : decision.other_witness) = witness_at(*signs.opposite, -met);
  } else if (!decision.zero) {
    decision.verdict = met > 0 ? ElementVerdict::regular : ElementVerdict::reversed;
  } else if (met > 0) {
    decision.verdict = ElementVerdict::degenerate;
    const PlanarPoint& at = decision.zero->at;
    if (at.is_rational() && !decision.witness) decision.witness = witness_at({at.u.lower, at.v.lower}, 0);
  } else {
    // det J <= 0 with a zero: negative somewhere, not everywhere.
    decision.verdict = ElementVerdict::folded;
    const PlanarPoint& at = decision.zero->at;
    if (at.is_rational() && !decision.other_witness) {
      decision.other_witness = witness_at({at.u.lower, at.v.lower}, 0);
    }
  }
}

// Dyadic witnesses that the subdivision met, where algebra has not given others.
void add_witnesses(const Forms& forms, const SignSearch& search, Decision& decision) {
  const auto witness_at = [&](const CornerOfPiece& place, int expected) {
    return checked_witness(forms, search.tree().corner(place.piece, place.corner), expected);
  };
  if (!decision.witness && search.negative()) decision.witness = witness_at(*search.negative(), -1);
  if (!decision.witness && search.zero() && decision.verdict != ElementVerdict::regular) {
    decision.witness = witness_at(*search.zero(), 0);
  }
  if (decision.verdict == ElementVerdict::folded && !decision.other_witness) {
    if (search.positive()) {
      decision.other_witness = witness_at(*search.positive(), 1);
    } else if (search.zero()) {
      decision.other_witness = witness_at(*search.zero(), 0);
    }
  }
}

PlanarPoint point_of(const Parameter& parameter) {
  const std::vector<Rational> uv = parameter.affine();
  return {rational_root(uv[0]), rational_root(uv[1])};
}

// The zero set of a degenerate element. A zero at a corner of a piece is the better evidence.
void describe_zeros(const Forms& forms, const Budget& budget, const SignSearch& search, Decision& decision) {
  if (!decision.zero && budget.algebra_bits > 0) {
    decide_by_algebra(forms, budget, search, decision);
    decision.exhausted.clear();  // the verdict is not open
  }
  if (decision.zero && decision.witness) decision.zero->at = point_of(decision.witness->parameter);
  if (!decision.zero) decision.zero = AlgebraicZero{point_of(decision.witness->parameter), -1};
}

// The bounds of the subdivision, with what algebra knows.
void tighten(Decision& decision) {
  DeterminantBounds& bounds = decision.bounds;
  const Dyadic zero{};
  switch (decision.verdict) {
    case ElementVerdict::regular:
      if (sign(bounds.min_lower) < 0) bounds.min_lower = zero;
      break;
    case ElementVerdict::degenerate: bounds.min_lower = bounds.min_upper = zero; break;
    case ElementVerdict::reversed:
      if (sign(bounds.max_upper) > 0) bounds.max_upper = zero;
      break;
    default: break;
  }
  if (decision.witness && decision.witness->determinant < to_rational(bounds.min_upper)) {
    bounds.min_upper = round_up(decision.witness->determinant);
  }
}

// From regular to injective or overlapping, if a proof or an overlap is found.
void decide_injectivity(const Forms& forms, const Budget& budget, Decision& decision) {
  decision.injectivity_proof = prove_injective(forms);
  if (decision.injectivity_proof != InjectivityProof::none) {
    decision.verdict = ElementVerdict::injective;
    return;
  }
  BoundaryResult boundary = examine_boundary(forms, budget.contact);
  switch (boundary.status) {
    case BoundaryStatus::simple:
      decision.verdict = ElementVerdict::injective;
      decision.injectivity_proof = InjectivityProof::boundary;
      return;
    case BoundaryStatus::overlapping:
      decision.verdict = ElementVerdict::overlapping;
      decision.overlap = std::move(boundary.overlap);
      return;
    case BoundaryStatus::open: decision.exhausted = {*boundary.exhausted}; return;
  }
}

}  // namespace

Decision decide(const Element& element, const Budget& budget) { return decide(Forms(element), budget); }

Decision decide(const Forms& forms, const Budget& budget) {
  SignSearch search(forms, budget);
  Decision decision;
  search.run(std::min(budget.pieces, pieces_before_algebra));
  decision.verdict = verdict_of(search);
  if (decision.verdict == ElementVerdict::undecided && budget.algebra_bits > 0) {
    decide_by_algebra(forms, budget, search, decision);
  }
  if (decision.verdict == ElementVerdict::undecided) {
    search.run(budget.pieces);
    decision.verdict = verdict_of(search);
  }
  decision.pieces = search.tree().piece_count();
  if (decision.sign_proof != SignProof::algebra && decision.pieces > 1)
    decision.sign_proof = SignProof::subdivision;
  decision.bounds = search.bounds();
  if (decision.verdict == ElementVerdict::regular && sign(decision.bounds.min_lower) <= 0) {
    search.raise_lower_bound();
    decision.bounds = search.bounds();
  }
  add_witnesses(forms, search, decision);
  if (decision.verdict == ElementVerdict::undecided) {
    decision.exhausted.insert(decision.exhausted.begin(), search.exhausted());
  } else {
    decision.exhausted.clear();  // what algebra could not tell, more pieces did
  }
  if (decision.verdict == ElementVerdict::degenerate) describe_zeros(forms, budget, search, decision);
  tighten(decision);
  if (decision.verdict == ElementVerdict::regular) decide_injectivity(forms, budget, decision);
  return decision;
}

}  // namespace bezcert
