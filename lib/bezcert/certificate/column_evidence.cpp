#include "bezcert/certificate/column_evidence.hpp"

#include "bezcert/algebra/real_root.hpp"
#include "bezcert/certificate/evidence_text.hpp"

#include <algorithm>
#include <array>

namespace bezcert {
namespace {

// Counts that keep the work bounded.
constexpr std::size_t max_resultant_bits = std::size_t{1} << 26;
constexpr int max_resultant_degree = 2048;
constexpr std::size_t max_columns = 4096;
constexpr int max_narrowings = 20;

struct Piece {
  Rational lower, upper;
  std::string text;
};

// f(lower + s (upper - lower), t top(...)) in (s, t), times a positive constant.
Bivariate over_slab(const Bivariate& f, Domain domain, const Rational& lower, const Rational& upper) {
  const Rational width = upper - lower;
  const Integer q = lcm(Integer(denominator(lower)), Integer(denominator(width)));
  const Integer p = Integer(numerator(lower)) * (q / denominator(lower));
  const Integer w = Integer(numerator(width)) * (q / denominator(width));
  // u = (p + w s) / q, top = (q - p - w s) / q or q / q.
  const Univariate u({p, w}), top = domain == Domain::triangle ? Univariate({q - p, -w}) : Univariate({q});
  const int degree = std::max(f.degree_u(), 0);
  std::vector<Integer> q_powers = {1};
  for (int i = 0; i < degree + f.degree_v(); ++i) q_powers.push_back(q_powers.back() * q);
  std::vector<Univariate> by_t;
  Univariate top_power({Integer(1)});
  for (int k = 0; k <= f.degree_v(); ++k) {
    const Univariate& a = f.by_v[static_cast<std::size_t>(k)];
    Univariate row;
    for (int i = a.degree(); i >= 0; --i) {
      const auto power = static_cast<std::size_t>(degree - i);
      row = row * u + Univariate({a.coefficients[static_cast<std::size_t>(i)] * q_powers[power]});
    }
    // Horner leaves q^(degree - i) u^i, u over q: one power of q for all i.
    by_t.push_back(row * top_power * Univariate({q_powers[static_cast<std::size_t>(f.degree_v() - k)]}));
    top_power = top_power * top;
  }
  return Bivariate(std::move(by_t));
}

class Columns {
 public:
  Columns(Bivariate f, Domain domain, Strictness wanted)
      : f_(std::move(f)), domain_(domain), wanted_(wanted) {}

  // What follows "columns u" or "columns v".
  std::optional<std::string> run() {
    if (!find_critical_factors()) return std::nullopt;
    if (!(wanted_ == Strictness::strict ? cover_strictly() : cover_weakly())) return std::nullopt;
    std::string text = std::to_string(factors_.size());
    for (const auto& [factor, exponents] : factors_) text += ' ' + text_of_polynomial(factor);
    for (std::size_t of = 0; of < 4; ++of) {
      std::string list;
      for (const auto& [factor, exponents] : factors_) {
        list += (list.empty() ? "" : ",") + std::to_string(exponents[of]);
      }
      text += ' ' + (list.empty() ? "-" : list);
    }
    text += ' ' + std::to_string(pieces_.size() - 1);
    for (std::size_t i = 1; i < pieces_.size(); ++i) text += ' ' + to_string(pieces_[i].lower);
    for (const Piece& piece : pieces_) text += ' ' + piece.text;
    return text;
  }

 private:
  struct CriticalFactor {
    Univariate polynomial;
    std::array<int, 4> exponents;  // in l, b, t, r
  };

  Rational top(const Rational& u) const {
    return domain_ == Domain::triangle ? Rational(1 - u) : Rational(1);
  }

  // The irreducible factors of l, b, t and r.
  bool find_critical_factors() {
    const Bivariate slope = derivative_v(f_);
    const int degree = resultant_degree_bound(f_, slope);
    const std::size_t bits = static_cast<std::size_t>(std::max(degree, 1)) *
                             static_cast<std::size_t>(2 * f_.degree_v() - 1) * longest_coefficient(f_);
    if (bits > max_resultant_bits || degree > max_resultant_degree) return false;
    const Rational above = domain_ == Domain::triangle ? 0 : 1;
    const std::array<Univariate, 4> all = {f_.by_v.back(), along(f_, {0, 0}, {1, 0}),
                                           along(f_, {0, 1}, {1, above}), resultant_v(f_, slope)};
    for (std::size_t of = 0; of < all.size(); ++of) {
      if (all[of].is_zero()) return false;
      if (all[of].degree() < 1) continue;
      for (auto& [factor, multiplicity] : irreducible_factors(all[of])) {
        auto known = std::find_if(factors_.begin(), factors_.end(),
                                  [&](const CriticalFactor& x) { return x.polynomial == factor; });
        if (known == factors_.end()) known = factors_.insert(known, {factor, {}});
        known->exponents[of] = multiplicity;
      }
    }
    std::sort(factors_.begin(), factors_.end(), [](const CriticalFactor& a, const CriticalFactor& b) {
      return std::pair(a.polynomial.degree(), a.polynomial.coefficients) <
             std::pair(b.polynomial.degree(), b.polynomial.coefficients);
    });
    critical_ = Univariate({Integer(1)});
    for (const CriticalFactor& factor : factors_) critical_ = critical_ * factor.polynomial;
    return true;
  }

  int variations(const Rational& lower, const Rational& upper) const {
    int sum = 0;
    for (const CriticalFactor& x : factors_) sum += sign_changes(bernstein_over(x.polynomial, lower, upper));
    return sum;
  }

  bool is_column(const Rational& u) const {
    if (sign_at(critical_, u) == 0) return false;
    const Univariate line = along(f_, {u, 0}, {u, top(u)});
    return !line.is_zero() && positive_on_segment(line);
  }

  bool add(const Rational& lower, const Rational& upper, std::string text) {
    pieces_.push_back({lower, upper, std::move(text)});
    return pieces_.size() <= max_columns;
  }

  // A short number in the middle quarter.
  static Rational middle(const Rational& lower, const Rational& upper) {
    const Rational part = (upper - lower) * Rational(3, 8);
    return simplest_between(lower + part, upper - part);
  }

  // [lower, upper] without a root of C in the open interval.
  bool cover_open(const Rational& lower, const Rational& upper) {
    if (variations(lower, upper) == 0) return add(lower, upper, "open");
    const Rational u = middle(lower, upper);
    return pieces_.size() < max_columns && is_column(u) && cover_open(lower, u) && cover_open(u, upper);
  }

  // With one root in the open interval.
  bool cover_root(const Rational& lower, const Rational& upper, RealRoot root) {
    if (variations(lower, upper) <= 1) return add(lower, upper, "root");
    // A number beside the root: from the larger of the two parts that its interval leaves.
    while ((root.upper - root.lower) * 4 > upper - lower) root.refine();
    const bool below = root.lower - lower > upper - root.upper;
    const Rational u = below ? middle(lower, root.lower) : middle(root.upper, upper);
    if (pieces_.size() >= max_columns || !is_column(u)) return false;
    return below ? cover_open(lower, u) && cover_root(u, upper, std::move(root))
                 : cover_root(lower, u, std::move(root)) && cover_open(u, upper);
  }

  bool cover_weakly() {
    Rational lower = 0;
    const RealRoot* root = nullptr;  // between the last column and the next
    const std::vector<RealRoot> roots = inner_roots();
    std::size_t next = 0;
    for (const Gap& gap : gaps_between_roots(critical_, 0, 1)) {
      if (!is_column(gap.sample)) return false;
      if (root == nullptr ? !cover_open(lower, gap.sample) : !cover_root(lower, gap.sample, *root))
        return false;
      lower = gap.sample;
      root = next < roots.size() ? &roots[next++] : nullptr;
    }
    return cover_open(lower, 1);
  }

  std::vector<RealRoot> inner_roots() const {
    std::vector<RealRoot> roots = roots_in(critical_, 0, 1);
    std::erase_if(roots, [](const RealRoot& x) { return x.is_rational() && (x.lower == 0 || x.lower == 1); });
    return roots;
  }

  // Whether a slab that holds the root is shown positive, from the widest to ever narrower ones: [lower,
  // upper] shrinks to it. An end 0 or 1 that is the root stays.
  bool find_slab(RealRoot root, Rational& lower, Rational& upper) const {
    for (int tries = 0; tries <= max_narrowings; ++tries) {
      const bool at_lower = lower == 0 && root.is_rational() && root.lower == 0;
      const bool at_upper = upper == 1 && root.is_rational() && root.lower == 1;
      if (tries > 0) {
        const Rational part = (upper - lower) * power_of_two(-3L * tries);
        root.refine_to(part / 8);
        if (!at_lower && root.lower - lower > part) {
          lower = simplest_between(root.lower - part, root.lower - part / 2);
        }
        if (!at_upper && upper - root.upper > part) {
          upper = simplest_between(root.upper + part / 2, root.upper + part);
        }
      }
      if ((!at_lower && !is_column(lower)) || (!at_upper && !is_column(upper))) return false;
      if (positive_by_rows(to_bernstein(over_slab(f_, domain_, lower, upper), Domain::square))) return true;
    }
    return false;
  }

  bool cover_strictly() {
    const std::vector<RealRoot> roots = roots_in(critical_, 0, 1);
    std::vector<Rational> samples;
    for (const Gap& gap : gaps_between_roots(critical_, 0, 1)) samples.push_back(gap.sample);
    if (roots.empty()) {
      return is_column(samples[0]) && cover_open(0, samples[0]) && cover_open(samples[0], 1);
    }
    Rational covered = 0;
    const bool from_zero = roots[0].is_rational() && roots[0].lower == 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      // samples[before - 1] < root < samples[before].
      const std::size_t before = from_zero ? i : i + 1;
      Rational lower = before == 0 ? Rational(0) : samples[before - 1];
      Rational upper = before < samples.size() ? samples[before] : Rational(1);
      if (!find_slab(roots[i], lower, upper)) return false;
      if (covered < lower && !cover_open(covered, lower)) return false;
      if (!add(lower, upper, "slab")) return false;
      covered = upper;
    }
    return covered == 1 || cover_open(covered, 1);
  }

  Bivariate f_;
  Domain domain_;
  Strictness wanted_;
  std::vector<CriticalFactor> factors_;
  Univariate critical_;  // their product
  std::vector<Piece> pieces_;
};

}  // namespace

std::optional<std::string> column_evidence(const Bivariate& f, Domain domain, Strictness wanted) {
  const bool by_u_first = f.degree_v() >= 1 && (f.degree_v() <= f.degree_u() || f.degree_u() < 1);
  for (const bool by_u : {by_u_first, !by_u_first}) {
    if ((by_u ? f.degree_v() : f.degree_u()) < 1) continue;
    if (const auto text = Columns(by_u ? f : swapped(f), domain, wanted).run()) {
      return std::string("columns ") + (by_u ? "u " : "v ") + *text;
    }
  }
  return std::nullopt;
}

}  // namespace bezcert
