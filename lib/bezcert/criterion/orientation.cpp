#include "bezcert/criterion/orientation.hpp"

#include "bezcert/bernstein/table_cache.hpp"
#include "bezcert/criterion/form_signs.hpp"
#include "bezcert/criterion/quick_net.hpp"

#include <array>

namespace bezcert {
namespace {

using Triple = std::array<std::uint16_t, 3>;

struct Failure {
  Triple triple;
  bool at_corner;
};

int index_orientation(const Exponents& a, const Exponents& b, const Exponents& c) {
  const int turn = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  return (turn > 0) - (turn < 0);
}

// The triple at a corner.
Triple corner_triple(int n, int corner) {
  Triple result{};
  for (int k = 0; k < 3; ++k) {
    Exponents exponents{};
    exponents[corner] = n - 1;
    exponents[(corner + k) % 3] += 1;
    result[k] = static_cast<std::uint16_t>(triangle_index(n, exponents));
  }
  return result;
}

// The first triple for which test(triple) is true, of all whose indices are not collinear, put
// counter-clockwise.
template <class Test>
std::optional<Triple> find_triple(int n, Test test) {
  const std::size_t count = coefficient_count(Shape::triangle(n));
  std::vector<Exponents> exponents;
  for (std::size_t i = 0; i < count; ++i) exponents.push_back(triangle_exponents(n, i));
  for (std::uint16_t a = 0; a < count; ++a) {
    for (auto b = static_cast<std::uint16_t>(a + 1); b < count; ++b) {
      for (auto c = static_cast<std::uint16_t>(b + 1); c < count; ++c) {
        const int turn = index_orientation(exponents[a], exponents[b], exponents[c]);
        const Triple triple = turn > 0 ? Triple{a, b, c} : Triple{a, c, b};
        if (turn != 0 && test(triple)) return triple;
      }
    }
  }
  return std::nullopt;
}

const std::vector<Triple>& triples_of(int n) {
  static TableCache<std::vector<Triple>> cache;
  return cache.get(Shape::triangle(n), [](Shape shape) {
    std::vector<Triple> result;
    find_triple(shape.degree(0), [&](const Triple& triple) {
      result.push_back(triple);
      return false;
    });
    return result;
  });
}

template <class Signs>
std::optional<Failure> failure(const Signs& signs) {
  const int n = signs.degree();
  const auto turn = [&](const Triple& t) { return signs.orientation(t[0], t[1], t[2]); };
  for (int corner = 0; corner < 3; ++corner) {
    const Triple triple = corner_triple(n, corner);
    if (turn(triple) <= 0) return Failure{triple, true};
  }
  if (n > QuickNet::max_degree) {  // too many triples to keep
    const auto triple = find_triple(n, [&](const Triple& t) { return turn(t) < 0; });
    return triple ? std::optional(Failure{*triple, false}) : std::nullopt;
  }
  for (const Triple& triple : triples_of(n)) {
    if (turn(triple) < 0) return Failure{triple, false};
  }
  return std::nullopt;
}

std::string words(int n, const Failure& failed) {
  auto [a, b, c] = failed.triple;
  if (!failed.at_corner && b > c) std::swap(b, c);
  return "control points " + exponents_text(n, {a, b, c}) +
         (failed.at_corner ? " at a corner are not counter-clockwise"
                           : " are not oriented like their indices");
}

}  // namespace

Verdict orientation_condition(const Forms& forms) {
  if (!forms.element().is_triangle()) {
    return begin_verdict(orientation_info, Status::not_applicable, "stated for triangles");
  }
  const FormSigns signs(forms);
  const auto failed = failure(signs);
  if (!failed) return begin_verdict(orientation_info, Status::proved);
  return begin_verdict(orientation_info, Status::inconclusive, words(signs.degree(), *failed));
}

std::optional<Status> quick_orientation(const QuickNet& net) {
  return failure(net) ? Status::inconclusive : Status::proved;
}

}  // namespace bezcert
