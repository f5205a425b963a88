#include "bezcert/decide/decide.hpp"

#include "bezcert/decide/injectivity.hpp"

#include <cassert>

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

  void run() {
    visit(JacobianTree::root);
    for (std::size_t next = 0; next < open_.size() && !folded(); ++next) {
      const JacobianTree::Piece piece = open_[next];
      if (tree_.depth(piece) >= budget_.depth) {
        exhausted_ = "subdivision depth " + std::to_string(budget_.depth);
      } else if (!tree_.may_split(budget_.pieces)) {
        exhausted_ =
            tree_.piece_count() + 2 > budget_.pieces
                ? "subdivision pieces " + std::to_string(budget_.pieces)
                : "subdivision bits " + std::to_string(max_tree_bits) + " (the numbers are too long)";
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
  const std::string& exhausted() const { return exhausted_; }
  const JacobianTree& tree() const { return tree_; }

  // Cuts pieces whose smallest coefficient is 0 although N > 0 there, so that the lower bound says so too.
  // Precondition: det J > 0 is proved. Ends because the coefficients converge to N.
  void raise_lower_bound() {
    for (std::size_t i = 0; i < settled_.size() && tree_.may_split(budget_.pieces);) {
      if (sign(tree_.bounds(scope_, {&settled_[i], 1}).min_lower) > 0) {
        ++i;
        continue;
      }
      const auto [first, second] = tree_.split(settled_[i]);
      settled_[i] = first;
      settled_.push_back(second);
    }
  }

  DeterminantBounds bounds() {
    std::vector<JacobianTree::Piece> leaves(settled_);
    leaves.insert(leaves.end(), open_.begin() + static_cast<std::ptrdiff_t>(done_), open_.end());
    return tree_.bounds(scope_, leaves);
  }

 private:
  void visit(JacobianTree::Piece piece) {
    const PieceSigns signs = tree_.signs(scope_, piece);
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
    } else {
      open_.push_back(piece);
    }
  }

  const Budget& budget_;
  RoundingScope scope_;
  JacobianTree tree_;
  std::vector<JacobianTree::Piece> settled_;
  std::vector<JacobianTree::Piece> open_;  // in breadth-first order; the first done_ are split
  std::size_t done_ = 0;
  std::optional<CornerOfPiece> negative_, zero_, positive_;
  std::string exhausted_;
};

ElementVerdict verdict_of(const SignSearch& search) {
  if (search.folded()) return ElementVerdict::folded;
  if (!search.settled()) return ElementVerdict::undecided;
  if (search.negative()) return ElementVerdict::reversed;
  return search.zero() ? ElementVerdict::degenerate : ElementVerdict::regular;
}

// From regular to injective or overlapping, if a proof or an overlap is found.
void decide_injectivity(const Forms& forms, const Budget& budget, Decision& decision) {
  if (const auto proof = prove_injective(forms)) {
    decision.verdict = ElementVerdict::injective;
    decision.injectivity_proof = *proof;
    return;
  }
  BoundaryResult boundary = examine_boundary(forms, budget.boundary);
  switch (boundary.status) {
    case BoundaryStatus::simple:
      decision.verdict = ElementVerdict::injective;
      decision.injectivity_proof = "boundary";
      return;
    case BoundaryStatus::overlapping:
      decision.verdict = ElementVerdict::overlapping;
      decision.overlap = std::move(boundary.overlap);
      return;
    case BoundaryStatus::open:
      decision.open = "budget: " + boundary.exhausted + " (det J > 0, injectivity open)";
      return;
  }
}

}  // namespace

std::string_view name(ElementVerdict verdict) {
  switch (verdict) {
    case ElementVerdict::injective: return "injective";
    case ElementVerdict::regular: return "regular";
    case ElementVerdict::overlapping: return "overlapping";
    case ElementVerdict::degenerate: return "degenerate";
    case ElementVerdict::folded: return "folded";
    case ElementVerdict::reversed: return "reversed";
    case ElementVerdict::undecided: return "undecided";
  }
  return "";
}

bool is_regular(ElementVerdict verdict) {
  return verdict == ElementVerdict::injective || verdict == ElementVerdict::regular ||
         verdict == ElementVerdict::overlapping;
}

bool is_invalid(ElementVerdict verdict) {
  return verdict == ElementVerdict::overlapping || verdict == ElementVerdict::degenerate ||
         verdict == ElementVerdict::folded || verdict == ElementVerdict::reversed;
}

Decision decide(const Forms& forms, const Budget& budget) {
  SignSearch search(forms, budget);
  search.run();

  Decision decision;
  decision.verdict = verdict_of(search);
  decision.pieces = search.tree().piece_count();
  decision.bounds = search.bounds();
  if (decision.verdict == ElementVerdict::regular && sign(decision.bounds.min_lower) <= 0) {
    search.raise_lower_bound();
    decision.bounds = search.bounds();
  }
  decision.sign_proof = decision.pieces == 1 ? "coefficients" : "subdivision";
  const auto witness_at = [&](const CornerOfPiece& place, int expected) {
    Witness witness = make_witness(forms.element(), search.tree().corner(place.piece, place.corner));
    // Two independent computations of one sign: evidence that does not hold is never given out.
    if (sign(witness.determinant) != expected) throw std::logic_error("decide: a witness does not hold");
    return witness;
  };
  if (search.negative()) {
    decision.witness = witness_at(*search.negative(), -1);
  } else if (search.zero()) {
    decision.witness = witness_at(*search.zero(), 0);
  }
  if (decision.verdict == ElementVerdict::folded) {
    decision.other_witness =
        search.positive() ? witness_at(*search.positive(), 1) : witness_at(*search.zero(), 0);
  }
  if (decision.verdict == ElementVerdict::undecided) {
    decision.open = "budget: " + search.exhausted();
    if (search.negative()) decision.open += " (folded or reversed)";
  }
  if (decision.verdict == ElementVerdict::regular) decide_injectivity(forms, budget, decision);
  return decision;
}

}  // namespace bezcert
