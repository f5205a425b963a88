// No sound criterion ever contradicts the exact decision, and the decision agrees with det J sampled
// exactly by another formula: 100,000 random elements of degrees 1 to 5.
#include "bezcert/check/cross_check.hpp"
#include "random_element.hpp"

#include "bezcert/element/map.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

struct Tally {
  std::map<std::string, int> verdicts;
  std::map<std::string, int> statuses;
  int findings = 0;
  int rational = 0;
  int quadrilaterals = 0;
};

// det J at random parameters, evaluated directly, must have a sign the verdict allows.
bool samples_agree(Random& random, const Element& element, ElementVerdict verdict) {
  for (int k = 0; k < 6; ++k) {
    const int s = sign(evaluate_map(element, random_parameter(random, element.shape().domain)).determinant);
    if (is_regular(verdict) && s <= 0) return false;
    if (verdict == ElementVerdict::degenerate && s < 0) return false;
    if (verdict == ElementVerdict::reversed && s >= 0) return false;
  }
  return true;
}

bool evidence_holds(const Element& element, const Decision& decision) {
  const auto det = [&](const Witness& w) { return evaluate_map(element, w.parameter).determinant; };
  switch (decision.verdict) {
    case ElementVerdict::folded:
      return decision.witness && det(*decision.witness) < 0 && decision.other_witness &&
             det(*decision.other_witness) >= 0;
    case ElementVerdict::degenerate: return decision.witness && det(*decision.witness) == 0;
    case ElementVerdict::overlapping: return decision.overlap.has_value();
    case ElementVerdict::undecided: return !decision.exhausted.empty();
    default: return true;
  }
}

Tally run(std::uint64_t seed, int count) {
  Random random(seed);
  Tally tally;
  Budget budget;
  budget.pieces = 300;
  const std::vector<const Criterion*> all = all_criteria();
  for (int i = 0; i < count; ++i) {
    const RawElement raw = random_element(random, {});
    const Element element = raw.build();
    const CheckedElement checked = check_element(element, all, budget);
    const Decision& decision = checked.decision;
    ++tally.verdicts[std::string(name(decision.verdict))];
    if (element.rational()) ++tally.rational;
    if (!element.is_triangle()) ++tally.quadrilaterals;
    for (const CheckedCriterion& one : checked.criteria) {
      ++tally.statuses[std::string(one.criterion->name) + " " + std::string(name(one.verdict.status))];
      if (one.is_finding()) ++tally.findings;
      if (one.is_defect()) {
        INFO("seed " << seed << " case " << i << " " << raw.text());
        FAIL(one.criterion->name << " contradicts " << name(decision.verdict));
      }
    }
    const bool sound = samples_agree(random, element, decision.verdict) && evidence_holds(element, decision);
    if (!sound) {
      INFO("seed " << seed << " case " << i << " " << raw.text());
      FAIL("evidence or samples contradict " << name(decision.verdict));
    }
  }
  return tally;
}

}  // namespace

TEST_CASE("100,000 random elements: no sound criterion contradicts the decision") {
  const std::uint64_t seed = seed_or(20261122);
  const int count = 100000;
  Tally tally = run(seed, count);
  std::string seen;
  for (const auto& [what, number] : tally.verdicts) seen += what + " " + std::to_string(number) + "; ";
  for (const auto& [what, number] : tally.statuses) seen += what + " " + std::to_string(number) + "; ";
  WARN("seed " << seed << ": " << seen << "findings " << tally.findings);
  // The generator must really have met each kind, or agreement would say nothing.
  CHECK(tally.verdicts["injective"] > 10000);
  CHECK(tally.verdicts["folded"] > 10000);
  CHECK(tally.verdicts["reversed"] > 1000);
  CHECK(tally.verdicts["degenerate"] > 200);
  CHECK(tally.verdicts["injective"] + tally.verdicts["folded"] + tally.verdicts["reversed"] +
            tally.verdicts["degenerate"] + tally.verdicts["overlapping"] + tally.verdicts["regular"] +
            tally.verdicts["undecided"] ==
        count);
  CHECK(tally.verdicts["undecided"] + tally.verdicts["regular"] < count / 100);
  CHECK(tally.rational > 30000);
  CHECK(tally.quadrilaterals > 20000);
  for (const char* what :
       {"control-net proved", "orientation proved", "coefficients proved", "coefficients refuted",
        "coefficients inconclusive", "subdivision proved", "subdivision refuted"}) {
    INFO(what);
    CHECK(tally.statuses[what] > 1000);
  }
  CHECK(tally.findings > 0);
}
