// The order of Bernstein coefficients on one simplex of dimension 1 to 3, and walks through them.
//
// The coefficient with exponents m = (m_0, ..., m_d), sum of the degree, stands where the exponents of the
// last corners come first: by m_d, then by m_(d-1), ..., last by m_1. So lines towards corner 1 lie together,
// and on a triangle rows run along m_2 and columns along m_1.
#pragma once

#include <array>
#include <cstddef>

namespace bezcert {

/// The largest dimension of a domain, and so of one simplex and of a list of simplices.
inline constexpr int max_dimension = 3;

/// The number of coefficients: C(degree + dimension, dimension). Precondition: dimension is 1, 2 or 3.
constexpr std::size_t simplex_count(int dimension, int degree) {
  const auto n = static_cast<std::size_t>(degree);
  std::size_t result = n + 1;
  if (dimension > 1) result = result * (n + 2) / 2;
  if (dimension > 2) result = result * (n + 3) / 3;
  return result;
}

/// The position of the coefficient with exponents m_1, m_2, m_3 (0 beyond the dimension); m_0 is what is left
/// of the degree.
constexpr std::size_t simplex_position(int degree, const std::array<int, max_dimension>& exponents) {
  std::size_t result = 0;
  for (int k = max_dimension; k >= 1; --k) {
    const int exponent = exponents[static_cast<std::size_t>(k) - 1];
    if (exponent == 0) continue;
    result += simplex_count(k, degree) - simplex_count(k, degree - exponent);
    degree -= exponent;
  }
  return result;
}

/// A coefficient of some degree, and how it lies to those of one degree more.
struct SimplexPoint {
  std::size_t position = 0;
  std::array<int, max_dimension + 1> exponents{};
  /// The positions of the exponents with one more at corner k, in one degree more.
  std::array<std::size_t, max_dimension + 1> raised{};
};

/// Calls visit(position of the first, number, {m_2, m_3}) for every line of coefficients towards corner 1, in
/// order.
template <class Visit>
void for_each_simplex_line(int dimension, int degree, Visit visit) {
  std::size_t first = 0;
  for (int layer = 0; layer <= (dimension > 2 ? degree : 0); ++layer) {
    for (int row = 0; row <= (dimension > 1 ? degree - layer : 0); ++row) {
      const auto count = static_cast<std::size_t>(degree - layer - row) + 1;
      visit(first, count, std::array{row, layer});
      first += count;
    }
  }
}

/// Calls visit(SimplexPoint) for every coefficient, in order. This walk is de Casteljau's algorithm, degree
/// elevation and differentiation alike: they relate m to m + e_k.
template <class Visit>
void for_each_simplex_point(int dimension, int degree, Visit visit) {
  for_each_simplex_line(dimension, degree,
                        [&](std::size_t first, std::size_t count, const std::array<int, 2>& line) {
                          const auto [row, layer] = line;
                          SimplexPoint at;
                          at.position = first;
                          at.exponents = {static_cast<int>(count) - 1, 0, row, layer};
                          at.raised[0] = simplex_position(degree + 1, {0, row, layer});
                          at.raised[1] = at.raised[0] + 1;
                          if (dimension > 1) at.raised[2] = simplex_position(degree + 1, {0, row + 1, layer});
                          if (dimension > 2) at.raised[3] = simplex_position(degree + 1, {0, row, layer + 1});
                          for (std::size_t i = 0; i < count; ++i) {
                            visit(at);
                            ++at.position;
                            --at.exponents[0];
                            ++at.exponents[1];
                            for (std::size_t& position : at.raised) ++position;
                          }
                        });
}

}  // namespace bezcert
