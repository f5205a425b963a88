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

/// Whether all differences d of points are small, measured by the use and its element's point that is
/// farthest from it.
bool are_small(const Surface& s, Use u, const std::vector<Point>& differences) {
  const Element element = s.elements.element(u / 4);
  const Curve edge = s.curve(u);
  const Point begin = control_point(edge, 0), a = point(edge, 1) - begin;
  Point c;
  mpq_class area;
  for (std::size_t i = 0; i < element.x.size(); ++i) {
    const Point to = element_point(element, i) - begin;
    if (const mpq_class size = abs(cross(a, to)); size > area) area = size, c = to;
  }
  return area > 0 && std::all_of(differences.begin(), differences.end(), [&](const Point& d) {
           return 8 * abs(cross(d, c)) <= area && 8 * abs(cross(a, d)) <= area;
         });
}

void check_gap(const Surface& s, Tokens& line) {
  const Use u = s.named(line.edge_name()), v = s.named(line.edge_name());
  const bool hanging = Tokens(line).word().find('.') != std::string_view::npos;
  const Use w = hanging ? s.named(line.edge_name()) : v;
  for (const Use x : {u, v, w})
    for (const Use y : s.uses) require(!s.one_edge(x, y), "gap: perhaps an edge is glued");
  const Curve a = s.curve(u), b = reversed(s.curve(v));
  bool close = true;
  if (hanging) {
    require(s.end(u) == s.begin(v) && s.end(v) == s.begin(w) && s.end(w) == s.begin(u), "gap: not a loop");
    require(u / 4 != v / 4 && u / 4 != w / 4, "gap: edges of one element");
    crossings(control_point(b, 0), a);  // Rejected if the node may be on the curve
    for (const Point& p :
         {control_point(b, 0), point(b, fraction(1, 2)), point(s.curve(w), fraction(1, 2))}) {
      bool near = false;
      for (int k = 0; k <= 32 && !near; ++k) near = are_small(s, u, {p - point(a, fraction(k, 32))});
      close = close && near;
    }
  } else {
    const mpq_class t = line.rational();
    require(s.opposite(u, v) && 0 <= t && t <= 1, "gap: not two uses of one pair of vertices");
    crossings(point(a, t), b);
    std::vector<Point> differences;
    for (int k = 1; k < 16; ++k) differences.push_back(point(a, fraction(k, 16)) - point(b, fraction(k, 16)));
    close = are_small(s, u, differences) || are_small(s, v, differences);
  }
  require(close, "gap: not close");
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
