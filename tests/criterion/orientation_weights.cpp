// YLC22 Theorem 1 holds for every choice of positive weights: an element it proves stays injective when its
// weights are drawn anew from 1/1000 to 1000.
#include "bezcert/criterion/orientation.hpp"

#include "bezcert/decide/boundary.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "random_element.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("what orientation proves is regular and has a simple boundary for all weights") {
  const std::uint64_t seed = seed_or(13);
  Random random(seed);
  int proved = 0;
  std::array<int, 5> by_degree{};
  for (int i = 0; i < 6000 && proved < 600; ++i) {
    RawElement raw = random_element(random, {.max_degree = 4, .quadrilaterals = false});
    raw.w.clear();
    const Element polynomial = raw.build();
    if (orientation_condition(Forms(polynomial)).status != Status::proved) continue;
    ++proved;
    ++by_degree[static_cast<std::size_t>(raw.shape.degree(0))];
    for (std::size_t k = 0; k < raw.x.size(); ++k) {
      const long size = random.integer(1, 1000);
      raw.w.push_back(random.chance(50) ? Rational(size) : Rational(1, size));
    }
    const Element element = raw.build();
    const Forms forms(element);
    INFO("seed " << seed << " case " << i << " " << raw.text());
    CHECK(orientation_condition(forms).status == Status::proved);
    CHECK(is_regular(decide(forms).verdict));
    // The boundary is examined by other means than the theorem.
    CHECK(examine_boundary(forms).status == BoundaryStatus::simple);
  }
  INFO("seed " << seed);
  CHECK(proved >= 300);
  CHECK(by_degree[2] > 50);
  CHECK(by_degree[3] > 20);
}
