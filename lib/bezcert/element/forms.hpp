// The number forms of one element, each computed on first use and kept: what criteria and decision share.
//
// A sign is asked for with a generic expression over the control net; it is answered from the intervals
// if they are certain and from the integers otherwise, so the answer never depends on the filter.
#pragma once

#include "bezcert/element/jacobian.hpp"
#include "bezcert/element/net.hpp"
#include "bezcert/number/filtered_sign.hpp"

#include <optional>

namespace bezcert {

/// N (times `numerator_multiple`) and W of an element.
template <class T>
struct JacobianForm {
  Polynomial<T> numerator;
  Polynomial<T> weight;
};

class Forms {
 public:
  /// Keeps a reference: `element` must outlive this.
  explicit Forms(const Element& element, Filter filter = Filter::on) : element_(element), filter_(filter) {}
  Forms(const Forms&) = delete;
  Forms& operator=(const Forms&) = delete;

  const Element& element() const { return element_; }
  Filter filter() const { return filter_; }

  const IntervalNet& interval(const RoundUp& up) const {
    if (!interval_) interval_ = interval_net(up, element_);
    return *interval_;
  }
  const ExactNet& exact() const {
    if (!exact_) exact_ = exact_net(element_);
    return *exact_;
  }
  /// The same for N and W.
  const JacobianForm<Interval>& interval_jacobian(const RoundUp& up) const {
    if (!interval_jacobian_) interval_jacobian_ = jacobian_form(interval(up).net);
    return *interval_jacobian_;
  }
  const JacobianForm<Integer>& exact_jacobian() const {
    if (!exact_jacobian_) exact_jacobian_ = jacobian_form(exact().net);
    return *exact_jacobian_;
  }
  /// Whether exact arithmetic was needed so far.
  bool went_exact() const { return exact_.has_value(); }

  /// The sign of `expression(net)`, an expression in +, -, * written once for any number type.
  template <class Expression>
  int sign_of(Expression expression) const {
    return filtered_sign(
        filter_, expression, [&](const RoundUp& up) { return std::tie(interval(up).net); },
        [&] { return std::tie(exact().net); });
  }

 private:
  template <class T>
  static JacobianForm<T> jacobian_form(const Net<T>& net) {
    return {jacobian_numerator(net), weight_polynomial(net)};
  }

  const Element& element_;
  Filter filter_;
  mutable std::optional<IntervalNet> interval_;
  mutable std::optional<ExactNet> exact_;
  mutable std::optional<JacobianForm<Interval>> interval_jacobian_;
  mutable std::optional<JacobianForm<Integer>> exact_jacobian_;
};

/// The orientation of control points a, b, c of a net: a positive multiple of twice the signed area of
/// the triangle (a, b, c).
template <class T>
T orientation(const Net<T>& net, std::size_t a, std::size_t b, std::size_t c) {
  const std::vector<T>&x = net.coordinates[0], &y = net.coordinates[1], &w = net.weights;
  const T bx = x[b] - x[a];
  const T by = y[b] - y[a];
  const T cx = x[c] - x[a];
  const T cy = y[c] - y[a];
  if (!net.rational()) return bx * cy - by * cx;
  const T bw = w[b] - w[a];
  const T cw = w[c] - w[a];
  return (by * cw - bw * cy) * x[a] + (bw * cx - bx * cw) * y[a] + (bx * cy - by * cx) * w[a];
}

}  // namespace bezcert
