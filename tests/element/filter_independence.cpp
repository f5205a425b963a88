// The decision of an element does not depend on the filter: every part of the answer is the same.
#include "element/random_net.hpp"

#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/report/decision_text.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <complex>
#include <limits>
#include <map>
#include <string>

using namespace bezcert;
using namespace bezcert::test;

namespace {

std::string text(const std::optional<Witness>& witness) {
  if (!witness) return "-";
  return to_string(witness->parameter) + ": " + to_string(witness->determinant);
}
std::string text(const Dyadic& d) { return std::to_string(d.mantissa) + "*2^" + std::to_string(d.exponent); }

std::string text(const BoundaryRange& range) {
  return std::to_string(range.edge) + " from " + to_string(range.lower) + " to " + to_string(range.upper);
}

std::string text(const RealRoot& x) {
  return to_string(x.polynomial, "x") + " in " + to_string(x.lower) + " " + to_string(x.upper);
}

Budget limits(std::size_t pieces, int depth) {
  Budget budget;
  budget.pieces = pieces;
  budget.depth = depth;
  budget.contact.pairs = 2000;
  budget.contact.depth = depth;
  return budget;
}

/// So that elements stay undecided, and what is said then is compared too.
Budget without_algebra(Budget budget) {
  budget.algebra_bits = 0;
  budget.contact.algebra_bits = 0;
  return budget;
}

/// Every field of a decision.
std::string text(const Decision& d) {
  return std::string(name(d.verdict)) + ", witness " + text(d.witness) + ", other " + text(d.other_witness) +
         ", bounds " + text(d.bounds.min_lower) + " " + text(d.bounds.min_upper) + " " +
         text(d.bounds.max_lower) + " " + text(d.bounds.max_upper) + ", sign proof " +
         std::string(name(d.sign_proof)) + ", injectivity proof " + std::string(name(d.injectivity_proof)) +
         ", open " + open_text(d) + ", pieces " + std::to_string(d.pieces) +
         (d.zero ? ", zero " + text(d.zero->at.u) + " " + text(d.zero->at.v) + " dimension " +
                       std::to_string(d.zero->dimension)
                 : "") +
         (d.overlap ? ", overlap " + text(d.overlap->first) + " and " + text(d.overlap->second) : "");
}

/// Elements of degrees 1 to 4 (squares to 3): tiny integers, near-identity ones that are regular or reversed,
/// and many exactly degenerate ones.
ControlNet small_net(Random& random) {
  const auto shapes = element_shapes(4, 3);
  const Shape shape =
      shapes[static_cast<std::size_t>(random.integer(0, static_cast<long>(shapes.size()) - 1))];
  const bool regular = random.chance(50);
  const Points points = !regular            ? Points::small_integers
                        : random.chance(50) ? Points::near_identity
                                            : Points::loose_identity;
  ControlNet net =
      random_net(random, shape, points, random.chance(60) ? Weights::none : Weights::small_integers);
  if (random.chance(15)) degenerate(random, net);
  if (regular && random.chance(10)) {  // reversed
    for (Rational& x : net.x) x = -x;
  }
  // Small integers are exact in double: to make the filter fail, the same zeros in skew coordinates, and
  // numbers next to zero.
  if (random.chance(30)) skew(random, net);
  if (random.chance(20)) nudge(random, net);
  if (random.chance(5)) stretch(random, net);
  return net;
}

/// The map z -> z^n of a triangle with corners a, b, c of the complex plane: its control points are the
/// products a^i b^j c^k. Regular where the triangle does not contain 0; overlapping where it spans a large
/// angle.
ControlNet power_net(int n, std::array<std::complex<long>, 3> corners) {
  ControlNet net;
  net.shape = Shape::triangle(n);
  for (const auto& [k, j] : rows_and_columns(net.shape)) {
    std::complex<long> product(1, 0);
    for (int f = 0; f < n - j - k; ++f) product *= corners[0];
    for (int f = 0; f < j; ++f) product *= corners[1];
    for (int f = 0; f < k; ++f) product *= corners[2];
    net.x.emplace_back(product.real());
    net.y.emplace_back(product.imag());
  }
  return net;
}

/// What was seen of the answers of many elements.
struct Seen {
  std::map<std::string, long> verdicts;
  long rational = 0, witnesses = 0, filter_sufficed = 0, exact_with_filter = 0;
};

/// Decides with and without the filter and compares every field; also det J of the witnesses.
void check_decision(const ControlNet& net, const Budget& budget, Seen& seen) {
  const Element element = bernstein_element(net);
  const Forms on(element, Filter::on);
  const Forms off(element, Filter::off);
  const Decision with_filter = decide(on, budget);
  const Decision without = decide(off, budget);
  if (text(with_filter) != text(without)) {
    INFO(show(net));
    INFO("filter on:  " << text(with_filter));
    INFO("filter off: " << text(without));
    FAIL_CHECK("different");
  }
  ++seen.verdicts[std::string(name(with_filter.verdict))];
  seen.rational += element.rational();
  (on.went_exact() ? seen.exact_with_filter : seen.filter_sufficed) += 1;
  for (const auto* witness : {&with_filter.witness, &with_filter.other_witness}) {
    if (!*witness) continue;
    if ((*witness)->determinant != direct_determinant(net, (*witness)->parameter.values())) {
      INFO(show(net));
      FAIL_CHECK("det J of the witness " << text(*witness));
    }
    ++seen.witnesses;
  }
}

}  // namespace

TEST_CASE("decisions with and without the filter are the same in every part: small integers") {
  const std::uint64_t seed = seed_or(351);
  Random random(seed);
  Seen seen;
  for (int i = 0; i < 2500; ++i) {
    INFO("seed " << seed << ", case " << i);
    check_decision(small_net(random), limits(300, 40), seen);
  }
  for (const auto& [verdict, count] : seen.verdicts) UNSCOPED_INFO(verdict << ": " << count);
  CHECK(seen.verdicts["injective"] > 300);
  CHECK(seen.verdicts["degenerate"] > 100);
  CHECK(seen.verdicts["folded"] > 300);
  CHECK(seen.verdicts["reversed"] > 100);
  CHECK(seen.rational > 400);
  CHECK(seen.witnesses > 500);
  CHECK(seen.filter_sufficed > 500);
  CHECK(seen.exact_with_filter > 100);
}

TEST_CASE("decisions with and without the filter are the same in every part: maps that may overlap") {
  const std::uint64_t seed = seed_or(354);
  Random random(seed);
  Seen seen;
  for (int i = 0; i < 300; ++i) {
    // The edge from the first corner to the second passes near 0 and turns by nearly half a turn.
    const long a = random.integer(-9, -1);
    const long b = random.integer(1, 9);
    const long height = random.integer(-3, 1);
    const long tip = random.integer(-9, 9);
    ControlNet net =
        power_net(static_cast<int>(random.integer(2, 4)), {{{b, height}, {a, height}, {tip, -8}}});
    if (random.chance(50)) skew(random, net);
    INFO("seed " << seed << ", case " << i);
    check_decision(net, limits(300, 40), seen);
    check_decision(net, without_algebra(limits(300, 40)), seen);
  }
  for (const auto& [verdict, count] : seen.verdicts) UNSCOPED_INFO(verdict << ": " << count);
  CHECK(seen.verdicts["injective"] > 10);
  CHECK(seen.verdicts["overlapping"] > 10);
  CHECK(seen.verdicts["reversed"] > 10);
  CHECK(seen.verdicts["undecided"] > 10);
}

TEST_CASE("decisions with and without the filter are the same where doubles overflow") {
  // Differences of these coordinates are no doubles; nor is det J.
  const std::uint64_t seed = seed_or(353);
  Random random(seed);
  Seen seen;
  for (int i = 0; i < 200; ++i) {
    const auto shapes = element_shapes(3, 2);
    const Shape shape =
        shapes[static_cast<std::size_t>(random.integer(0, static_cast<long>(shapes.size()) - 1))];
    ControlNet net = random_net(random, shape, Points::small_integers, random_weights(random));
    const double largest = std::numeric_limits<double>::max();
    for (auto* coordinates : {&net.x, &net.y}) {
      for (Rational& c : *coordinates) c *= Rational(largest) / 2;
    }
    if (i % 2 == 0) {  // regular ones
      net = identity_net(shape, 2);
      for (Rational& x : net.x) x = (x - 1) * Rational(largest);
      for (Rational& y : net.y) y = (y - 1) * Rational(largest);
    }
    INFO("seed " << seed << ", case " << i);
    check_decision(net, limits(100, 40), seen);
  }
  for (const auto& [verdict, count] : seen.verdicts) UNSCOPED_INFO(verdict << ": " << count);
  CHECK(seen.verdicts["injective"] >= 100);
  CHECK(seen.verdicts["folded"] > 30);
  CHECK(seen.exact_with_filter > 150);
}

TEST_CASE("decisions with and without the filter are the same in every part: det J that touches zero") {
  const std::uint64_t seed = seed_or(352);
  Random random(seed);
  Seen seen;
  long verdict_wrong = 0;
  for (int i = 0; i < 400; ++i) {
    const Domain domain = random.chance(50) ? Domain::triangle : Domain::square;
    const int side = static_cast<int>(random.integer(-1, 1));
    const Rational raised = side / Rational(Integer(1) << static_cast<unsigned>(random.integer(10, 60)));
    ControlNet net = net_with_determinant(touching_polynomial(random, domain, raised));
    if (random.chance(30)) {  // keeps the sign of det J: a shear
      for (std::size_t m = 0; m < net.x.size(); ++m) net.x[m] += net.y[m] / 3;
    }
    INFO("seed " << seed << ", case " << i << ", raised by " << raised);
    check_decision(net, limits(200, 60), seen);
    check_decision(net, without_algebra(limits(200, 60)), seen);
    // min det J is `raised` by construction.
    const Element element = bernstein_element(net);
    const Decision decision = decide(Forms(element), limits(200, 60));
    const bool right = side > 0    ? is_regular(decision.verdict)
                       : side == 0 ? decision.verdict == ElementVerdict::degenerate
                                   : decision.verdict == ElementVerdict::folded;
    verdict_wrong += !right;
    const DeterminantBounds& b = decision.bounds;
    if (to_rational(b.min_lower) > raised || raised > to_rational(b.min_upper)) {
      INFO(show(net));
      FAIL_CHECK("min det J is not between its bounds");
    }
  }
  for (const auto& [verdict, count] : seen.verdicts) UNSCOPED_INFO(verdict << ": " << count);
  CHECK(verdict_wrong == 0);
  CHECK(seen.verdicts["undecided"] > 20);
  CHECK(seen.verdicts["degenerate"] > 20);
  CHECK(seen.verdicts["folded"] > 20);
  CHECK(seen.verdicts["injective"] > 20);
  CHECK(seen.exact_with_filter > 50);
  CHECK(seen.filter_sufficed > 20);
}
