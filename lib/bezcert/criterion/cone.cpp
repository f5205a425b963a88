#include "bezcert/criterion/cone.hpp"

#include "bezcert/criterion/form_signs.hpp"
#include "bezcert/criterion/quick_net.hpp"

#include <array>

namespace bezcert {
namespace {

enum class Condition { end_weight, weight, control_vector, auxiliary_vector, blue, red, row, column };

// A condition that fails first, in row i away from the edge, at place j along it.
struct Failure {
  Condition condition;
  int i, j;
};

using Failed = std::optional<Failure>;

// The net as seen from one edge.
template <class Signs>
class EdgeCheck {
 public:
  EdgeCheck(const Signs& signs, int edge)
      : signs_(signs),
        edge_(edge),
        n_(signs.degree()),
        shape_(Shape::triangle(n_)),
        d_(n_ == 1 ? Vector{at(0, 0), at(0, 1)} : Vector{at(1, 0), at(1, n_ - 1)}) {}

  Failed failure() const {
    Failed failed = weights();
    if (!failed) failed = guardable();
    if (!failed) failed = cones();
    if (!failed) failed = parallel(Condition::row, 0, 1, d_);
    if (!failed) failed = parallel(Condition::column, 1, 0, {at(0, 0), at(1, 0)});
    return failed;
  }

 private:
  struct Vector {
    std::size_t from, to;
  };

  std::size_t at(int i, int j) const { return edge_index(shape_, edge_, i, j); }
  Vector control_vector(int k) const { return {at(0, k), at(0, k + 1)}; }
  // In nets that are not rational p'_k = p_k: what is asked of p_k is not asked again.
  std::size_t auxiliary(int k) const { return signs_.auxiliary(edge_, k); }
  Vector auxiliary_vector(int k) const { return {auxiliary(k), auxiliary(k + 1)}; }

  int turn(const Vector& a, const Vector& b) const { return signs_.turn(a.from, a.to, b.from, b.to); }
  int forward(const Vector& a, const Vector& b) const { return signs_.forward(a.from, a.to, b.from, b.to); }
  bool same_direction(const Vector& a, const Vector& b) const { return turn(a, b) == 0 && forward(a, b) > 0; }

  // Condition 2, and Definition 5's normalisation: end weights 1.
  Failed weights() const {
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j <= n_ - i; ++j) {
        const bool end = j == 0 || j == n_;
        if (i == 0 && !end) continue;
        if (!signs_.equal_weights(at(i, j), at(n_, 0))) {
          return Failure{i == 0 ? Condition::end_weight : Condition::weight, i, j};
        }
      }
    }
    return std::nullopt;
  }

  Failed guardable() const {
    for (int k = 0; k < n_; ++k) {
      if (forward(d_, control_vector(k)) <= 0) return Failure{Condition::control_vector, 0, k};
      if (signs_.rational() && forward(d_, auxiliary_vector(k)) <= 0) {
        return Failure{Condition::auxiliary_vector, 0, k};
      }
    }
    return std::nullopt;
  }

  // Condition 3: p_1i in the blue cone of p_i and in the red cone of p'_i. Number -1 among the v_k is d.
  Failed cones() const {
    for (int i = 0; i < n_; ++i) {
      for (int k = -1; k < n_; ++k) {
        if (turn(k < 0 ? d_ : control_vector(k), {at(0, i), at(1, i)}) <= 0) {
          return Failure{Condition::blue, 1, i};
        }
        if (signs_.rational() && turn(k < 0 ? d_ : auxiliary_vector(k), {auxiliary(i), at(1, i)}) <= 0) {
          return Failure{Condition::red, 1, i};
        }
      }
    }
    return std::nullopt;
  }

  // Conditions 4 and 5: from row 1 on, steps along the rows, or across, have the direction of a reference.
  Failed parallel(Condition condition, int across, int along, const Vector& reference) const {
    for (int i = 1; i < n_; ++i) {
      for (int j = 0; i + j < n_; ++j) {
        if (!same_direction({at(i, j), at(i + across, j + along)}, reference))
          return Failure{condition, i, j};
      }
    }
    return std::nullopt;
  }

  const Signs& signs_;
  int edge_;
  int n_;
  Shape shape_;
  Vector d_;
};

std::string words(const Failure& failed) {
  const std::string row_place = " at row " + std::to_string(failed.i) + ", place " + std::to_string(failed.j);
  const std::string number = std::to_string(failed.j);
  switch (failed.condition) {
    case Condition::end_weight: return "end weights (not equal to the tip's)" + row_place;
    case Condition::weight: return "condition 2 (weight not 1)" + row_place;
    case Condition::control_vector: return "guardability (control vector " + number + ")";
    case Condition::auxiliary_vector: return "guardability (auxiliary control vector " + number + ")";
    case Condition::blue: return "condition 3 (blue cone)" + row_place;
    case Condition::red: return "condition 3 (red cone)" + row_place;
    case Condition::row: return "condition 4 (row not parallel to d)" + row_place;
    case Condition::column: return "condition 5 (not parallel to the left side)" + row_place;
  }
  return {};
}

// What fails for each edge; nothing if all conditions hold for one.
template <class Signs>
std::optional<std::array<Failure, 3>> failures(const Signs& signs) {
  std::array<Failure, 3> result{};
  for (int edge = 0; edge < 3; ++edge) {
    const Failed failed = EdgeCheck(signs, edge).failure();
    if (!failed) return std::nullopt;
    result[static_cast<std::size_t>(edge)] = *failed;
  }
  return result;
}

}  // namespace

Verdict cone(const Forms& forms) {
  if (!forms.element().is_triangle()) {
    return begin_verdict(cone_info, Status::not_applicable, "stated for triangles");
  }
  const auto failed = failures(FormSigns(forms));
  if (!failed) return begin_verdict(cone_info, Status::proved);
  std::string reason;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    reason += (edge > 0 ? "; edge " : "edge ") + std::to_string(edge) + ": " + words((*failed)[edge]);
  }
  return begin_verdict(cone_info, Status::inconclusive, reason);
}

std::optional<Status> quick_cone(const QuickNet& net) {
  return failures(net) ? Status::inconclusive : Status::proved;
}

}  // namespace bezcert
