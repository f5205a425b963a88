#include "bezcert/criterion/control_net.hpp"

#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/criterion/triangle_index.hpp"
#include "bezcert/element/forms.hpp"

namespace bezcert {

Verdict control_net(const Forms& forms) {
  Verdict verdict = begin_verdict(control_net_info, Status::not_applicable);
  const Element& element = forms.element();
  if (!element.is_triangle()) {
    verdict.reason = "stated for triangles";
    return verdict;
  }
  if (element.rational()) {
    verdict.reason = "stated for equal weights";
    return verdict;
  }
  const Shape shape = element.shape();
  for (int r = 0; r < shape.degree(0); ++r) {
    for (int c = 0; c < shape.degree(0) - r; ++c) {
      const std::size_t corner = coefficient_index(shape, r, c);
      const std::size_t right = coefficient_index(shape, r, c + 1);
      const std::size_t up = coefficient_index(shape, r + 1, c);
      const int turn = forms.sign_of([&](const auto& net) { return orientation(net, corner, right, up); });
      if (turn <= 0) {
        verdict.status = Status::inconclusive;
        verdict.reason = "control triangle " + exponents_text(shape.degree(0), {corner, right, up}) +
                         (turn == 0 ? " is degenerate" : " is clockwise");
        return verdict;
      }
    }
  }
  verdict.status = Status::proved;
  return verdict;
}

std::optional<Status> quick_control_net(const QuickNet& net) {
  const Shape shape = Shape::triangle(net.degree());
  for (int r = 0; r < shape.degree(0); ++r) {
    for (int c = 0; c < shape.degree(0) - r; ++c) {
      const int turn = net.orientation(coefficient_index(shape, r, c), coefficient_index(shape, r, c + 1),
                                       coefficient_index(shape, r + 1, c));
      if (turn <= 0) return Status::inconclusive;
    }
  }
  return Status::proved;
}

}  // namespace bezcert
