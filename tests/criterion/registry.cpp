// The list of criteria says of each what docs/criteria.md proves or refutes.
#include "bezcert/element/forms.hpp"
#include "bezcert/element/map.hpp"
#include "bezcert/criterion/criterion.hpp"

#include "random_element.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("names, claims and standings are as documented") {
  struct Known {
    const char* name;
    Claim claim;
    Standing standing;
    bool refuted;
  };
  const Known known[] = {{"control-net", Claim::regular, Standing::claimed, true},
                         {"orientation", Claim::injective, Standing::sound, false},
                         {"cone", Claim::injective, Standing::claimed, true},
                         {"coefficients", Claim::regular, Standing::sound, false},
                         {"subdivision", Claim::regular, Standing::sound, false}};
  REQUIRE(criteria().size() == std::size(known));
  for (std::size_t i = 0; i < std::size(known); ++i) {
    const Criterion& criterion = criteria()[i];
    CHECK(criterion.name == known[i].name);
    CHECK(criterion.claim == known[i].claim);
    CHECK(criterion.standing == known[i].standing);
    CHECK(criterion.refuted == known[i].refuted);
    CHECK(find_criterion(known[i].name) == &criterion);
  }
  CHECK(find_criterion("no-such") == nullptr);
}

TEST_CASE("a verdict names its own criterion and claim, and only a witness refutes") {
  const std::uint64_t seed = seed_or(11);
  Random random(seed);
  int refuted = 0;
  int inconclusive = 0;
  int not_applicable = 0;
  for (int i = 0; i < 500; ++i) {
    const RawElement raw = random_element(random, {});
    const Element element = raw.build();
    const Forms forms(element);
    for (const Criterion& criterion : criteria()) {
      const Verdict verdict = criterion.check(forms);
      INFO("seed " << seed << " case " << i << " " << criterion.name << " " << raw.text());
      CHECK(verdict.criterion == criterion.name);
      CHECK(verdict.claim == criterion.claim);
      CHECK((verdict.status == Status::refuted) == verdict.witness.has_value());
      CHECK((verdict.status == Status::proved) == verdict.reason.empty());
      if (verdict.status == Status::refuted) {
        ++refuted;
        CHECK(evaluate_map(element, verdict.witness->parameter).determinant == verdict.witness->determinant);
        CHECK(verdict.witness->determinant <= 0);
      }
      if (verdict.status == Status::inconclusive) ++inconclusive;
      if (verdict.status == Status::not_applicable) {
        ++not_applicable;
        CHECK((!element.is_triangle() || (criterion.name == "control-net" && element.rational())));
      }
    }
  }
  INFO("seed " << seed);
  CHECK(refuted > 100);
  CHECK(inconclusive > 100);
  CHECK(not_applicable > 100);
}
