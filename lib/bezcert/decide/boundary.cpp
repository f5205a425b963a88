#include "bezcert/decide/boundary.hpp"

#include <vector>

namespace bezcert {
namespace {

template <class T>
CurveNet<T> edge_net(const Net<T>& net, int edge) {
  CurveNet<T> result;
  for (const std::size_t i : edge_positions(net.shape, edge)) {
    result.x.push_back(net.coordinates[0][i]);
    result.y.push_back(net.coordinates[1][i]);
    result.w.push_back(net.rational() ? net.weights[i] : T(1));
  }
  return result;
}

}  // namespace

std::deque<DyadicCurve> edge_curves(const Forms& forms) {
  std::deque<DyadicCurve> curves;
  for (int edge = 0; edge < (forms.element().is_triangle() ? 3 : 4); ++edge) {
    if (forms.filter() == Filter::on) {
      const RoundUp up;
      curves.emplace_back(edge_net(forms.interval(up).net, edge),
                          [&forms, edge] { return edge_net(forms.exact().net, edge); });
    } else {
      curves.emplace_back(std::nullopt, edge_net(forms.exact().net, edge));
    }
  }
  return curves;
}

BoundaryResult examine_boundary(const Forms& forms, const ContactBudget& budget) {
  std::deque<DyadicCurve> curves = edge_curves(forms);
  const int edges = static_cast<int>(curves.size());
  BoundaryResult result{BoundaryStatus::simple, {}, {}};
  // An overlap may show at a later pair when an earlier one is open.
  const auto examine = [&](int i, int j, ContactResult found) {
    if (found.status == ContactStatus::contact) {
      const Contact& at = *found.contact;
      result = {
          BoundaryStatus::overlapping,
          Overlap{
              {i, at.first.lower, at.first.upper}, {j, at.second.lower, at.second.upper}, at.along_a_piece},
          {}};
    } else if (found.status == ContactStatus::open) {
      result.status = BoundaryStatus::open;
      result.exhausted = ExhaustedBudget{ExhaustedBudget::Limit::contact_bits, found.exceeded->allowed,
                                         found.exceeded->needed};
    }
    return result.status == BoundaryStatus::overlapping;
  };
  for (int i = 0; i < edges; ++i) {
    if (examine(i, i, self_contact(curves[i], budget))) return result;
  }
  for (int i = 0; i < edges; ++i) {
    for (int j = i + 1; j < edges; ++j) {
      const Joints joints{j == i + 1, i == 0 && j == edges - 1};
      if (examine(i, j, find_contact(curves[i], curves[j], joints, budget))) return result;
    }
  }
  return result;
}

Parameter boundary_parameter(const Element& element, int edge, const Rational& t) {
  const Domain domain = element.shape().domain;
  const DomainCorners corners = domain_corners(domain);
  const DomainCorners::Corner& from = corners.list[static_cast<std::size_t>(edge)];
  const DomainCorners::Corner& to = corners.list[static_cast<std::size_t>(edge + 1) % corners.count];
  return Parameter::at(domain, {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
}

}  // namespace bezcert
