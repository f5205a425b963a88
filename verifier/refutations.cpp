// `mesh refuted`: it is not an embedding, or not conforming.
#include "rules.hpp"
#include "surface.hpp"

#include <algorithm>

namespace verifier {

namespace {

MeetingEdges touching(const Surface& s, Use u, Use v) {
  const bool one_element = u / 4 == v / 4;
  require(one_element || !s.one_edge(u, v), "touch: perhaps both are one edge");
  MeetingEdges edges{s.curve(u), s.curve(v), u == v};
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      const Use a = i == 0 ? u : s.following(u), b = j == 0 ? v : s.following(v);
      edges.common[i][j] = one_element ? u != v && a == b : s.vertex[a] == s.vertex[b];
    }
  }
  return edges;
}

void check_pinch(const Surface& s, Tokens& line) {
  const Use from = s.named(line.edge_name()), to = s.named(line.edge_name());
  require(s.begin(from) == s.begin(to), "pinch: two vertices");
  std::vector<Use> fan{from};
  const auto in_fan = [&](Use u) { return std::find(fan.begin(), fan.end(), u) != fan.end(); };
  for (std::size_t i = 0; i < fan.size(); ++i) {
    spend(s.uses.size() + 64 * fan.size());
    for (const Use u : s.uses)
      if (s.begin(u) == s.begin(from) && !in_fan(u) &&
          (s.one_edge(fan[i], s.preceding(u)) || s.one_edge(s.preceding(fan[i]), u)))
        fan.push_back(u);
  }
  require(!in_fan(to), "pinch: one fan");
}

/// Closeness of points, measured by an edge of an element and its farthest point.
struct Frame {
  Point a, c;
  mpq_class area;
  Frame(const Element& element, const Curve& edge) : a(point(edge, 1) - point(edge, 0)) {
    for (std::size_t i = 0; i < element.x.size(); ++i) {
      const Point to = element_point(element, i) - point(edge, 0);
      const mpq_class size = abs(cross(a, to));
      if (size > area) area = size, c = to;
    }
  }
  bool close(const Point& p, const Point& q) const {
    const Point d = p - q;
    return area > 0 && 8 * abs(cross(d, c)) <= area && 8 * abs(cross(a, d)) <= area;
  }
};

void check_crack(const Surface& s, Use u, Use v, const mpq_class& t) {
  require(s.opposite(u, v) && 0 <= t && t <= 1, "gap: not two uses of one pair of vertices");
  const Curve a = s.curve(u), b = reversed(s.curve(v));
  crossings(point(a, t), b);  // Rejected if the point may be on the curve
  const auto close = [&](Use use) {
    const Frame frame(s.elements.element(use / 4), s.curve(use));
    bool all = true;
    for (int k = 1; k < 16; ++k)
      all = all && frame.close(point(a, fraction(k, 16)), point(b, fraction(k, 16)));
    return all;
  };
  require(close(u) || close(v), "gap: not close");
}

void check_hanging(const Surface& s, Use u, Use v, Use w) {
  require(s.end(u) == s.begin(v) && s.end(v) == s.begin(w) && s.end(w) == s.begin(u), "gap: not a loop");
  require(u / 4 != v / 4 && u / 4 != w / 4, "gap: edges of one element");
  const Curve edge = s.curve(u);
  const Frame frame(s.elements.element(u / 4), edge);
  const Point node = point(s.curve(w), 0);
  for (const Point& p : {node, point(s.curve(v), fraction(1, 2)), point(s.curve(w), fraction(1, 2))}) {
    bool close = false;
    for (int k = 0; k <= 32 && !close; ++k) close = frame.close(p, point(edge, fraction(k, 32)));
    require(close, "gap: not close");
  }
  crossings(node, edge);
}

void check_gap(const Surface& s, Tokens& line) {
  std::vector<Use> uses{s.named(line.edge_name()), s.named(line.edge_name())};
  const bool hanging = Tokens(line).word().find('.') != std::string_view::npos;
  if (hanging) uses.push_back(s.named(line.edge_name()));
  for (const Use u : uses)
    for (const Use v : s.uses) require(!s.one_edge(u, v), "gap: perhaps an edge is glued");
  hanging ? check_hanging(s, uses[0], uses[1], uses[2]) : check_crack(s, uses[0], uses[1], line.rational());
}

void check_cover(const Elements& elements, const std::vector<Claim>& claims, std::size_t i, std::size_t j,
                 const Point& p) {
  require(i != j, "cover: one element");
  for (const std::size_t k : {i, j})
    require(claims.at(k) == Claim::injective && winding(p, edge_curves(elements.element(k))) == 1,
            "cover: the point is not in an injective element");
}

}  // namespace

std::string check_refutation(const Elements& elements, const std::vector<Claim>& claims, Tokens& line) {
  const auto position = [&] {
    return static_cast<std::size_t>(line.small(1, static_cast<long>(elements.count())) - 1);
  };
  std::string kind(line.word());
  if (kind == "element") {
    const Claim c = claims.at(position());
    require(c != Claim::injective && c != Claim::regular && c != Claim::undecided,
            "element: not refuted by its claim");
  } else if (kind == "cover") {
    const std::size_t i = position(), j = position();
    const mpq_class x = line.rational(), y = line.rational();
    check_cover(elements, claims, i, j, {x, y});
  } else if (kind == "touch") {
    const Surface s(elements);
    check_meet(line, true, [&](const auto& a, const auto& b) { return touching(s, s.named(a), s.named(b)); });
  } else if (kind == "pinch") {
    check_pinch(Surface(elements), line);
  } else if (kind == "gap") {
    check_gap(Surface(elements), line);
  } else {
    throw Malformed{"unknown refutation"};
  }
  return kind;
}

}  // namespace verifier
