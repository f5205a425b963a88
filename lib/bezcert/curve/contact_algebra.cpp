#include "bezcert/curve/contact_algebra.hpp"

#include "bezcert/algebra/fiber.hpp"

#include <algorithm>
#include <stdexcept>

namespace bezcert {
namespace {

// Power coefficients of a homogeneous curve, all of one length.
struct Powers {
  Univariate x, y, w;
};

Powers powers_of(const CurveNet<Integer>& net) {
  return {from_bernstein(net.x), from_bernstein(net.y), from_bernstein(net.w)};
}

Integer coefficient(const Univariate& f, std::size_t k) {
  return k < f.coefficients.size() ? f.coefficients[k] : Integer(0);
}

// p1(s) w2(t) - p2(t) w1(s), u = s, v = t.
Bivariate difference(const Univariate& p1, const Univariate& w1, const Univariate& p2, const Univariate& w2) {
  std::vector<Univariate> by_v;
  for (std::size_t k = 0; k < std::max(p2.coefficients.size(), w2.coefficients.size()); ++k) {
    by_v.push_back(p1 * Univariate({coefficient(w2, k)}) - w1 * Univariate({coefficient(p2, k)}));
  }
  return Bivariate(std::move(by_v));
}

bool is_constant(const Bivariate& f) { return f.degree_u() <= 0 && f.degree_v() <= 0; }

ParameterRange range_of(const RealRoot& root) { return {root.lower, root.upper}; }

class Search {
 public:
  Search(Bivariate f, Bivariate g, Joints joints) : f_(std::move(f)), g_(std::move(g)), joints_(joints) {}

  std::optional<Contact> run(const Strips& strips_s, const Strips& strips_t) {
    const Bivariate common = gcd(f_, g_);
    if (!is_constant(common)) {
      if (auto contact = along_curves(common, strips_s, strips_t)) return contact;
      if (f_.is_zero() || g_.is_zero()) return std::nullopt;
      f_ = quotient(f_, common);
      g_ = quotient(g_, common);
    }
    if (is_constant(f_) || is_constant(g_)) return std::nullopt;
    return isolated(strips_s);
  }

 private:
  bool is_joint(const RealRoot& s, const RealRoot& t) const {
    if (!s.is_rational() || !t.is_rational()) return false;
    return (joints_.end_to_begin && s.lower == 1 && t.lower == 0) ||
           (joints_.begin_to_end && s.lower == 0 && t.lower == 1);
  }

  // Zeros of the common factor: curves of them are pieces in common.
  std::optional<Contact> along_curves(const Bivariate& common, const Strips& strips_s,
                                      const Strips& strips_t) {
    for (const auto& [factor, multiplicity] : irreducible_factors(common)) {
      const ZeroSet zeros = zero_set(factor, Domain::square, strips_s, strips_t);
      for (const PlanarPoint& zero : zeros.zeros) {
        if (is_joint(zero.u, zero.v)) continue;
        return Contact{range_of(zero.u), range_of(zero.v), zeros.dimension == 1};
      }
    }
    return std::nullopt;
  }

  std::optional<Contact> isolated(const Strips& strips_s) {
    const Univariate resultant = resultant_v(f_, g_);
    if (resultant.is_zero()) throw std::logic_error("contact: a common factor was not found");
    if (resultant.degree() < 1) return std::nullopt;
    // Tangential contacts are multiple roots: a polynomial of small degree.
    const Univariate whole = square_free_part(resultant);
    const Univariate repeated = gcd(resultant, derivative(resultant));
    std::vector<Univariate> parts;
    if (repeated.degree() > 0) {
      parts = {square_free_part(repeated)};
      parts.push_back(exact_quotient(whole, parts[0]));
    } else {
      parts = {whole};
    }
    for (const Univariate& part : parts) {
      for (const auto& [lower, upper] : strips_s) {
        for (RealRoot& root : roots_in(part, lower, upper)) {
          if (auto contact = over(with_minimal_polynomial(std::move(root)))) return contact;
        }
      }
    }
    return std::nullopt;
  }

  std::optional<Contact> over(RealRoot s) {
    if (s.is_rational()) {
      const Univariate line = gcd(at_u(f_, s.lower), at_u(g_, s.lower));
      if (line.is_zero()) throw std::logic_error("contact: a curve is a single point");
      for (RealRoot& root : roots_in(square_free_part(line), 0, 1)) {
        RealRoot t = with_minimal_polynomial(std::move(root));
        if (is_joint(s, t)) continue;
        t.refine_to(shown_width());
        return Contact{range_of(s), range_of(t), false};
      }
      return std::nullopt;
    }
    Fiber fiber(std::move(s), {f_, g_});
    if (fiber.is_whole_line()) throw std::logic_error("contact: a curve is a single point");
    const Univariate zero, one({Integer(1)});
    if (fiber.count(zero, one, Fiber::Ends::included) == 0) return std::nullopt;
    const RealRoot t = fiber.smallest(zero, one, Fiber::Ends::included, shown_width());
    RealRoot alpha = fiber.alpha();
    alpha.refine_to(shown_width());
    return Contact{range_of(alpha), {std::max(t.lower, Rational(0)), std::min(t.upper, Rational(1))}, false};
  }

  Bivariate f_, g_;
  Joints joints_;
};

}  // namespace

ContactEquations contact_equations(const CurveNet<Integer>& a, const CurveNet<Integer>& b, bool itself) {
  const Powers first = powers_of(a), second = powers_of(b);
  ContactEquations result{difference(first.x, first.w, second.x, second.w),
                          difference(first.y, first.w, second.y, second.w)};
  if (itself) {
    const Bivariate diagonal({Univariate({Integer(0), Integer(1)}), Univariate({Integer(-1)})});
    for (Bivariate* equation : {&result.f, &result.g}) {
      if (!equation->is_zero()) *equation = quotient(*equation, diagonal);
    }
  }
  return result;
}

AlgebraicContact contact_by_algebra(const CurveNet<Integer>& a, const CurveNet<Integer>& b, bool itself,
                                    Joints joints, const Strips& strips_s, const Strips& strips_t,
                                    std::size_t budget_bits) {
  auto [f, g] = contact_equations(a, b, itself);
  // The resultant's coefficients have about this many bits (Hadamard, up to logarithms).
  const std::size_t bits = static_cast<std::size_t>(std::max(resultant_degree_bound(f, g), 1)) *
                           (static_cast<std::size_t>(std::max(g.degree_v(), 0)) * longest_coefficient(f) +
                            static_cast<std::size_t>(std::max(f.degree_v(), 0)) * longest_coefficient(g));
  if (bits > budget_bits) return {ExceededBits{budget_bits, bits}, std::nullopt};
  return {std::nullopt, Search(std::move(f), std::move(g), joints).run(strips_s, strips_t)};
}

}  // namespace bezcert
