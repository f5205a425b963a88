#include "bezcert/criterion/orientation.hpp"

#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/element/forms.hpp"

#include <array>

namespace bezcert {
namespace {

int index_orientation(const Exponents& a, const Exponents& b, const Exponents& c) {
  const int turn = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  return (turn > 0) - (turn < 0);
}

// The three corner triples, which must turn left.
std::array<std::array<std::size_t, 3>, 3> corner_triples(int n) {
  std::array<std::array<std::size_t, 3>, 3> result{};
  for (int corner = 0; corner < 3; ++corner) {
    std::array<Exponents, 3> triple{};
    for (int k = 0; k < 3; ++k) {
      triple[k][corner] = n - 1;
      triple[k][(corner + k) % 3] += 1;
    }
    for (int k = 0; k < 3; ++k) result[corner][k] = triangle_index(n, triple[k]);
  }
  return result;
}

// All triples with the indices counter-clockwise.
struct Triples {
  std::vector<std::array<std::uint16_t, 3>> list;
};

const Triples& triples_of(Shape shape) {
  static TableCache<Triples> cache;
  return cache.get(shape, [](Shape s) {
    Triples result;
    const std::size_t count = coefficient_count(s);
    std::vector<Exponents> exponents;
    for (std::size_t i = 0; i < count; ++i) exponents.push_back(triangle_exponents(s.degree(0), i));
    for (std::uint16_t a = 0; a < count; ++a) {
      for (auto b = static_cast<std::uint16_t>(a + 1); b < count; ++b) {
        for (auto c = static_cast<std::uint16_t>(b + 1); c < count; ++c) {
          const int turn = index_orientation(exponents[a], exponents[b], exponents[c]);
          if (turn > 0) result.list.push_back({a, b, c});
          if (turn < 0) result.list.push_back({a, c, b});
        }
      }
    }
    return result;
  });
}

}  // namespace

Verdict orientation_condition(const Forms& forms) {
  Verdict verdict = begin_verdict(orientation_info, Status::not_applicable);
  if (!forms.element().is_triangle()) {
    verdict.reason = "stated for triangles";
    return verdict;
  }
  const int n = forms.element().shape().degree(0);
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    return forms.sign_of([&](const auto& net) { return orientation(net, a, b, c); });
  };
  const auto fail = [&](std::size_t a, std::size_t b, std::size_t c, const char* what) {
    verdict.status = Status::inconclusive;
    verdict.reason = "control points " + exponents_text(n, {a, b, c}) + what;
    return verdict;
  };

  for (const auto& [a, b, c] : corner_triples(n)) {
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

std::optional<Status> quick_orientation(const QuickNet& net) {
  for (const auto& [a, b, c] : corner_triples(net.degree())) {
    if (net.orientation(a, b, c) <= 0) return Status::inconclusive;
  }
  for (const auto& [a, b, c] : triples_of(Shape::triangle(net.degree())).list) {
    if (net.orientation(a, b, c) < 0) return Status::inconclusive;
  }
  return Status::proved;
}

}  // namespace bezcert
