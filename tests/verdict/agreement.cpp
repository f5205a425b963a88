// What agreement means: every pair of criterion status and exact verdict, written out by hand.
#include "bezcert/verdict/criterion_verdict.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;

namespace {

Agreement agreement(Claim claim, Status status, ElementVerdict verdict, bool with_witness = false) {
  Verdict said;
  said.claim = claim;
  said.status = status;
  Decision decision;
  decision.verdict = verdict;
  if (with_witness) decision.witness = Witness{Parameter(Domain::triangle, {1, 0, 0}), -1, {0, 0}};
  return compare(said, decision);
}

constexpr auto consistent = Agreement::consistent;
constexpr auto gap = Agreement::strength_gap;
constexpr auto wrong = Agreement::contradiction;

}  // namespace

TEST_CASE("agreement of every status with every verdict") {
  struct Row {
    Claim claim;
    Status status;
    // injective, regular, overlapping, degenerate, folded, reversed, undecided
    Agreement expected[7];
  };
  const Row rows[] = {
      {Claim::regular, Status::proved, {consistent, consistent, consistent, wrong, wrong, wrong, consistent}},
      {Claim::regular,
       Status::refuted,
       {wrong, wrong, wrong, consistent, consistent, consistent, consistent}},
      {Claim::regular, Status::inconclusive, {gap, gap, gap, consistent, consistent, consistent, consistent}},
      {Claim::injective, Status::proved, {consistent, consistent, wrong, wrong, wrong, wrong, consistent}},
      {Claim::injective,
       Status::refuted,
       {wrong, consistent, consistent, consistent, consistent, consistent, consistent}},
      {Claim::injective,
       Status::inconclusive,
       {gap, consistent, consistent, consistent, consistent, consistent, consistent}},
  };
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < element_verdicts.size(); ++i) {
      INFO(name(row.claim) << " " << name(row.status) << " against " << name(element_verdicts[i]));
      CHECK(agreement(row.claim, row.status, element_verdicts[i]) == row.expected[i]);
      CHECK(agreement(row.claim, Status::not_applicable, element_verdicts[i]) == consistent);
    }
  }
}

TEST_CASE("an undecided element with a witness refutes what proves det J > 0") {
  CHECK(agreement(Claim::regular, Status::proved, ElementVerdict::undecided, true) == wrong);
  CHECK(agreement(Claim::injective, Status::proved, ElementVerdict::undecided, true) == wrong);
  CHECK(agreement(Claim::regular, Status::refuted, ElementVerdict::undecided, true) == consistent);
}
