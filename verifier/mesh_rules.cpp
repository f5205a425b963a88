// The mesh: elements glued along equal edges are a surface, which is mapped to the plane. `embedding`:
// vertices inside make one turn, boundary loops are simple and disjoint (by `pair` lines), and by their
// winding numbers every loop has points with one preimage on one side and with none on the other. Then
// refutations.
#include "mesh_rules.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace verifier {

namespace {

using Index = std::uint32_t;
using Use = Index;  ///< an edge of an element: 4 * element + edge; also the corner it begins at
constexpr Use none = ~Use{0};

mpq_class cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
/// A control point or node.
Point element_point(const Element& e, std::size_t i) {
  return {fraction(e.x[i], e.unit), fraction(e.y[i], e.unit)};
}

// ---- Curves

/// Whether control points are equal, and weights proportional.
bool equal(const Curve& a, const Curve& b) {
  bool all = a.x.size() == b.x.size();
  for (const auto f : coordinates)
    for (std::size_t i = 0; all && i < a.x.size(); ++i) all = (a.*f)[i] * b.w[0] == (b.*f)[i] * a.w[0];
  return all;
}

/// The coefficients of powers of z = t / (1 - t) in X(rho z) W'(z) - W(rho z) X'(z), and in the same with Y,
/// as polynomials in rho. If they vanish, the first curve at rho z is the second at z.
std::vector<Polynomial> differences_in_rho(const Curve& a, const Curve& b) {
  const auto in_z = [](const std::vector<mpz_class>& c, bool with_rho) {
    Polynomial2 rows;
    for (std::size_t i = 0; i < c.size(); ++i) {
      rows.emplace_back(with_rho ? i + 1 : 1);
      rows.back().back() = c[i] * choose(c.size() - 1, i);
    }
    trim(rows);
    return rows;
  };
  std::vector<Polynomial> all;
  for (const auto f : {&Curve::x, &Curve::y})
    for (Polynomial& c : in_z(a.*f, true) * in_z(b.w, false) - in_z(a.w, true) * in_z(b.*f, false))
      all.push_back(std::move(c));
  return all;
}

/// Whether a rho > 0 makes a and b one curve. All rho that do have one j-th power r, so the greatest common
/// divisor of the differences is a power of rho times one of rho^j - r: it has a change of sign if and only
/// if r > 0. (No change always means no root rho > 0, by Descartes: only this decides a claim.)
bool one_curve(const Curve& a, const Curve& b) {
  Polynomial f;
  for (Polynomial& g : differences_in_rho(a, b)) {
    for (; !g.empty(); std::swap(f, g)) {
      mpz_class content;
      for (const mpz_class& c : g) content = gcd(content, c);
      for (mpz_class& c : g) c /= content;
      for (; f.size() >= g.size(); trim(f)) {
        spend(64 * f.size() * product_work(limbs(f), limbs(g)));
        const mpz_class top = f.back();
        for (mpz_class& c : f) c *= g.back();
        for (std::size_t i = 0; i < g.size(); ++i) f[f.size() - g.size() + i] -= top * g[i];
      }
    }
  }
  return f.empty() ||
         std::any_of(f.begin(), f.end(), [&](const mpz_class& c) { return sgn(c) * sgn(f.back()) < 0; });
}

/// How often the curve, its pieces whose boxes do not hold the origin replaced by chords, passes the positive
/// x axis upwards less downwards. Rejected if this does not end: the origin may be on the curve.
int crossings(const Curve& c, int depth = 0) {
  const auto off = [](const std::vector<mpz_class>& z) {
    return std::all_of(z.begin(), z.end(), [&](const mpz_class& v) { return sgn(v) * sgn(z[0]) > 0; });
  };
  if (off(c.x) || off(c.y)) {
    const bool up = c.y[0] <= 0 && c.y.back() > 0, down = c.y[0] > 0 && c.y.back() <= 0;
    const int side = up || down ? cmp(c.x[0] * c.y.back(), c.x.back() * c.y[0]) : 0;
    return up && side > 0 ? 1 : down && side < 0 ? -1 : 0;
  }
  require(depth < 4096, "a point is not shown to be off a curve");
  const auto half = halves(c);
  return crossings(half[0], depth + 1) + crossings(half[1], depth + 1);
}

/// The same with p for the origin.
int crossings(const Point& p, Curve c) {
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    c.x[i] = c.x[i] * p[0].get_den() - p[0].get_num() * c.w[i];
    c.y[i] = c.y[i] * p[1].get_den() - p[1].get_num() * c.w[i];
  }
  return crossings(c);
}

int winding(const Point& p, const std::vector<Curve>& loop) {
  int sum = 0;
  for (const Curve& c : loop) sum += crossings(p, c);
  return sum;
}

/// The direction of a simple loop: its winding number around a point beside it on either side, nearer and
/// nearer until one is not 0.
int direction(const std::vector<Curve>& loop) {
  const Curve half = halves(loop[0])[1];
  const Point middle = control_point(half, 0), leg = control_point(half, 1) - middle;
  for (int k = 1; k <= 4096; k *= 2)
    for (const int side : {1, -1}) try {
        const mpq_class size = fraction(side, mpz_class(1) << k);
        const int sum = winding({middle[0] - size * leg[1], middle[1] + size * leg[0]}, loop);
        if (sum != 0) return sum;
      } catch (const Rejected&) {  // the point may be on the loop
      }
  throw Malformed{"limit: no point within a loop is found"};
}

// ---- The surface

struct Surface {
  const Elements& elements;
  std::vector<Use> uses;                  ///< all
  std::vector<Index> vertex;              ///< of corners
  std::vector<bool> holds_x;              ///< whether the corner's sector holds the direction (1, 0)
  std::vector<std::vector<Index>> nodes;  ///< along uses
  std::vector<Use> mate;                  ///< glued to, or none

  explicit Surface(const Elements& of) : elements(of) {
    const std::size_t bound = 4 * elements.count();
    if (bound >= none) throw Malformed{"limit: 2^30 elements"};
    vertex.resize(bound), holds_x.resize(bound), nodes.resize(bound), mate.resize(bound, none);
    std::map<Point, Index> points;
    for (std::size_t i = 0; i < elements.count(); ++i) {
      begin_line();  // what is done for every element, or edge, has the limit of a line each time
      const Element e = elements.element(i);
      const std::vector<Index> all = elements.nodes(i);
      std::vector<std::size_t> back = edge_positions(e, elements.corner_count(i) - 1);
      for (int k = 0; k < elements.corner_count(i); ++k) {
        const Use u = uses.emplace_back(static_cast<Use>(4 * i) + static_cast<Use>(k));
        std::vector<std::size_t> places = edge_positions(e, k);
        for (const std::size_t place : places) nodes[u].push_back(all[place]);
        const auto corner = [&] { return element_point(e, places[0]); };
        vertex[u] =
            elements.glued_by_nodes() ? nodes[u][0] : points.emplace(corner(), points.size()).first->second;
        // From the edge that leaves to the one that arrives it is less than half a turn to the left: from
        // below the x axis to above it by way of (1, 0).
        std::reverse(back.begin(), back.end());
        const int side = first_direction(e, places, 1);
        holds_x[u] =
            side == 0 ? first_direction(e, places, 0) > 0 : side < 0 && first_direction(e, back, 1) > 0;
        back = std::move(places);
      }
    }
  }

  Use corners(Use u) const { return static_cast<Use>(elements.corner_count(u / 4)); }
  Use following(Use u) const { return u % 4 + 1 == corners(u) ? u - u % 4 : u + 1; }
  Use preceding(Use u) const { return u % 4 == 0 ? u + corners(u) - 1 : u - 1; }
  /// The next corner around the vertex, clockwise, or none.
  Use across(Use corner) const { return mate[preceding(corner)]; }
  Index begin(Use u) const { return vertex[u]; }
  Index end(Use u) const { return vertex[following(u)]; }
  Curve curve(Use u) const { return edge_curve(elements.element(u / 4), static_cast<int>(u % 4)); }
  Use named(const EdgeName& name) const {
    if (name.element >= elements.count() || name.edge >= elements.corner_count(name.element))
      throw Malformed{"there is no such edge"};
    return static_cast<Use>(4 * name.element) + static_cast<Use>(name.edge);
  }

  /// Whether they lead between the same two vertices in opposite directions.
  bool opposite(Use u, Use v) const { return begin(u) == end(v) && end(u) == begin(v) && begin(u) != end(u); }
  /// Whether that is one edge, by whatever change of the parameter.
  bool one_edge(Use u, Use v) const { return opposite(u, v) && one_curve(curve(u), reversed(curve(v))); }
  bool same_nodes(Use u, Use v) const {
    return elements.lagrange(u / 4) == elements.lagrange(v / 4) &&
           std::equal(nodes[u].begin(), nodes[u].end(), nodes[v].rbegin(), nodes[v].rend());
  }

  /// Glues by nodes and control points. Any choice is sound: the surface made by it is the one that is
  /// embedded.
  void glue() {
    std::vector<std::tuple<Index, Index, Use>> sorted;
    for (const Use u : uses) sorted.emplace_back(std::min(begin(u), end(u)), std::max(begin(u), end(u)), u);
    std::sort(sorted.begin(), sorted.end());
    for (auto i = sorted.begin(); i != sorted.end(); ++i) {
      begin_line();
      const auto [low, high, u] = *i;
      for (auto j = i + 1; j != sorted.end() && mate[u] == none; ++j) {
        const auto [next_low, next_high, v] = *j;
        if (next_low != low || next_high != high) break;
        spend(1);
        if (mate[v] == none && opposite(u, v) && (same_nodes(u, v) || equal(curve(u), reversed(curve(v)))))
          mate[u] = v, mate[v] = u;
      }
    }
  }
  /// The line `glue`: differences are divisible by rho^j - r if they vanish with r for rho^j.
  void glue(Tokens& line) {
    const Use u = named(line.edge_name()), v = named(line.edge_name());
    Polynomial m(static_cast<std::size_t>(line.small(1, 4096)) + 1);
    const mpq_class r = line.rational();
    line.expect_end();
    require(opposite(u, v) && mate[u] == none && mate[v] == none,
            "glue: not two free uses of one pair of vertices");
    require(r > 0, "glue: r <= 0");
    m.front() = -r.get_num(), m.back() = r.get_den();
    for (const Polynomial& c : differences_in_rho(curve(u), reversed(curve(v))))
      require(divisible(c, m), "glue: two curves");
    mate[u] = v, mate[v] = u;
  }
};

// ---- Embedding

struct Rim {  ///< an edge of the boundary
  Use use;
  Curve curve;
  Point low, high;  ///< the box of the control points
  Rim* next = nullptr;
  std::size_t loop = none;

  Rim(Use u, const Curve& c) : use(u), curve(c), low(control_point(c, 0)), high(low) {
    for (std::size_t i = 1; i < c.x.size(); ++i) {
      const Point p = control_point(c, i);
      for (const int axis : {0, 1})
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
    }
  }
};

/// Boundary edges, each with the one that follows it; cycles of corners around vertices make one turn.
std::map<Use, Rim> check_vertices(const Surface& s) {
  std::map<Use, Rim> rims;
  for (const Use u : s.uses) {
    begin_line();
    if (s.mate[u] == none) rims.try_emplace(u, u, s.curve(u));
  }
  std::vector<bool> seen(s.vertex.size());
  for (auto& [u, rim] : rims) {
    Use corner = u;
    for (seen[corner] = true; s.across(corner) != none; seen[corner] = true) corner = s.across(corner);
    rims.at(s.preceding(corner)).next = &rim;
  }
  for (const Use u : s.uses) {  // what is not seen is in cycles
    int turns = seen[u] ? 1 : 0;
    for (Use corner = u; !seen[corner]; corner = s.across(corner))
      seen[corner] = true, turns += s.holds_x[corner];
    require(turns == 1, "the elements around a vertex inside make more than one turn");
  }
  return rims;
}

void check_embedding(const Elements& elements, const std::function<std::string_view()>& next_line) {
  Surface s(elements);
  s.glue();
  Tokens line(next_line());
  for (; line.accept("glue"); line = Tokens(next_line())) s.glue(line);
  std::map<Use, Rim> rims = check_vertices(s);

  std::set<std::pair<Use, Use>> pairs;
  const auto rim_named = [&](const EdgeName& name) -> const Rim& {
    const auto at = rims.find(s.named(name));
    require(at != rims.end(), "pair: not an edge of the boundary");
    return at->second;
  };
  for (; line.accept("pair"); line = Tokens(next_line())) {
    const Rim &a = rim_named(line.edge_name()), &b = rim_named(line.edge_name());
    require(a.use / 4 != b.use / 4, "pair: edges of one element");
    check_pair(line, a.curve, b.curve, {a.next == &b, b.next == &a});
    line.expect_end();
    pairs.insert(std::minmax(a.use, b.use));
  }
  if (!line.accept("end")) throw Malformed{"expected glue, then pair, then end"};
  line.expect_end();

  std::vector<const Rim*> sorted;
  for (const auto& [u, rim] : rims) sorted.push_back(&rim);
  std::sort(sorted.begin(), sorted.end(), [](const Rim* a, const Rim* b) { return a->low[0] < b->low[0]; });
  for (auto i = sorted.begin(); i != sorted.end(); ++i) {
    const Rim& a = **i;
    for (auto j = i + 1; j != sorted.end() && (*j)->low[0] <= a.high[0]; ++j) {
      const Rim& b = **j;
      spend(8);
      require(a.use / 4 == b.use / 4 || a.low[1] > b.high[1] || b.low[1] > a.high[1] ||
                  pairs.contains(std::minmax(a.use, b.use)),
              "a pair is missing");
    }
  }

  std::vector<std::vector<Curve>> loops;
  for (auto& [u, start] : rims) {
    if (start.loop != none) continue;
    loops.emplace_back();
    for (Rim* rim = &start; rim->loop == none; rim = rim->next)
      rim->loop = loops.size() - 1, loops.back().push_back(rim->curve);
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Point p = control_point(loops[i][0], 0);
    int around = 0;  // the winding numbers of all other loops
    for (const auto& [u, rim] : rims) {
      spend(8);
      if (rim.loop != i && rim.low[1] <= p[1] && p[1] <= rim.high[1] && p[0] <= rim.high[0])
        around += crossings(p, rim.curve);
    }
    require(around == (direction(loops[i]) > 0 ? 0 : 1),
            "not one preimage on one side of a loop, none on the other");
  }
}

// ---- Refutations

void check_touch(const Surface& s, Tokens& line) {
  const Meet meet = read_meet(line, true);
  const Use u = s.named(meet.first), v = s.named(meet.second);
  const bool one_element = u / 4 == v / 4;
  require(one_element || !s.one_edge(u, v), "touch: perhaps both are one edge");
  MeetContext context{s.curve(u), s.curve(v), u == v};
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      const Use a = i == 0 ? u : s.following(u), b = j == 0 ? v : s.following(v);
      context.common[i][j] = one_element ? u != v && a == b : s.vertex[a] == s.vertex[b];
    }
  }
  check_meet(meet, context);
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

std::string check_mesh(const Elements& elements, const std::vector<Claim>& claims, Tokens& line,
                       const std::function<std::string_view()>& next_line) {
  std::string claim(line.word());
  const auto position = [&] {
    return static_cast<std::size_t>(line.small(1, static_cast<long>(elements.count())) - 1);
  };
  if (claim == "embedding") {
    line.expect_end();
    require(std::all_of(claims.begin(), claims.end(), [](Claim c) { return c == Claim::injective; }),
            "an element is not claimed to be injective");
    check_embedding(elements, next_line);
  } else if (claim == "refuted") {
    const std::string kind(line.word());
    claim += ' ' + kind;
    if (kind == "element") {
      const Claim c = claims.at(position());
      require(c != Claim::injective && c != Claim::regular && c != Claim::undecided,
              "element: not refuted by its claim");
    } else if (kind == "cover") {
      const std::size_t i = position(), j = position();
      const mpq_class x = line.rational(), y = line.rational();
      check_cover(elements, claims, i, j, {x, y});
    } else if (kind == "touch") {
      check_touch(Surface(elements), line);
    } else if (kind == "pinch") {
      check_pinch(Surface(elements), line);
    } else if (kind == "gap") {
      check_gap(Surface(elements), line);
    } else {
      throw Malformed{"unknown refutation"};
    }
  } else if (claim != "undecided") {
    throw Malformed{"unknown claim of the mesh"};
  }
  line.expect_end();
  return claim;
}

}  // namespace verifier
