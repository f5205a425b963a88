// Curves for tests of evidence about pairs of edges, and the verifier's word on it.
#pragma once

#include "refusal.hpp"

#include "bezcert/certificate/meet_evidence.hpp"
#include "rules.hpp"

#include <array>
#include <string>
#include <vector>

namespace bezcert::test {

/// A polynomial curve by its control points, or a rational one.
inline CurveNet<Integer> net_of(const std::vector<std::array<Rational, 2>>& points,
                                const std::vector<Rational>& weights = {}) {
  std::vector<Rational> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rational w = weights.empty() ? Rational(1) : weights[i];
    all.insert(all.end(), {points[i][0] * w, points[i][1] * w, w});
  }
  const std::vector<Integer> integers = scaled_integers(all).values;
  CurveNet<Integer> net;
  for (std::size_t i = 0; i < integers.size(); i += 3) {
    net.x.push_back(integers[i]);
    net.y.push_back(integers[i + 1]);
    net.w.push_back(integers[i + 2]);
  }
  return net;
}

/// With intervals, as edges of elements have them, or without.
inline DyadicCurve dyadic(const CurveNet<Integer>& net, bool filter) {
  if (!filter) return DyadicCurve(std::nullopt, net);
  CurveNet<Interval> interval;
  for (std::size_t i = 0; i < net.size(); ++i) {
    interval.x.push_back(to_interval(net.x[i]));
    interval.y.push_back(to_interval(net.y[i]));
    interval.w.push_back(to_interval(net.w[i]));
  }
  return DyadicCurve(std::move(interval), net);
}

inline verifier::Curve as_verifier(const CurveNet<Integer>& net) {
  const auto copy = [](const std::vector<Integer>& values) {
    std::vector<mpz_class> result;
    mpz_class binomial = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
      result.emplace_back(mpz_class(values[i].str()) * binomial);
      binomial = binomial * mpz_class(values.size() - 1 - i) / mpz_class(i + 1);
    }
    return result;
  };
  return {copy(net.x), copy(net.y), copy(net.w)};
}

inline std::string refusal_of_pair(const std::string& text, const CurveNet<Integer>& a,
                                   const CurveNet<Integer>& b, Joints joints) {
  return refusal_of(text, [&](verifier::Tokens& tokens) {
    verifier::check_pair(tokens, as_verifier(a), as_verifier(b), {joints.end_to_begin, joints.begin_to_end});
  });
}

/// Of MEET that names the curves "0" and "1".
inline std::string refusal_of_meet(const std::string& text, const CurveNet<Integer>& a,
                                   const CurveNet<Integer>& b, const CommonPlaces& common) {
  return refusal_of(text, [&](verifier::Tokens& tokens) {
    verifier::check_meet(tokens, false, [&](const verifier::EdgeName& name, const verifier::EdgeName&) {
      const bool exchanged = name.edge == 1;
      verifier::MeetingEdges edges{as_verifier(exchanged ? b : a), as_verifier(exchanged ? a : b), false, {}};
      for (const int i : {0, 1}) {
        for (const int j : {0, 1}) edges.common[i][j] = exchanged ? common.ends[j][i] : common.ends[i][j];
      }
      return edges;
    });
  });
}

}  // namespace bezcert::test
