#include "bezcert/element/jacobian_tree.hpp"

#include "bezcert/element/bisect.hpp"
#include "bezcert/number/outward.hpp"

#include <algorithm>
#include <type_traits>

namespace bezcert {
namespace {

// Exact signs from intervals where they say enough: one coefficient of each sign settles both flags, the
// corners must all be certain.
std::optional<PieceSigns> certain_signs(const std::vector<Interval>& coefficients,
                                        const std::vector<std::size_t>& corners) {
  PieceSigns result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto corner = certain_sign(coefficients[corners[k]]);
    if (!corner) return std::nullopt;
    result.corner[k] = static_cast<signed char>(*corner);
  }
  bool negative = false;
  bool positive = false;
  bool maybe_negative = false;
  bool maybe_positive = false;
  for (const Interval& c : coefficients) {
    // Written so that NaN counts as "maybe".
    negative |= c.sup() < 0;
    positive |= c.inf() > 0;
    maybe_negative |= !(c.inf() >= 0);
    maybe_positive |= !(c.sup() <= 0);
  }
  if (negative != maybe_negative || positive != maybe_positive) return std::nullopt;
  result.none_negative = !negative;
  result.none_positive = !positive;
  return result;
}

PieceSigns exact_signs(const std::vector<Integer>& coefficients, const std::vector<std::size_t>& corners) {
  PieceSigns result{true, true, {}};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    result.corner[k] = static_cast<signed char>(sign(coefficients[corners[k]]));
  }
  for (const Integer& c : coefficients) {
    if (c.sign() < 0) result.none_negative = false;
    if (c.sign() > 0) result.none_positive = false;
  }
  return result;
}

// min and max for numbers and for intervals that contain numbers.
Rational smaller(const Rational& a, const Rational& b) { return a < b ? a : b; }
Rational larger(const Rational& a, const Rational& b) { return a < b ? b : a; }
Interval smaller(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::min(a.sup(), b.sup())};
}
Interval larger(const Interval& a, const Interval& b) {
  return {std::max(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}

bool certainly_not_negative(const Rational& a) { return a.sign() >= 0; }
bool certainly_not_negative(const Interval& a) { return a.inf() >= 0; }

// Coefficients stand for numbers of this type once their power of two is taken out.
Rational as_number(const Integer& value, int shift) { return Rational(value) * power_of_two(-shift); }
Interval as_number(const Interval& value, int) { return value; }

template <class Number, class T>
std::pair<Number, Number> coefficient_range(const Polynomial<T>& f, int shift) {
  if constexpr (std::is_same_v<T, Integer>) {
    const auto [low, high] = range(f);
    return {as_number(low, shift), as_number(high, shift)};
  } else {
    std::pair<Number, Number> result(f.coefficients[0], f.coefficients[0]);
    for (const Interval& c : f.coefficients) {
      result.first = smaller(result.first, c);
      result.second = larger(result.second, c);
    }
    return result;
  }
}

template <class Number>
Number cube(const Number& x) {
  return x * x * x;
}

}  // namespace

// The four numbers of DeterminantBounds before rounding: exact, or intervals that contain them.
template <class T>
struct JacobianTree::Extremes {
  T min_lower, min_upper, max_lower, max_upper;
};

JacobianTree::JacobianTree(const Forms& forms) : forms_(forms) {
  const Shape shape = numerator_shape(forms.element().shape(), forms.element().rational());
  corners_ = corner_indices(shape);
  corner_count_ = corners_.size();
  nodes_.emplace_back();
}

template <>
auto JacobianTree::slot<Interval>(Node& node) -> std::optional<PieceForm<Interval>>& {
  return node.interval;
}
template <>
auto JacobianTree::slot<Integer>(Node& node) -> std::optional<PieceForm<Integer>>& {
  return node.exact;
}

template <class T, class... Witness>
auto JacobianTree::form(Piece piece, const Witness&... up) -> const PieceForm<T>& {
  auto& own = slot<T>(nodes_[piece]);
  if (own) return *own;
  if (piece == root) {
    if constexpr (std::is_same_v<T, Interval>) {
      own = {forms_.interval_jacobian(up...), 0, 0};
    } else {
      own = {forms_.exact_jacobian(), 0, 0};
    }
    return *own;
  }
  const Node& node = nodes_[piece];
  const PieceForm<T>& parent = form<T>(node.parent, up...);
  const int factor = factor_to_cut(parent.numerator.shape.domain, nodes_[node.parent].depth);
  auto numerators = bisect(parent.numerator, factor);
  auto weights = bisect(parent.weight, factor);
  const int numerator_shift = parent.numerator_shift + bisection_shift<T>(parent.numerator.shape, factor);
  const int weight_shift = parent.weight_shift + bisection_shift<T>(parent.weight.shape, factor);
  const Piece first = node.second ? piece - 1 : piece;
  slot<T>(nodes_[first]) = {
      {std::move(numerators.first), std::move(weights.first)}, numerator_shift, weight_shift};
  slot<T>(nodes_[first + 1]) = {
      {std::move(numerators.second), std::move(weights.second)}, numerator_shift, weight_shift};
  return *own;
}

std::pair<JacobianTree::Piece, JacobianTree::Piece> JacobianTree::split(Piece piece) {
  for (const bool second : {false, true}) {
    Node child;
    child.parent = piece;
    child.depth = nodes_[piece].depth + 1;
    child.second = second;
    nodes_.push_back(std::move(child));
  }
  return {nodes_.size() - 2, nodes_.size() - 1};
}

bool JacobianTree::may_split(std::size_t limit) {
  // So few pieces are affordable whatever the numbers: the estimate would cost more than it saves.
  constexpr std::size_t always = 32;
  const std::size_t wanted = piece_count() + 2;
  if (wanted > limit) return false;
  if (wanted <= always) return true;
  if (affordable_pieces_ == 0) {
    std::size_t bits = 0;
    const JacobianForm<Integer>& whole = forms_.exact_jacobian();
    for (const auto* coefficients : {&whole.numerator.coefficients, &whole.weight.coefficients}) {
      for (const Integer& c : *coefficients) bits += mpz_sizeinbase(c.backend().data(), 2) + 64;
    }
    affordable_pieces_ = std::max(always, max_tree_bits / bits);
  }
  return wanted <= affordable_pieces_;
}

PieceSigns JacobianTree::signs(Piece piece) {
  if (forms_.filter() == Filter::on) {
    const RoundUp up;
    if (const auto certain = certain_signs(form<Interval>(piece, up).numerator.coefficients, corners_)) {
      return *certain;
    }
  }
  return exact_signs(form<Integer>(piece).numerator.coefficients, corners_);
}

bool JacobianTree::proves_positive(const PieceSigns& signs) const {
  return signs.none_negative && std::all_of(signs.corner.begin(), signs.corner.begin() + corner_count_,
                                            [](signed char s) { return s > 0; });
}

bool JacobianTree::proves_negative(const PieceSigns& signs) const {
  return signs.none_positive && std::all_of(signs.corner.begin(), signs.corner.begin() + corner_count_,
                                            [](signed char s) { return s < 0; });
}

Parameter JacobianTree::corner(Piece piece, std::size_t corner) const {
  std::vector<bool> path;  // from the piece up to the root
  for (Piece at = piece; at != root; at = nodes_[at].parent) path.push_back(nodes_[at].second);
  // By factor: the corners of its simplex by their affine coordinates, halved as `bisect` does.
  const Domain domain = forms_.element().shape().domain;
  std::array<std::vector<std::vector<Rational>>, max_dimension> simplices;
  for (int f = 0; f < domain.factor_count(); ++f) {
    const auto dimension = static_cast<std::size_t>(domain.simplex(f));
    auto& corners = simplices[static_cast<std::size_t>(f)];
    corners.assign(dimension + 1, std::vector<Rational>(dimension));
    for (std::size_t k = 0; k < dimension; ++k) corners[k + 1][k] = 1;
  }
  int depth = 0;
  for (auto step = path.rbegin(); step != path.rend(); ++step, ++depth) {
    auto& corners = simplices[static_cast<std::size_t>(factor_to_cut(domain, depth))];
    std::vector<Rational> middle = corners[0];
    for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = (middle[i] + corners[1][i]) / 2;
    if (corners.size() == 2) {
      corners[*step ? 0 : 1] = std::move(middle);
    } else if (*step) {
      corners = {std::move(corners[1]), std::move(corners[2]), std::move(middle)};
    } else {
      corners = {std::move(corners[2]), std::move(corners[0]), std::move(middle)};
    }
  }
  const DomainCorners::Corner at = domain_corners(domain).list[corner];
  std::vector<Rational> affine;
  std::size_t coordinate = 0;
  for (int f = 0; f < domain.factor_count(); ++f) {
    std::size_t of_simplex = 0;
    for (int k = 1; k <= domain.simplex(f); ++k, ++coordinate) {
      if (at[coordinate] == 1) of_simplex = static_cast<std::size_t>(k);
    }
    const std::vector<Rational>& place = simplices[static_cast<std::size_t>(f)][of_simplex];
    affine.insert(affine.end(), place.begin(), place.end());
  }
  return Parameter::at(domain, affine);
}

template <class T, class... Witness>
auto JacobianTree::extremes(std::span<const Piece> pieces, const Witness&... up) -> Extremes<T> {
  using Coefficient = std::conditional_t<std::is_same_v<T, Rational>, Integer, Interval>;
  const bool rational = forms_.element().rational();
  Extremes<T> result;
  bool first = true;
  for (const Piece piece : pieces) {
    const PieceForm<Coefficient>& f = form<Coefficient>(piece, up...);
    auto [low, high] = coefficient_range<T>(f.numerator, f.numerator_shift);
    std::vector<T> values;
    for (const std::size_t i : corners_)
      values.push_back(as_number(f.numerator.coefficients[i], f.numerator_shift));
    if (rational) {
      const auto [thin, thick] = coefficient_range<T>(f.weight, f.weight_shift);
      // N / W^3 is smallest with the smallest N and, according to its sign, the largest or smallest W. An
      // interval of unknown sign divided by the smallest W contains both.
      low = low / cube(certainly_not_negative(low) ? thick : thin);
      high = high / cube(certainly_not_negative(-high) ? thick : thin);
      const auto weight_corners = corner_indices(f.weight.shape);
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = values[k] / cube(as_number(f.weight.coefficients[weight_corners[k]], f.weight_shift));
      }
    }
    if (first) result = {low, values[0], values[0], high};
    first = false;
    result.min_lower = smaller(result.min_lower, low);
    result.max_upper = larger(result.max_upper, high);
    for (const T& value : values) {
      result.min_upper = smaller(result.min_upper, value);
      result.max_lower = larger(result.max_lower, value);
    }
  }
  return result;
}

DeterminantBounds JacobianTree::bounds(std::span<const Piece> pieces, int bits) {
  const Shape element = forms_.element().shape();
  const Integer& multiple = numerator_multiple(numerator_shape(element, forms_.element().rational()));
  if (forms_.filter() == Filter::on) {
    const RoundUp up;
    const Interval scale = forms_.interval(up).scale;
    const Interval factor = Interval(degree_factor(element)) * scale * scale / to_interval(multiple);
    const Extremes<Interval> found = extremes<Interval>(pieces, up);
    const auto min_lower = round_down(found.min_lower * factor, bits);
    const auto min_upper = round_up(found.min_upper * factor, bits);
    const auto max_lower = round_down(found.max_lower * factor, bits);
    const auto max_upper = round_up(found.max_upper * factor, bits);
    if (min_lower && min_upper && max_lower && max_upper) {
      return {*min_lower, *min_upper, *max_lower, *max_upper};
    }
  }
  const Rational& scale = forms_.exact().scale;
  const Rational factor = Rational(degree_factor(element)) * scale * scale / Rational(multiple);
  const Extremes<Rational> found = extremes<Rational>(pieces);
  return {round_down(Rational(found.min_lower * factor), bits),
          round_up(Rational(found.min_upper * factor), bits),
          round_down(Rational(found.max_lower * factor), bits),
          round_up(Rational(found.max_upper * factor), bits)};
}

}  // namespace bezcert
