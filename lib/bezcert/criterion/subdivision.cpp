#include "bezcert/criterion/subdivision.hpp"

#include "bezcert/criterion/coefficients.hpp"
#include "bezcert/element/forms.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

// Bits of the rounded bounds: the rounding may take a sixteenth of the width asked for.
int bits_for(const Rational& width) {
  int bits = report_bits;
  while (bits < 40 && power_of_two(4 - bits) > width) ++bits;
  return bits;
}

struct Leaf {
  JacobianTree::Piece piece = 0;
  bool positive = false;
  Rational min_lower, min_upper, max_lower, max_upper;
};

struct Extent {
  Rational min_lower, min_upper, max_lower, max_upper;

  explicit Extent(const std::vector<Leaf>& leaves)
      : min_lower(leaves[0].min_lower),
        min_upper(leaves[0].min_upper),
        max_lower(leaves[0].max_lower),
        max_upper(leaves[0].max_upper) {
    for (const Leaf& leaf : leaves) {
      min_lower = std::min(min_lower, leaf.min_lower);
      min_upper = std::min(min_upper, leaf.min_upper);
      max_lower = std::max(max_lower, leaf.max_lower);
      max_upper = std::max(max_upper, leaf.max_upper);
    }
  }
};

class Search {
 public:
  Search(const Forms& forms, const SubdivisionOptions& options)
      : options_(options), bits_(bits_for(options.relative_width)), tree_(forms) {
    add(JacobianTree::root);
  }

  // Splits until the sign is settled and the bounds are narrow, or the budget is spent.
  void run() {
    while (tree_.may_split(options_.pieces + 1)) {
      const std::optional<std::size_t> next = choose();
      if (!next) return;
      const JacobianTree::Piece piece = leaves_[*next].piece;
      leaves_.erase(leaves_.begin() + static_cast<std::ptrdiff_t>(*next));
      const auto [first, second] = tree_.split(piece);
      add(first);
      add(second);
    }
  }

  bool proved() const {
    return std::all_of(leaves_.begin(), leaves_.end(), [](const Leaf& leaf) { return leaf.positive; });
  }
  const std::optional<Parameter>& witness() const { return witness_; }

  DeterminantBounds bounds() {
    std::vector<JacobianTree::Piece> pieces;
    for (const Leaf& leaf : leaves_) pieces.push_back(leaf.piece);
    return tree_.bounds(pieces, bits_);
  }

 private:
  void add(JacobianTree::Piece piece) {
    const PieceSigns signs = tree_.signs(piece);
    for (std::size_t k = 0; k < tree_.corner_count() && !witness_; ++k) {
      if (signs.corner[k] <= 0) witness_ = tree_.corner(piece, k);
    }
    const DeterminantBounds bounds = tree_.bounds({&piece, 1}, bits_);
    leaves_.push_back({piece, tree_.proves_positive(signs), to_rational(bounds.min_lower),
                       to_rational(bounds.min_upper), to_rational(bounds.max_lower),
                       to_rational(bounds.max_upper)});
  }

  // The leaf to split next: while the sign is open the lowest one that is not proved; then the one that
  // holds the wider of the two bounds open. Ties go to the older leaf.
  std::optional<std::size_t> choose() const {
    std::optional<std::size_t> best;
    if (!witness_) {
      for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (!leaves_[i].positive && (!best || leaves_[i].min_lower < leaves_[*best].min_lower)) best = i;
      }
      if (best) return best;
    }
    const Extent extent(leaves_);
    const Rational largest = std::max(abs(extent.min_upper), abs(extent.max_lower));
    const Rational width = options_.relative_width * largest;
    if (extent.min_upper - extent.min_lower > width) {
      for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (leaves_[i].min_lower == extent.min_lower) return i;
      }
    }
    if (extent.max_upper - extent.max_lower > width) {
      for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (leaves_[i].max_upper == extent.max_upper) return i;
      }
    }
    return std::nullopt;
  }

  const SubdivisionOptions& options_;
  int bits_;
  JacobianTree tree_;
  std::vector<Leaf> leaves_;
  std::optional<Parameter> witness_;
};

}  // namespace

Verdict subdivision(const Forms& forms, const SubdivisionOptions& options) {
  if (options.relative_width <= 0) throw std::invalid_argument("subdivision: the width must be positive");
  Verdict verdict = begin_verdict(subdivision_info, Status::inconclusive);
  Search search(forms, options);
  search.run();
  verdict.bounds = search.bounds();
  if (search.witness()) {
    verdict.status = Status::refuted;
    verdict.witness = make_witness(forms.exact(), *search.witness());
    verdict.reason = "det J <= 0 at " + to_string(verdict.witness->parameter);
  } else if (search.proved()) {
    verdict.status = Status::proved;
  } else {
    verdict.reason =
        "the budget of " + std::to_string(options.pieces) + " pieces, or of memory for them, ran out";
  }
  return verdict;
}

std::optional<Status> quick_subdivision(const QuickNet& net) {
  const std::optional<Status> status = quick_coefficients(net);
  return status == Status::inconclusive ? std::nullopt : status;
}

}  // namespace bezcert
