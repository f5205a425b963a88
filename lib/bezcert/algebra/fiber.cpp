#include "bezcert/algebra/fiber.hpp"

#include "bezcert/algebra/field_gcd.hpp"
#include "bezcert/algebra/flint_types.hpp"
#include "bezcert/number/scaled.hpp"

#include <algorithm>

namespace bezcert {
namespace {

// An element of Q(alpha): a polynomial in alpha of smaller degree than its minimal polynomial.
class FieldElement {
 public:
  FieldElement() { fmpq_poly_init(value_); }
  explicit FieldElement(const Univariate& f) : FieldElement() {
    const FlintPolynomial integer(f);
    fmpq_poly_set_fmpz_poly(value_, integer.value);
  }
  FieldElement(const FieldElement& other) : FieldElement() { fmpq_poly_set(value_, other.value_); }
  FieldElement& operator=(const FieldElement& other) {
    fmpq_poly_set(value_, other.value_);
    return *this;
  }
  ~FieldElement() { fmpq_poly_clear(value_); }

  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  fmpq_poly_struct* get() { return value_; }
  const fmpq_poly_struct* get() const { return value_; }

  /// The k-th coefficient.
  Rational coefficient(slong k) const {
    mpq_t q;
    mpq_init(q);
    fmpq_t c;
    fmpq_init(c);
    fmpq_poly_get_coeff_fmpq(c, value_, k);
    fmpq_get_mpq(q, c);
    Rational result;
    mpq_set(result.backend().data(), q);
    fmpq_clear(c);
    mpq_clear(q);
    return result;
  }
  slong length() const { return fmpq_poly_length(value_); }

 private:
  fmpq_poly_t value_;
};

}  // namespace

class Fiber::Implementation {
 public:
  // A polynomial in v over the field, lowest coefficient first, no leading zeros.
  using Line = std::vector<FieldElement>;

  Implementation(RealRoot alpha, const std::vector<Bivariate>& polynomials) : alpha_(std::move(alpha)) {
    const FlintPolynomial minimal(alpha_.polynomial);
    fmpq_poly_set_fmpz_poly(modulus_.get(), minimal.value);
    if (alpha_.is_rational()) {
      for (const Bivariate& f : polynomials) divisor_ = common_divisor(divisor_, line_of(f));
    } else {
      for (const FieldVector& c : field_gcd(alpha_.polynomial, polynomials)) divisor_.push_back(element(c));
    }
    if (divisor_.size() < 2) return;
    Line slope = differentiated(divisor_);
    const Line multiple = common_divisor(divisor_, slope);
    if (multiple.size() > 1) {
      divisor_ = divide(divisor_, multiple).first;
      slope = differentiated(divisor_);
    }
    sturm_ = {divisor_, slope};
    while (sturm_.back().size() > 1) {
      Line rest = divide(sturm_[sturm_.size() - 2], sturm_.back()).second;
      for (FieldElement& c : rest) fmpq_poly_neg(c.get(), c.get());
      shrink(rest);
      sturm_.push_back(std::move(rest));
    }
  }

  const RealRoot& alpha() const { return alpha_; }
  bool is_whole_line() const { return divisor_.empty(); }

  int count(const FieldElement& low, const FieldElement& high, Ends ends) {
    if (divisor_.size() < 2) return 0;
    // Sturm: the number of roots in (low, high].
    int number = variations(low) - variations(high);
    const bool at_low = value(divisor_, low).is_zero(), at_high = value(divisor_, high).is_zero();
    if (ends == Ends::included) return number + (at_low ? 1 : 0);
    return number - (at_high ? 1 : 0);
  }

  static FieldElement element(const FieldVector& coefficients) {
    FieldElement result;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      fmpq_poly_set_coeff_mpq(result.get(), static_cast<slong>(k), coefficients[k].backend().data());
    }
    return result;
  }
  FieldElement element(const Univariate& f) const { return reduced(FieldElement(f)); }
  FieldElement element(const Rational& x) const {
    FieldElement result(Univariate({Integer(numerator(x))}));
    const FlintInteger q{Integer(denominator(x))};
    fmpq_poly_scalar_div_fmpz(result.get(), result.get(), q.value);
    return result;
  }

  RealRoot smallest(const Univariate& low_end, const Univariate& high_end, Ends ends, Rational width) {
    const FieldElement low = element(low_end), high = element(high_end);
    if (divisor_.size() == 2) {
      // v + c = 0.
      FieldElement root(divisor_[0]);
      fmpq_poly_neg(root.get(), root.get());
      if (root.length() <= 1) return rational_root(root.coefficient(0));
    }
    if (alpha_.is_rational()) {
      std::vector<Rational> coefficients;
      for (const FieldElement& c : divisor_) coefficients.push_back(c.coefficient(0));
      const Rational from = low.coefficient(0), to = high.coefficient(0);
      for (RealRoot& root : roots_in(from_rationals(coefficients), from, to)) {
        if (ends == Ends::excluded && root.is_rational() && (root.lower == from || root.lower == to))
          continue;
        RealRoot exact = with_minimal_polynomial(std::move(root));
        exact.refine_to(width);
        return exact;
      }
      throw std::logic_error("Fiber::smallest: no root");
    }
    RealRoot box = isolated(low, high, ends, width);
    if (alpha_.polynomial.degree() > largest_norm) return box;
    const Univariate norm = square_free_part(norm_of_divisor());
    for (;;) {
      std::vector<RealRoot> roots = roots_in(norm, box.lower, box.upper);
      if (roots.size() == 1) return with_minimal_polynomial(std::move(roots[0]));
      width /= 1024;
      box = isolated(low, high, ends, width);
    }
  }

 private:
  // Fields of larger degree are not asked for the polynomial of v: it would be long and no easier to read.
  static constexpr int largest_norm = 16;

  // An interval that holds the smallest counted root and no other root of the divisor.
  RealRoot isolated(const FieldElement& low, const FieldElement& high, Ends ends, const Rational& width) {
    if (divisor_.size() == 2) {
      FieldElement root(divisor_[0]);
      fmpq_poly_neg(root.get(), root.get());
      return enclosure(root, width);
    }
    // Rational bounds a <= low, high <= b, then bisection. A root equal to an end is met by counting with the
    // end itself.
    Rational a = enclosure(low, Rational(1, 4)).lower - 1, b = enclosure(high, Rational(1, 4)).upper + 1;
    const auto is_at_most = [&](const Rational& x) {  // whether a counted root is <= x
      const FieldElement at = element(x);
      const int side = sign(difference(at, low));
      if (side < 0 || (side == 0 && ends == Ends::excluded)) return false;
      if (side == 0) return value(divisor_, at).is_zero();
      if (sign(difference(at, high)) >= 0) return true;
      int number = count(low, at, ends);
      if (ends == Ends::excluded && value(divisor_, at).is_zero()) ++number;
      return number > 0;
    };
    while (b - a > width || count(element(a), element(b), Ends::included) > 1) {
      const Rational middle = (a + b) / 2;
      (is_at_most(middle) ? b : a) = middle;
    }
    return {Univariate(), a, b};
  }

  // The product of the divisor's conjugates: a polynomial in v over the rationals, up to a factor.
  Univariate norm_of_divisor() const {
    // Swapped: v is the variable that stays, u is eliminated.
    const auto degree = static_cast<std::size_t>(alpha_.polynomial.degree());
    std::vector<Rational> all;
    for (const FieldElement& c : divisor_) {
      for (std::size_t i = 0; i < degree; ++i) all.push_back(c.coefficient(static_cast<slong>(i)));
    }
    const std::vector<Integer> cleared = scaled_integers(all).values;
    std::vector<Univariate> divisor, minimal;
    for (std::size_t i = 0; i < degree; ++i) {
      std::vector<Integer> in_v;
      for (std::size_t k = 0; k < divisor_.size(); ++k) in_v.push_back(cleared[k * degree + i]);
      divisor.emplace_back(std::move(in_v));
    }
    for (const Integer& c : alpha_.polynomial.coefficients) minimal.push_back(Univariate({c}));
    return resultant_v(Bivariate(std::move(divisor)), Bivariate(std::move(minimal)));
  }

  FieldElement reduced(FieldElement x) const {
    fmpq_poly_rem(x.get(), x.get(), modulus_.get());
    return x;
  }
  static FieldElement difference(const FieldElement& a, const FieldElement& b) {
    FieldElement result;
    fmpq_poly_sub(result.get(), a.get(), b.get());
    return result;
  }
  FieldElement product(const FieldElement& a, const FieldElement& b) const {
    FieldElement result;
    fmpq_poly_mul(result.get(), a.get(), b.get());
    return reduced(std::move(result));
  }
  FieldElement inverse(const FieldElement& x) const {
    FieldElement divisor, cofactor, other;
    fmpq_poly_xgcd(divisor.get(), cofactor.get(), other.get(), x.get(), modulus_.get());
    if (divisor.length() != 1) throw std::logic_error("Fiber: the polynomial of alpha is not irreducible");
    return cofactor;
  }

  static void shrink(Line& f) {
    while (!f.empty() && f.back().is_zero()) f.pop_back();
  }
  Line line_of(const Bivariate& f) const {
    Line result;
    for (const Univariate& c : f.by_v) result.push_back(element(c));
    shrink(result);
    return result;
  }
  Line differentiated(const Line& f) const {
    Line result;
    for (std::size_t k = 1; k < f.size(); ++k) {
      FieldElement c(f[k]);
      fmpq_poly_scalar_mul_ui(c.get(), c.get(), k);
      result.push_back(std::move(c));
    }
    return result;
  }
  // Quotient and remainder. Precondition: g is not 0.
  std::pair<Line, Line> divide(Line f, const Line& g) const {
    Line quotient;
    if (f.size() >= g.size()) quotient.resize(f.size() - g.size() + 1);
    const FieldElement inverse_of_leading = inverse(g.back());
    while (f.size() >= g.size()) {
      const std::size_t shift = f.size() - g.size();
      const FieldElement factor = product(f.back(), inverse_of_leading);
      for (std::size_t k = 0; k + 1 < g.size(); ++k) {
        const FieldElement part = product(factor, g[k]);
        fmpq_poly_sub(f[shift + k].get(), f[shift + k].get(), part.get());
      }
      quotient[shift] = factor;
      f.pop_back();
      shrink(f);
    }
    return {std::move(quotient), std::move(f)};
  }
  // Monic.
  Line common_divisor(Line f, Line g) const {
    while (!g.empty()) {
      Line rest = divide(std::move(f), g).second;
      f = std::move(g);
      g = std::move(rest);
    }
    if (f.empty()) return f;
    const FieldElement factor = inverse(f.back());
    for (FieldElement& c : f) c = product(c, factor);
    return f;
  }
  FieldElement value(const Line& f, const FieldElement& at) const {
    FieldElement sum;
    for (std::size_t k = f.size(); k-- > 0;) {
      sum = product(sum, at);
      fmpq_poly_add(sum.get(), sum.get(), f[k].get());
    }
    return sum;
  }

  // An interval that contains the element, from the present interval of alpha.
  std::pair<Rational, Rational> range(const FieldElement& x) const {
    Rational low = 0, high = 0;
    for (slong k = x.length(); k-- > 0;) {
      Rational corners[4] = {low * alpha_.lower, low * alpha_.upper, high * alpha_.lower,
                             high * alpha_.upper};
      low = *std::min_element(corners, corners + 4);
      high = *std::max_element(corners, corners + 4);
      const Rational c = x.coefficient(k);
      low += c;
      high += c;
    }
    return {low, high};
  }
  int sign(const FieldElement& x) {
    if (x.is_zero()) return 0;
    for (;;) {
      const auto [low, high] = range(x);
      if (low.sign() > 0) return 1;
      if (high.sign() < 0) return -1;
      alpha_.refine();
    }
  }
  RealRoot enclosure(const FieldElement& x, const Rational& width) {
    for (;;) {
      const auto [low, high] = range(x);
      if (high - low <= width) return {Univariate(), low, high};
      alpha_.refine();
    }
  }
  int variations(const FieldElement& at) {
    int changes = 0, last = 0;
    for (const Line& f : sturm_) {
      const int s = sign(value(f, at));
      if (s == 0) continue;
      if (last != 0 && s != last) ++changes;
      last = s;
    }
    return changes;
  }

  RealRoot alpha_;
  FieldElement modulus_;
  Line divisor_;
  std::vector<Line> sturm_;
};

Fiber::Fiber(RealRoot alpha, const std::vector<Bivariate>& polynomials)
    : implementation_(std::make_unique<Implementation>(std::move(alpha), polynomials)) {}
Fiber::~Fiber() = default;

const RealRoot& Fiber::alpha() const { return implementation_->alpha(); }
bool Fiber::is_whole_line() const { return implementation_->is_whole_line(); }

int Fiber::count(const Univariate& low, const Univariate& high, Ends ends) {
  return implementation_->count(implementation_->element(low), implementation_->element(high), ends);
}

RealRoot Fiber::smallest(const Univariate& low, const Univariate& high, Ends ends, const Rational& width) {
  return implementation_->smallest(low, high, ends, width);
}

}  // namespace bezcert
