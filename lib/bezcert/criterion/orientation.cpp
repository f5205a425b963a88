#include "bezcert/criterion/orientation.hpp"

#include "bezcert/criterion/triangle_index.hpp"

#include <array>

namespace bezcert {
namespace {

int index_orientation(const Exponents& a, const Exponents& b, const Exponents& c) {
  const int turn = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  return (turn > 0) - (turn < 0);
}

}  // namespace

Verdict orientation_condition(const Forms& forms) {
  Verdict verdict = begin_verdict(orientation_info, Status::not_applicable);
  if (!forms.element().is_triangle()) {
    verdict.reason = "stated for triangles";
    return verdict;
  }
  const RoundingScope scope;
  const int n = forms.element().shape().p;
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    return forms.sign_of(scope, [&](const auto& net) { return orientation(net, a, b, c); });
  };
  const auto fail = [&](std::size_t a, std::size_t b, std::size_t c, const char* what) {
    verdict.status = Status::inconclusive;
    verdict.reason = "control points " + exponents_text(n, {a, b, c}) + what;
    return verdict;
  };

  for (int corner = 0; corner < 3; ++corner) {
    std::array<Exponents, 3> triple{};
    for (int k = 0; k < 3; ++k) {
      triple[k][corner] = n - 1;
      triple[k][(corner + k) % 3] += 1;
    }
    const std::size_t a = triangle_index(n, triple[0]);
    const std::size_t b = triangle_index(n, triple[1]);
    const std::size_t c = triangle_index(n, triple[2]);
    if (turn(a, b, c) <= 0) return fail(a, b, c, " at a corner are not counter-clockwise");
  }

  const std::size_t count = coefficient_count(forms.element().shape());
  std::vector<Exponents> exponents;
  for (std::size_t i = 0; i < count; ++i) exponents.push_back(triangle_exponents(n, i));
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      for (std::size_t c = b + 1; c < count; ++c) {
        const int expected = index_orientation(exponents[a], exponents[b], exponents[c]);
        if (expected != 0 && turn(a, b, c) * expected < 0) {
          return fail(a, b, c, " are not oriented like their indices");
        }
      }
    }
  }
  verdict.status = Status::proved;
  return verdict;
}

}  // namespace bezcert
