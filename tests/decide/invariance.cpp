// Verdicts do not depend on how an element is written: affine maps, corner permutation, weight scaling,
// projective reparametrisation and degree elevation keep them, and mirrors exchange regular and reversed.
#include "bezcert/criterion/coefficients.hpp"
#include "bezcert/criterion/orientation.hpp"
#include "bezcert/criterion/subdivision.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "random_element.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

struct Judgement {
  ElementVerdict verdict;
  Status coefficients, orientation, subdivision;
  std::vector<int> corner_signs;  // of N, sorted

  bool operator==(const Judgement&) const = default;
};

Judgement judge(const RawElement& raw) {
  const Element element = raw.build();
  const Forms forms(element);
  Budget budget;
  budget.pieces = 400;
  Judgement result{decide(forms, budget).verdict,
                   coefficients(forms).status,
                   orientation_condition(forms).status,
                   subdivision(forms).status,
                   {}};
  const Polynomial<Integer>& n = forms.exact_jacobian().numerator;
  for (const std::size_t i : corner_indices(n.shape)) result.corner_signs.push_back(sign(n.coefficients[i]));
  std::sort(result.corner_signs.begin(), result.corner_signs.end());
  return result;
}

// Budgets cut at places that depend on where the pieces lie: such cases say nothing here.
bool is_final(const Judgement& j) {
  return j.verdict != ElementVerdict::undecided && j.verdict != ElementVerdict::regular &&
         j.subdivision != Status::inconclusive;
}

template <class Transform, class Expect>
void check_transform(std::uint64_t seed, int count, const Recipe& recipe, Transform transform,
                     Expect expect) {
  Random random(seed);
  std::map<ElementVerdict, int> seen;
  int compared = 0;
  for (int i = 0; i < count; ++i) {
    const RawElement before = random_element(random, recipe);
    const std::optional<RawElement> after = transform(before, random);
    if (!after) continue;
    const Judgement a = judge(before);
    const Judgement b = judge(*after);
    if (!is_final(a) || !is_final(b)) continue;
    ++compared;
    ++seen[a.verdict];
    if (!expect(a, b)) {
      INFO("seed " << seed << " case " << i << " before " << before.text() << " after " << after->text());
      FAIL(name(a.verdict) << " became " << name(b.verdict) << ", or a criterion changed");
    }
  }
  INFO("seed " << seed);
  CHECK(compared > count / 4);
  CHECK(seen[ElementVerdict::injective] > count / 40);
  CHECK(seen[ElementVerdict::folded] > count / 40);
  CHECK(seen[ElementVerdict::reversed] > 0);
}

const auto same = [](const Judgement& a, const Judgement& b) { return a == b; };

}  // namespace

TEST_CASE("affine maps that keep the orientation keep every verdict") {
  check_transform(
      seed_or(1), 1500, {},
      [](const RawElement& e, Random& random) -> std::optional<RawElement> {
        std::array<Rational, 6> m;
        for (Rational& value : m) value = Rational(random.integer(-9, 9), random.integer(1, 7));
        if (m[0] * m[3] - m[1] * m[2] <= 0) return std::nullopt;
        return affine(e, m);
      },
      same);
}

TEST_CASE("a rotation of the corners keeps every verdict") {
  check_transform(
      seed_or(2), 1500, {}, [](const RawElement& e, Random&) { return std::optional(rotate_corners(e)); },
      same);
}

TEST_CASE("a mirror exchanges injective and reversed and keeps the others") {
  int reversed_to_injective = 0;
  check_transform(
      seed_or(3), 1500, {},
      [](const RawElement& e, Random& random) {
        return std::optional(random.chance(50) ? swap_parameters(e) : affine(e, {-1, 0, 0, 1, 0, 0}));
      },
      [&](const Judgement& a, const Judgement& b) {
        if (a.verdict == ElementVerdict::reversed) ++reversed_to_injective;
        // A reversed element may overlap when mirrored, a degenerate one becomes folded or stays (N = 0).
        if (a.verdict == ElementVerdict::injective) return b.verdict == ElementVerdict::reversed;
        if (a.verdict == ElementVerdict::reversed) return is_regular(b.verdict);
        if (a.verdict == ElementVerdict::degenerate) {
          return b.verdict == ElementVerdict::folded || b.verdict == ElementVerdict::degenerate;
        }
        return true;
      });
  CHECK(reversed_to_injective > 50);
}

TEST_CASE("one factor on all weights keeps every verdict") {
  check_transform(
      seed_or(4), 2000, {},
      [](const RawElement& e, Random& random) -> std::optional<RawElement> {
        if (e.w.empty()) return std::nullopt;
        return scale_weights(e, Rational(random.integer(1, 1000), random.integer(1, 1000)));
      },
      same);
}

TEST_CASE("projective reparametrisation keeps every verdict") {
  check_transform(
      seed_or(5), 2500, {},
      [](const RawElement& e, Random& random) -> std::optional<RawElement> {
        if (!e.build().rational()) return std::nullopt;
        const auto factor = [&] { return Rational(random.integer(1, 6), random.integer(1, 6)); };
        RawElement result = reparametrise(e, factor(), factor(), factor());
        // Equal weights would make it polynomial, with N of another degree.
        if (!result.build().rational()) return std::nullopt;
        return result;
      },
      [](const Judgement& a, const Judgement& b) {
        return a.verdict == b.verdict && a.coefficients == b.coefficients && a.orientation == b.orientation &&
               a.corner_signs == b.corner_signs;
      });
}

TEST_CASE("degree elevation keeps the verdict, and a proof by coefficients") {
  int stronger = 0;
  check_transform(
      seed_or(6), 1200, {.max_degree = 3},
      [](const RawElement& e, Random&) { return std::optional(elevate_element(e)); },
      [&](const Judgement& a, const Judgement& b) {
        if (a.coefficients == Status::inconclusive && b.coefficients == Status::proved) ++stronger;
        return a.verdict == b.verdict && a.corner_signs == b.corner_signs &&
               (a.coefficients != Status::proved || b.coefficients == Status::proved) &&
               (a.coefficients != Status::refuted || b.coefficients == Status::refuted);
      });
  CHECK(stronger > 0);
}
