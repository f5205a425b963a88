// Tokens of a certificate, each with one spelling (docs/certificate-format.md, "Text"), and numbers.
#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>
#include <vector>

namespace verifier {

/// The certificate (or the elements file) is not what its format says: exit 2.
struct Malformed {
  std::string why;
};
/// A check of the certificate failed: exit 1.
struct Rejected {
  std::string why;
};

inline void require(bool holds, const char* why) {
  if (!holds) throw Rejected{why};
}

/// Polynomials: coefficients of 1, x, x^2, ...; the last is not 0, the zero polynomial has none.
using Polynomial = std::vector<mpz_class>;
/// Coefficients of 1, v, v^2, ..., polynomials in u; the last is not zero.
using Polynomial2 = std::vector<Polynomial>;
/// numerator(x) / denominator.
struct RationalPolynomial {
  Polynomial numerator;
  mpz_class denominator;
};
struct EdgeName {
  std::size_t element;  ///< position minus 1
  int edge;
};

/// One line, token by token. All members throw Malformed.
class Tokens {
 public:
  explicit Tokens(std::string_view line);
  std::string_view word();
  /// Takes the next token if it is `word`.
  bool accept(std::string_view word);
  bool at_end() const { return at_ > line_.size(); }
  void expect_end() const;

  mpz_class integer();
  /// An INT from low to high.
  long small(long low, long high);
  mpq_class rational();
  Polynomial polynomial();
  Polynomial2 polynomial2();
  RationalPolynomial rational_polynomial();
  std::string_view bits();
  EdgeName edge_name();

 private:
  std::string_view line_;
  std::size_t at_ = 0;

  std::string_view next() const;
};

/// The exact value of a decimal text ("-1.5e3"), or of "p/q" if `fractions`. Throws Malformed.
mpq_class exact_number(std::string_view text, bool fractions);
/// The double nearest to a decimal text. Throws Malformed beyond the range of doubles.
double nearest_double(std::string_view text);

/// Work is counted in about limb operations; throws Malformed when a line's limit, or the total, is spent.
void begin_line();
void spend(std::size_t work);

}  // namespace verifier
