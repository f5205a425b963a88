// Blocks against exact arithmetic: what a block says is true, and its enclosures contain the exact numbers,
// on elements made to break its error bounds.
#include "batch/hostile_mesh.hpp"

#include "bezcert/decide/injectivity.hpp"
#include "bezcert/element/forms.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// The four extremes of DeterminantBounds, from integers: another way than blocks and intervals.
std::array<Rational, 4> exact_extremes(const Element& element) {
  const Forms forms(element, Filter::off);
  const auto& [numerator, weight] = forms.exact_jacobian();
  const Rational scale = forms.exact().scale;
  const Rational factor = Rational(degree_factor(element.shape())) * scale * scale /
                          Rational(numerator_multiple(numerator.shape));
  const auto cube = [](const Integer& w) { return Rational(w * w * w); };
  const auto [low, high] = range(numerator);
  const auto [thin, thick] = range(weight);
  std::vector<Rational> corners;
  const auto at = corner_indices(numerator.shape), weight_at = corner_indices(weight.shape);
  for (std::size_t k = 0; k < at.size(); ++k) {
    corners.push_back(Rational(numerator.coefficients[at[k]]) / cube(weight.coefficients[weight_at[k]]));
  }
  const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
  return {Rational(low) / cube(thick) * factor, *least * factor, *most * factor,
          Rational(high) / cube(thin) * factor};
}

bool all_positive(const Element& element) {
  const Forms forms(element, Filter::off);
  const auto& coefficients = forms.exact_jacobian().numerator.coefficients;
  return std::all_of(coefficients.begin(), coefficients.end(), [](const Integer& c) { return c.sign() > 0; });
}

struct Seen {
  long cases = 0, settled = 0, rational = 0, hull = 0, enclosures = 0, barely = 0;
  long tighter_would_fail = 0;  // enclosures that 1/1024 of the error bound would not give
};

std::string show(const DoubleNet& net) {
  std::ostringstream text;
  text << (net.shape.domain == Domain::triangle ? "triangle " : "square ") << net.shape.degree(0) << " "
       << net.shape.degree(1) << (net.basis == Basis::lagrange ? " lagrange" : " bernstein") << std::hexfloat;
  for (std::size_t i = 0; i < net.x.size(); ++i) {
    text << " (" << net.x[i] << "," << net.y[i];
    if (!net.w.empty()) text << "," << net.w[i];
    text << ")";
  }
  return text.str();
}

void check(const DoubleNet& net, Seen& seen) {
  const bool rational =
      !net.w.empty() && std::any_of(net.w.begin(), net.w.end(), [&](double w) { return w != net.w[0]; });
  const batch::BlockTable* table = batch::find_block_table(net.shape, net.basis, rational);
  if (table == nullptr) return;
  const Mesh mesh = mesh_of(net);
  const batch::Nodes nodes{mesh.coordinates(0).doubles().data(), mesh.coordinates(1).doubles().data(),
                           net.w.empty() ? nullptr : mesh.weights().doubles().data(),
                           mesh.connectivity().data()};
  const std::size_t first[batch::lane_count] = {};
  batch::BlockResult block;
  batch::run_block_baseline(*table, nodes, first, block);
  ++seen.cases;
  if (!block.settled[0]) return;
  ++seen.settled;
  seen.rational += rational;
  const Element element = mesh.element(0);
  if (!all_positive(element)) {
    INFO(show(net));
    FAIL_CHECK("settled, but a coefficient of N is not positive");
    return;
  }
  // The hull test is the expensive one: of every degree, but not always.
  if (net.shape.degree(0) <= 3 && net.shape.degree(1) <= 2 && seen.settled % 4 == 0) {
    ++seen.hull;
    const auto proof = prove_injective(Forms(element, Filter::off));
    if (proof != (table->midpoint ? InjectivityProof::midpoint : InjectivityProof::jacobian_hull)) {
      INFO(show(net));
      FAIL_CHECK("settled, but jacobian_hull does not hold");
    }
  }
  const auto exact = exact_extremes(element);
  for (int k = 0; k < 4; ++k) {
    const double lower = block.lower[k][0], upper = block.upper[k][0];
    const double middle = lower + (upper - lower) / 2, part = (upper - lower) / 2048;
    ++seen.enclosures;
    if (!(Rational(lower) <= exact[k] && exact[k] <= Rational(upper))) {
      INFO(show(net));
      FAIL_CHECK("bound " << k << " is outside of its enclosure");
    }
    seen.tighter_would_fail += exact[k] < Rational(middle - part) || exact[k] > Rational(middle + part);
    if (k == 0) seen.barely += upper > 2 * lower;
  }
}

void attack(std::uint64_t seed, long cases) {
  Random random(seed);
  Seen seen;
  for (long i = 0; i < cases; ++i) {
    INFO("seed " << seed << ", case " << i);
    check(hostile_net(random), seen);
  }
  INFO("seed " << seed << ": " << seen.cases << " cases, " << seen.settled << " settled, " << seen.rational
               << " rational, " << seen.hull << " hulls, " << seen.barely << " barely, "
               << seen.tighter_would_fail << " of " << seen.enclosures << " need 1/1024 of the bound");
  CHECK(seen.cases > cases / 2);
  CHECK(seen.settled > cases / 5);
  CHECK(seen.rational > cases / 100);
  CHECK(seen.hull > cases / 50);
  CHECK(seen.barely > cases / 2000);
  // The attack is strong: bounds 1000 times smaller would have failed it.
  CHECK(seen.tighter_would_fail > cases / 100);
}

}  // namespace

TEST_CASE("what blocks say is exactly true: 200,000 hostile elements") { attack(seed_or(505), 200000); }

TEST_CASE("what blocks say is exactly true: 10 million hostile elements", "[.nightly]") {
  attack(seed_or(506), 10000000);
}

#ifdef __x86_64__
TEST_CASE("all instruction sets give the same bits") {
  const std::uint64_t seed = seed_or(507);
  Random random(seed);
  std::vector<batch::BlockFunction*> functions;
  if (__builtin_cpu_supports("avx2")) functions.push_back(batch::run_block_avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq")) {
    functions.push_back(batch::run_block_avx512);
  }
  for (int i = 0; i < 2000; ++i) {
    const DoubleNet net = hostile_net(random);
    const auto* table = batch::find_block_table(net.shape, net.basis, !net.w.empty());
    if (table == nullptr) continue;
    const Mesh mesh = mesh_of(net);
    const batch::Nodes nodes{mesh.coordinates(0).doubles().data(), mesh.coordinates(1).doubles().data(),
                             net.w.empty() ? nullptr : mesh.weights().doubles().data(),
                             mesh.connectivity().data()};
    const std::size_t first[batch::lane_count] = {};
    batch::BlockResult expected;
    batch::run_block_baseline(*table, nodes, first, expected);
    for (const auto run : functions) {
      batch::BlockResult other;
      run(*table, nodes, first, other);
      INFO("seed " << seed << ", case " << i << ": " << show(net));
      REQUIRE(other.settled[0] == expected.settled[0]);
      if (!expected.settled[0]) continue;
      for (int k = 0; k < 4; ++k) {
        REQUIRE(other.lower[k][0] == expected.lower[k][0]);
        REQUIRE(other.upper[k][0] == expected.upper[k][0]);
      }
    }
  }
}
#endif
