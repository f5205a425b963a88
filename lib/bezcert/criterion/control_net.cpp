#include "bezcert/criterion/control_net.hpp"

#include "bezcert/criterion/form_signs.hpp"
#include "bezcert/criterion/quick_net.hpp"

namespace bezcert {
namespace {

struct Failure {
  std::size_t corner, right, up;  // the control triangle
  int turn;
};

template <class Signs>
std::optional<Failure> failure(const Signs& signs) {
  const int n = signs.degree();
  const Shape shape = Shape::triangle(n);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n - r; ++c) {
      const std::size_t corner = coefficient_index(shape, r, c), right = coefficient_index(shape, r, c + 1),
                        up = coefficient_index(shape, r + 1, c);
      const int turn = signs.orientation(corner, right, up);
      if (turn <= 0) return Failure{corner, right, up, turn};
    }
  }
  return std::nullopt;
}

}  // namespace

Verdict control_net(const Forms& forms) {
  const Element& element = forms.element();
  if (!element.is_triangle() || element.rational()) {
    return begin_verdict(control_net_info, Status::not_applicable,
                         element.is_triangle() ? "stated for equal weights" : "stated for triangles");
  }
  const auto failed = failure(FormSigns(forms));
  if (!failed) return begin_verdict(control_net_info, Status::proved);
  return begin_verdict(
      control_net_info, Status::inconclusive,
      "control triangle " +
          exponents_text(element.shape().degree(0), {failed->corner, failed->right, failed->up}) +
          (failed->turn == 0 ? " is degenerate" : " is clockwise"));
}

std::optional<Status> quick_control_net(const QuickNet& net) {
  return failure(net) ? Status::inconclusive : Status::proved;
}

}  // namespace bezcert
