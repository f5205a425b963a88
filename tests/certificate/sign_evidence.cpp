// Evidence for signs and zeros of N, checked by the verifier, which was written from the specification alone.
// The polynomials are such that their signs are known: sums of squares and their like.
#include "bezcert/certificate/sign_evidence.hpp"
#include "bezcert/certificate/zero_evidence.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "given_jacobian.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// The claim without injectivity: its sign, and its zero.
std::optional<std::string> claim_of(const Forms& forms, const Decision& decision) {
  const auto at = [](const Witness& witness) {
    const std::vector<Rational> uv = witness.parameter.affine();
    return to_string(uv[0]) + ' ' + to_string(uv[1]);
  };
  std::optional<std::string> sign, zero;
  switch (decision.verdict) {
    case ElementVerdict::undecided: return "undecided";
    case ElementVerdict::degenerate:
      sign = sign_evidence(forms, decision, WantedSign::nonnegative);
      zero = zero_evidence(forms, decision);
      if (!sign || !zero) return std::nullopt;
      return "degenerate " + *sign + ' ' + *zero;
    case ElementVerdict::reversed:
      sign = sign_evidence(forms, decision, WantedSign::negative);
      if (!sign) return std::nullopt;
      return "reversed " + *sign;
    case ElementVerdict::folded:
      zero = decision.other_witness ? "at " + at(*decision.other_witness) : zero_evidence(forms, decision);
      if (!zero) return std::nullopt;
      return "folded " + at(*decision.witness) + ' ' + *zero;
    default:
      sign = sign_evidence(forms, decision, WantedSign::positive);
      if (!sign) return std::nullopt;
      return "regular " + *sign;
  }
}

std::string first_words(const std::string& text, int count) {
  std::size_t end = 0;
  while (count-- > 0 && end != std::string::npos) end = text.find(' ', end + 1);
  return text.substr(0, end);
}

const Domain domains[] = {Domain::triangle, Domain::square};

// f with the verdict that it must have, from its derivation; the claim is returned.
std::string accepted(const Bivariate& f, Domain domain, ElementVerdict verdict) {
  const Element element = element_with(f, domain);
  const Forms forms(element), plain(element, Filter::off);
  const Decision decision = decide(forms);
  if (verdict == ElementVerdict::regular) {
    CHECK(is_regular(decision.verdict));
  } else {
    CHECK(decision.verdict == verdict);
  }
  const auto claim = claim_of(forms, decision);
  REQUIRE(claim);
  CHECK(refusal(f, domain, *claim) == "");
  CHECK(claim_of(plain, decision) == claim);
  return *claim;
}

const Bivariate one = constant2(1);
Bivariate times(long c, const Bivariate& f) { return constant2(c) * f; }
Bivariate power_of(const Bivariate& f, int n) { return n == 0 ? one : f * power_of(f, n - 1); }

}  // namespace

TEST_CASE("the corpus has evidence for every sign") {
  std::map<std::string, int> kinds;
  int elements = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BEZCERT_SOURCE_DIR "/corpus/elements")) {
    const std::string file = entry.path().string(), bytes = read_file(file);
    const Mesh mesh = read_mesh(file, bytes);
    const verifier::Elements other(bytes, "mixed", "decimal");
    for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
      INFO(file << " element " << i);
      const Element element = mesh.element(i);
      const Forms forms(element);
      const auto claim = claim_of(forms, decide(forms));
      REQUIRE(claim);
      ++kinds[first_words(*claim, claim->starts_with("folded") ? 1 : 2)];
      ++elements;
      verifier::begin_line();
      verifier::Tokens tokens(*claim);
      try {
        verifier::check_element(other.element(i), tokens);
        tokens.expect_end();
      } catch (const verifier::Rejected& rejected) {
        FAIL("rejected: " << rejected.why);
      } catch (const verifier::Malformed& malformed) {
        FAIL("malformed: " << malformed.why);
      }
    }
  }
  CHECK(elements >= 281);
  for (const char* kind :
       {"regular coefficients", "regular tree", "regular columns", "regular factors", "reversed coefficients",
        "degenerate coefficients", "degenerate tree", "degenerate columns", "degenerate factors", "folded"}) {
    INFO(kind);
    CHECK(kinds[kind] >= 3);
  }
}

TEST_CASE("isolated zeros inside") {
  for (const Domain domain : domains) {
    const auto check = [&](const Bivariate& p, const Bivariate& q, int degree_of_m) {
      const Bivariate f = square(p) + square(q);
      const std::string claim = accepted(f, domain, ElementVerdict::degenerate);
      const std::size_t root = claim.rfind(" root ");
      if (degree_of_m == 1) {
        CHECK(claim.find(" at ") != std::string::npos);
      } else {
        const std::string m = claim.substr(root + 6, claim.find(' ', root + 6) - root - 6);
        CHECK(std::count(m.begin(), m.end(), ',') == degree_of_m);
      }
      // Raised by 1e-12: no zero.
      accepted(times(1000000000000, f) + one, domain, ElementVerdict::regular);
    };
    // Points known from the factors: rational, in Q(sqrt 2), of degree 4; two and three zeros on one column.
    check(line2(-1, 3, 0), line2(-2, 0, 5), 1);
    check(line2(-1, 3, 0), line2(-1, 0, 4) * line2(-2, 0, 5), 1);
    check(poly2({poly({-1, 0, 8})}), line2(-1, 0, 5) * line2(-2, 0, 5), 2);
    check(poly2({poly({-1, 0, 8})}), swapped(poly2({poly({-3, 0, 25})})), 4);
    // v = u^2, u^5 + 2 u = 1: irreducible of degree 5 (it is so modulo 3).
    check(poly2({poly({0, 0, -1}), poly({1})}), poly2({poly({-1, 2, 0, 0, 0, 1})}), 5);
    check(swapped(poly2({poly({0, 0, -1}), poly({1})})), swapped(poly2({poly({-1, 2, 0, 0, 0, 1})})), 5);
  }
}

TEST_CASE("zeros on edges") {
  const Bivariate w = line2(1, -1, -1);
  for (const Domain domain : domains) {
    // 8 u^2 = 1 on the edge v = 0, and on all others.
    const Bivariate s = square(poly2({poly({-1, 0, 8})})), t = swapped(s);
    CHECK(accepted(V + s, domain, ElementVerdict::degenerate).find(" root -1,0,8 ") != std::string::npos);
    accepted(U + t, domain, ElementVerdict::degenerate);
    if (domain == Domain::triangle) {
      accepted(w + s, domain, ElementVerdict::degenerate);
      accepted(w + t, domain, ElementVerdict::degenerate);
      accepted(times(1000000, w) * line2(1, 1, 0) + square(poly2({poly({-1, 3, 0, 15})})), domain,
               ElementVerdict::degenerate);
    } else {
      accepted(line2(1, 0, -1) + s, domain, ElementVerdict::degenerate);
      accepted(line2(1, -1, 0) + t, domain, ElementVerdict::degenerate);
    }
    // det J <= 0 with an irrational zero: folded, by a zero.
    CHECK(accepted(times(-1, V + s), domain, ElementVerdict::folded).find(" root -1,0,8 ") !=
          std::string::npos);
    // At corners.
    accepted(square(U) + square(V), domain, ElementVerdict::degenerate);
  }
}

TEST_CASE("curves of zeros and of near-zeros") {
  const Bivariate circle = times(16, square(line2(-1, 3, 0)) + square(line2(-1, 0, 3))) - one;
  const Bivariate cubic = poly2({poly({-1, 0, 5}), poly({3, 1}), poly({0, 2})});
  for (const Domain domain : domains) {
    for (const Bivariate& p :
         {circle, line2(-1, 3, -1), cubic, poly2({poly({-1, 3})}), swapped(poly2({poly({-1, 3})}))}) {
      const Bivariate raised = times(1000000000000, square(p)) + one;
      accepted(square(p), domain, ElementVerdict::degenerate);
      accepted(raised, domain, ElementVerdict::regular);
      accepted(times(-1, raised), domain, ElementVerdict::reversed);
      accepted(times(1000000000000, square(p)) - one, domain, ElementVerdict::folded);
      // Several factors, one of them negative: c p^2 (3 - u) (u - 4) < 0.
      accepted(square(p) * line2(3, -1, 0) * line2(4, -1, 0), domain, ElementVerdict::degenerate);
      accepted(raised * raised * line2(3, -1, 0) * line2(-4, 1, 0), domain, ElementVerdict::reversed);
    }
  }
}

TEST_CASE("powers and products") {
  for (const Domain domain : domains) {
    const Bivariate a = square(line2(-1, 3, 0)) + square(line2(-1, 0, 5)), s = poly2({poly({-1, 0, 8})});
    accepted(power_of(a, 3) * square(line2(0, 1, -2)), domain, ElementVerdict::degenerate);
    accepted(power_of(s, 4) + square(line2(-2, 0, 5)), domain, ElementVerdict::degenerate);
    accepted(power_of(s, 4) * a, domain, ElementVerdict::degenerate);
    accepted(times(1000000000000, a) * a + one, domain, ElementVerdict::regular);
  }
}

TEST_CASE("a sign that is not there is refused") {
  // The verifier is not fooled by evidence for another polynomial; the library finds none.
  const Bivariate touching = square(line2(-1, 3, 0)) + square(line2(-2, 0, 5));
  const std::string claim = accepted(touching, Domain::triangle, ElementVerdict::degenerate);
  const std::string sign = claim.substr(11, claim.find(" at ") - 11);
  CHECK(refusal(touching, Domain::triangle, "regular " + sign) != "");
  CHECK(refusal(touching - constant2(1), Domain::triangle, claim) != "");
}
