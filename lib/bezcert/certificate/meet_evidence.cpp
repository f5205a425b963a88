#include "bezcert/certificate/meet_evidence.hpp"

#include "bezcert/algebra/algebraic_point.hpp"
#include "bezcert/certificate/evidence_text.hpp"
#include "bezcert/curve/contact_algebra.hpp"
#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/separation.hpp"

#include <algorithm>

namespace bezcert {
namespace {

bool are_different(const Rational& s, const Rational& t, const CommonPlaces& common) {
  if (common.same_edge) return s != t;
  const bool s_end = s.is_zero() || s == 1, t_end = t.is_zero() || t == 1;
  return !(s_end && t_end && common.ends[s.is_zero() ? 0 : 1][t.is_zero() ? 0 : 1]);
}

bool are_different(const ParameterRange& s, const ParameterRange& t, const CommonPlaces& common) {
  if (common.same_edge) return s.upper < t.lower || t.upper < s.lower;
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      if (common.ends[i][j] && s.lower <= i && i <= s.upper && t.lower <= j && j <= t.upper) return false;
    }
  }
  return true;
}

std::string at_text(const NamedCurve& a, const Rational& s, const NamedCurve& b, const Rational& t) {
  return "at " + a.name + ' ' + to_string(s) + ' ' + b.name + ' ' + to_string(t);
}

// The condition of `cross`: d . a(s0) <= d . B <= d . a(s1) and e . b(t0) <= e . A <= e . b(t1), or the
// latter with b's ends exchanged, d from a(s0) to a(s1) and e across.
bool satisfies_cross(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  const std::size_t last_a = a.size() - 1, last_b = b.size() - 1;
  const Vector2<Integer> d = between(a, 0, a, last_a);
  if (d.x.is_zero() && d.y.is_zero()) return false;
  for (std::size_t j = 0; j <= last_b; ++j) {
    if (dot(d, between(a, 0, b, j)).sign() < 0 || dot(d, between(b, j, a, last_a)).sign() < 0) return false;
  }
  const auto is_between = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = 0; i <= last_a; ++i) {
      if (cross(d, between(b, from, a, i)).sign() < 0 || cross(d, between(a, i, b, to)).sign() < 0)
        return false;
    }
    return true;
  };
  return is_between(0, last_b) || is_between(last_b, 0);
}

std::optional<std::string> cross_evidence(const NamedCurve& a, const ParameterRange& s, const NamedCurve& b,
                                          const ParameterRange& t) {
  if (s.lower >= s.upper || t.lower >= t.upper) return std::nullopt;
  const CurveNet<Integer> part_a = part_of(a.net, s.lower, s.upper);
  const CurveNet<Integer> part_b = part_of(b.net, t.lower, t.upper);
  const auto text = [](const NamedCurve& curve, const ParameterRange& range) {
    return curve.name + ' ' + to_string(range.lower) + ' ' + to_string(range.upper);
  };
  if (satisfies_cross(part_a, part_b)) return "cross " + text(a, s) + ' ' + text(b, t);
  if (satisfies_cross(part_b, part_a)) return "cross " + text(b, t) + ' ' + text(a, s);
  return std::nullopt;
}

RealRoot root_in(const ParameterRange& range) {
  if (range.lower == range.upper) return rational_root(range.lower);
  return {{}, range.lower, range.upper};
}

// Narrows the point's interval until it shows that the two places are different.
bool narrow_to_different(AlgebraicPoint& point, const CommonPlaces& common) {
  constexpr auto strict = AffineCondition::Asks::one_strict_sign;
  if (common.same_edge) return narrow(point, {{0, 1, -1, strict}});
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      if (!common.ends[i][j]) continue;
      if (!narrow(point, {{i, -1, 0, strict}}) && !narrow(point, {{j, 0, -1, strict}})) return false;
    }
  }
  return true;
}

std::optional<std::string> root_evidence(const NamedCurve& a, const ParameterRange& s, const NamedCurve& b,
                                         const ParameterRange& t, const CommonPlaces& common) {
  const auto [f, g] = contact_equations(a.net, b.net, common.same_edge);
  auto point = algebraic_point({f, g}, {root_in(s), root_in(t)});
  if (!point) return std::nullopt;
  constexpr auto weak = AffineCondition::Asks::not_negative;
  if (!narrow(*point, {{0, 1, 0, weak}, {1, -1, 0, weak}, {0, 0, 1, weak}, {1, 0, -1, weak}}) ||
      !narrow_to_different(*point, common)) {
    return std::nullopt;
  }
  if (point->is_rational()) {
    const auto value = [](const std::vector<Rational>& f_of_x) {
      return f_of_x.empty() ? Rational(0) : f_of_x[0];
    };
    return at_text(a, value(point->u), b, value(point->v));
  }
  return "root " + text_of_polynomial(point->polynomial) + ' ' + to_string(point->lower) + ' ' +
         to_string(point->upper) + ' ' + a.name + ' ' + text_of_rational_polynomial(point->u) + ' ' + b.name +
         ' ' + text_of_rational_polynomial(point->v);
}

// As meet_at_ends, with the ends and the middle of a only.
std::optional<std::string> ends_on(const NamedCurve& a, const NamedCurve& b, const CommonPlaces& common) {
  for (const Rational& s : {Rational(1, 2), Rational(0), Rational(1)}) {
    const Point point = point_at(a.net, s);
    std::vector<Rational> parameters = rational_parameters(b.net, point, 0);
    if (point == point_at(b.net, 0)) parameters.insert(parameters.begin(), Rational(0));
    for (const Rational& t : parameters) {
      if (are_different(s, t, common)) return at_text(a, s, b, t);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> meet_at_ends(const NamedCurve& a, const NamedCurve& b,
                                        const CommonPlaces& common) {
  if (auto found = ends_on(a, b, common)) return found;
  CommonPlaces exchanged = common;
  std::swap(exchanged.ends[0][1], exchanged.ends[1][0]);
  return ends_on(b, a, exchanged);
}

std::optional<std::string> meet_evidence(const NamedCurve& a, const NamedCurve& b, const CommonPlaces& common,
                                         const Contact& contact) {
  const ParameterRange &s = contact.first, &t = contact.second;
  if (s.lower == s.upper && t.lower == t.upper) {
    if (!are_different(s.lower, t.lower, common)) return std::nullopt;
    if (point_at(a.net, s.lower) != point_at(b.net, t.lower)) return std::nullopt;
    return at_text(a, s.lower, b, t.lower);
  }
  if (are_different(s, t, common)) {
    if (auto found = cross_evidence(a, s, b, t)) return found;
  }
  if (auto found = meet_at_ends(a, b, common)) return found;
  return root_evidence(a, s, b, t, common);
}

std::optional<std::string> meet_evidence(const Forms& forms, const Overlap& overlap) {
  std::deque<DyadicCurve> curves = edge_curves(forms);
  const auto named = [&](int edge) {
    return NamedCurve{curves[static_cast<std::size_t>(edge)].exact(DyadicCurve::whole), std::to_string(edge)};
  };
  const BoundaryRange &first = overlap.first, &second = overlap.second;
  const int count = static_cast<int>(curves.size());
  CommonPlaces common;
  common.same_edge = first.edge == second.edge;
  common.ends[1][0] = (first.edge + 1) % count == second.edge;
  common.ends[0][1] = (second.edge + 1) % count == first.edge;
  const Contact contact{{first.lower, first.upper}, {second.lower, second.upper}, overlap.along_a_piece};
  return meet_evidence(named(first.edge), named(second.edge), common, contact);
}

}  // namespace bezcert
