// FLINT counts on rounding to nearest: every way to it refuses a thread that rounds otherwise.
#include "bezcert/algebra/algebraic_point.hpp"
#include "bezcert/algebra/fiber.hpp"
#include "bezcert/number/interval.hpp"
#include "polynomials.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <stdexcept>

using namespace bezcert;
using namespace bezcert::test;

TEST_CASE("algebra runs only on a thread that rounds to nearest") {
  const Univariate f = poly({-1, 0, 1}), g = poly({-1, 1});
  const Bivariate h = (V - U) * (V - U - U), line = V - U;
  const RealRoot root{poly({-1, 0, 2}), Rational(1, 2), 1};
  const AlgebraicPoint point{root.polynomial, root.lower, root.upper, {0, 1}, {0, 1}};
  Fiber fiber(root, {h});
  const std::pair<const char*, std::function<void()>> entries[] = {
      {"product", [&] { static_cast<void>(f * g); }},
      {"gcd", [&] { gcd(f, g); }},
      {"exact_quotient", [&] { exact_quotient(f, g); }},
      {"square_free_part", [&] { square_free_part(f); }},
      {"irreducible_factors", [&] { irreducible_factors(f); }},
      {"gcd in two variables", [&] { gcd(h, line); }},
      {"quotient in two variables", [&] { quotient(h, line); }},
      {"irreducible_factors in two variables", [&] { irreducible_factors(h); }},
      {"resultant", [&] { resultant_v(h, line); }},
      {"Fiber", [&] { Fiber(root, {h}); }},
      {"Fiber, rational", [&] { Fiber(rational_root(Rational(1, 3)), {h}); }},
      {"Fiber::count", [&] { fiber.count(Univariate(), poly({1}), Fiber::Ends::included); }},
      {"Fiber::smallest",
       [&] { fiber.smallest(Univariate(), poly({1}), Fiber::Ends::included, Rational(1, 8)); }},
      {"algebraic_point",
       [&] {
         algebraic_point({h}, {root, root});
       }},
      {"value_at", [&] { value_at(h, point); }},
  };
  for (const auto& [name, call] : entries) {
    INFO(name);
    CHECK_NOTHROW(call());
    {
      const RoundUp up;
      CHECK_FALSE(rounds_to_nearest());
      CHECK_THROWS_AS(call(), std::logic_error);
    }
    CHECK(rounds_to_nearest());
  }
}
