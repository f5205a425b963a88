// The mesh: elements glued along equal edges are a surface, which is mapped to the plane. `embedding`:
// vertices inside make one turn, boundary loops are simple and disjoint (by `pair` lines), and by their
// winding numbers every loop has points with one preimage on one side and with none on the other. Then
// refutations.
#include "mesh_rules.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace verifier {

namespace {

using Index = std::uint32_t;
using Use = Index;  ///< an edge of an element: 4 * element + edge; also the corner it begins at
using Point = std::array<mpq_class, 2>;
using Box = std::array<Point, 2>;  ///< [x or y][low, high]
using Pairs = std::vector<std::pair<Index, Index>>;
constexpr Use none = ~Use{0};

mpq_class cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }

// ---- Curves

/// Whether control points are equal, and weights proportional.
bool equal(const Curve& a, const Curve& b) {
  bool all = a.x.size() == b.x.size();
  for (const auto f : coordinates)
    for (std::size_t i = 0; all && i < a.x.size(); ++i) all = (a.*f)[i] * b.w[0] == (b.*f)[i] * a.w[0];
  return all;
}

/// The coefficients of powers of z = t / (1 - t) in X(rho z) W'(z) - W(rho z) X'(z), and in the same with Y,
/// as polynomials in rho. If they vanish, the first curve at rho z is the second at z (X and Y follow, as W
/// W' != 0).
std::vector<Polynomial> differences_in_rho(Curve a, Curve b) {
  for (Curve* c : {&a, &b})
    for (const auto f : coordinates)
      for (std::size_t i = 0; i < c->x.size(); ++i) (c->*f)[i] *= choose(c->x.size() - 1, i);
  const std::size_t n = a.x.size(), m = b.x.size();
  spend(4 * n * m * product_work(limbs(a.x) + limbs(a.y) + limbs(a.w), limbs(b.x) + limbs(b.y) + limbs(b.w)));
  std::vector<Polynomial> all(2 * (n + m - 1), Polynomial(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      all[2 * (i + k)][i] = a.x[i] * b.w[k] - a.w[i] * b.x[k];
      all[2 * (i + k) + 1][i] = a.y[i] * b.w[k] - a.w[i] * b.y[k];
    }
  }
  for (Polynomial& c : all) trim(c);
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
  require(depth < 512, "a point is not shown to be off a curve");
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
  const Point middle = point(half, 0);
  const Point leg = Point{fraction(half.x[1], half.w[1]), fraction(half.y[1], half.w[1])} - middle;
  mpq_class size = 1;
  for (int k = 0; k < 1024; ++k) try {
      size = k % 2 == 0 ? mpq_class(abs(size) / 2) : mpq_class(-size);
      const int sum = winding({middle[0] - size * leg[1], middle[1] + size * leg[0]}, loop);
      if (sum != 0) return sum;
    } catch (const Rejected&) {  // the point may be on the loop
    }
  throw Rejected{"no point within a loop is found"};
}

Box box_of(const Curve& c) {
  const auto range = [&](const std::vector<mpz_class>& z) {
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < z.size(); ++i) {
      if (z[i] * c.w[low] < z[low] * c.w[i]) low = i;
      if (z[i] * c.w[high] > z[high] * c.w[i]) high = i;
    }
    return Point{fraction(z[low], c.w[low]), fraction(z[high], c.w[high])};
  };
  return {range(c.x), range(c.y)};
}

/// Calls found(i, j) for all pairs of closed boxes that meet, perhaps more than once: boxes are parted at a
/// median, unless too many are in both parts.
template <class Found>
void meeting(const std::vector<Box>& boxes, std::vector<Index> some, const Found& found) {
  spend(32 * some.size());
  for (std::size_t axis = 0; axis < 2 && some.size() > 16; ++axis) {
    const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
    const auto less = [&](Index i, Index j) { return boxes[i][axis][0] < boxes[j][axis][0]; };
    std::nth_element(some.begin(), middle, some.end(), less);
    const mpq_class& at = boxes[*middle][axis][0];
    std::vector<Index> before,
        after;  // two boxes that meet do so somewhere before `at`, or somewhere not before
    for (const Index i : some) {
      if (boxes[i][axis][0] < at) before.push_back(i);
      if (boxes[i][axis][1] >= at) after.push_back(i);
    }
    if (after.size() > some.size() - some.size() / 6) continue;
    some = {};
    meeting(boxes, std::move(before), found);
    return meeting(boxes, std::move(after), found);
  }
  for (std::size_t i = 0; i < some.size(); ++i) {
    spend(8 * i);
    for (std::size_t j = 0; j < i; ++j) {
      const Box &a = boxes[some[i]], &b = boxes[some[j]];
      const auto meet = [&](int k) { return a[k][0] <= b[k][1] && b[k][0] <= a[k][1]; };
      if (meet(0) && meet(1)) found(some[i], some[j]);
    }
  }
}

// ---- The surface

struct Surface {
  const Elements& elements;
  std::vector<Use> uses;            ///< all
  std::vector<Index> vertex;        ///< of corners
  std::vector<bool> holds_x;        ///< whether the corner's sector holds the direction (1, 0)
  std::vector<Index> nodes, first;  ///< those along u are from nodes[first[u]] to nodes[first[u + 1]]
  std::vector<Use> mate;            ///< glued to, or none

  explicit Surface(const Elements& of) : elements(of) {
    const std::size_t bound = 4 * elements.count();
    if (bound >= none) throw Malformed{"limit: 2^30 elements"};
    vertex.resize(bound), holds_x.resize(bound), mate.resize(bound, none);
    std::map<std::string, Index> points;
    for (std::size_t i = 0; i < elements.count(); ++i) {
      begin_line();  // what is done for every element, or edge, has the limit of a line each time
      const Element e = elements.element(i);
      const std::vector<Index> all = elements.nodes(i);
      std::vector<std::size_t> back = edge_positions(e, elements.corner_count(i) - 1);
      for (int k = 0; k < 4; ++k) {
        first.push_back(static_cast<Index>(nodes.size()));
        if (k == elements.corner_count(i)) break;
        const Use u = static_cast<Use>(4 * i) + static_cast<Use>(k);
        std::vector<std::size_t> places = edge_positions(e, k);
        for (const std::size_t place : places) nodes.push_back(all[place]);
        uses.push_back(u);
        const auto text = [&](const mpz_class& z) { return fraction(z, e.unit).get_str(36); };
        const std::size_t corner = places[0];
        vertex[u] =
            elements.glued_by_nodes()
                ? all[corner]
                : points.emplace(text(e.x[corner]) + ' ' + text(e.y[corner]), points.size()).first->second;
        // From the edge that leaves to the one that arrives it is less than half a turn to the left: from
        // below the x axis to above it by way of (1, 0).
        std::reverse(back.begin(), back.end());
        const int side = first_direction(e, places, 1);
        holds_x[u] =
            side == 0 ? first_direction(e, places, 0) > 0 : side < 0 && first_direction(e, back, 1) > 0;
        back = std::move(places);
      }
    }
    first.push_back(static_cast<Index>(nodes.size()));
  }

  Use corners(Use u) const { return static_cast<Use>(elements.corner_count(u / 4)); }
  Use following(Use u) const { return u % 4 + 1 == corners(u) ? u - u % 4 : u + 1; }
  Use preceding(Use u) const { return u % 4 == 0 ? u + corners(u) - 1 : u - 1; }
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
    const auto at = [&](Index i) { return nodes.begin() + static_cast<std::ptrdiff_t>(i); };
    return elements.lagrange(u / 4) == elements.lagrange(v / 4) &&
           first[u + 1] - first[u] == first[v + 1] - first[v] &&
           std::equal(at(first[u]), at(first[u + 1]), std::reverse_iterator(at(first[v + 1])));
  }

  /// Glues by nodes and control points. Any choice is sound: the surface made by it is the one that is
  /// embedded.
  void glue() {
    std::vector<std::pair<std::pair<Index, Index>, Use>> sorted;
    for (const Use u : uses) sorted.push_back({std::minmax({begin(u), end(u)}), u});
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      begin_line();
      const Use u = sorted[i].second;
      for (std::size_t j = i + 1; j < sorted.size() && sorted[j].first == sorted[i].first && mate[u] == none;
           ++j) {
        const Use v = sorted[j].second;
        spend(1);
        if (mate[v] != none || !opposite(u, v)) continue;
        if (same_nodes(u, v) || equal(curve(u), reversed(curve(v)))) mate[u] = v, mate[v] = u;
      }
    }
  }
  void glue_line(Tokens& line) {
    const Use u = named(line.edge_name()), v = named(line.edge_name());
    const auto j = static_cast<std::size_t>(line.small(1, 1 << 20));
    const mpq_class r = line.rational();
    line.expect_end();
    require(opposite(u, v) && mate[u] == none && mate[v] == none,
            "glue: not two free uses of one pair of vertices");
    require(r > 0, "glue: r <= 0");
    for (const Polynomial& c : differences_in_rho(curve(u), reversed(curve(v)))) {
      for (std::size_t power = 0; power < std::min(j, c.size());
           ++power) {  // of rho, times a polynomial in r
        Polynomial in_r;
        for (std::size_t i = power; i < c.size(); i += j) in_r.push_back(c[i]);
        trim(in_r);
        require(value(in_r, r) == 0, "glue: two curves");
      }
    }
    mate[u] = v, mate[v] = u;
  }
};

// ---- Embedding

struct Rim {  ///< an edge of the boundary
  Use use;
  Curve curve;
  Index next = none, loop = none;
};

/// Boundary edges, each with the one that follows it; cycles of corners around vertices make one turn.
std::vector<Rim> check_vertices(const Surface& s) {
  std::vector<Rim> rims;
  std::vector<Index> rim_of(s.vertex.size(), none);
  std::vector<bool> seen(s.vertex.size());
  for (const Use u : s.uses) {
    if (s.mate[u] != none) continue;
    begin_line();
    rim_of[u] = static_cast<Index>(rims.size());
    rims.push_back({u, s.curve(u)});
  }
  // Around a vertex, counter-clockwise: from the edge that leaves to the one that arrives.
  for (Index i = 0; i < rims.size(); ++i) {
    Use corner = rims[i].use;
    for (seen[corner] = true; s.mate[s.preceding(corner)] != none; seen[corner] = true)
      corner = s.mate[s.preceding(corner)];
    rims[rim_of[s.preceding(corner)]].next = i;
  }
  for (const Use u : s.uses) {  // what is not seen is in cycles
    int turns = seen[u] ? 1 : 0;
    for (Use corner = u; !seen[corner]; corner = s.mate[s.preceding(corner)])
      seen[corner] = true, turns += s.holds_x[corner];
    require(turns == 1, "the elements around a vertex inside make more than one turn");
  }
  return rims;
}

void check_embedding(const Elements& elements, const std::function<std::string_view()>& next_line) {
  Surface s(elements);
  s.glue();
  Tokens line(next_line());
  for (; line.accept("glue"); line = Tokens(next_line())) s.glue_line(line);
  std::vector<Rim> rims = check_vertices(s);

  Pairs pairs;
  const auto named = [&](const EdgeName& name) {
    const auto before = [](const Rim& rim, Use u) { return rim.use < u; };
    const auto at = std::lower_bound(rims.begin(), rims.end(), s.named(name), before);
    require(at != rims.end() && at->use == s.named(name), "pair: not an edge of the boundary");
    return static_cast<Index>(at - rims.begin());
  };
  const auto one_element = [&](Index i, Index j) { return rims[i].use / 4 == rims[j].use / 4; };
  for (; line.accept("pair"); line = Tokens(next_line())) {
    const Index i = named(line.edge_name()), j = named(line.edge_name());
    require(!one_element(i, j), "pair: edges of one element");
    check_pair(line, rims[i].curve, rims[j].curve, {rims[i].next == j, rims[j].next == i});
    line.expect_end();
    pairs.push_back(std::minmax({i, j}));
  }
  if (!line.accept("end")) throw Malformed{"expected glue, then pair, then end"};
  line.expect_end();
  std::sort(pairs.begin(), pairs.end());

  std::vector<std::vector<Curve>> loops;
  for (Rim& start : rims) {
    if (start.loop != none) continue;
    for (Rim* rim = (loops.emplace_back(), &start); rim->loop == none; rim = &rims[rim->next])
      rim->loop = static_cast<Index>(loops.size() - 1), loops.back().push_back(rim->curve);
  }
  std::vector<Box> boxes;  // of the edges, then of a ray to the right from one vertex of each loop
  mpq_class right = 0;
  for (const Rim& rim : rims) boxes.push_back(box_of(rim.curve)), right = std::max(right, boxes.back()[0][1]);
  for (const auto& loop : loops) {
    const Point p = point(loop[0], 0);
    boxes.push_back({Point{p[0], right}, Point{p[1], p[1]}});
  }
  std::vector<Index> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  Pairs crossed;  // a loop, an edge of another that its ray may cross
  meeting(boxes, all, [&](Index a, Index b) {
    const auto [i, j] = std::minmax({a, b});
    if (j < rims.size())
      require(one_element(i, j) || std::binary_search(pairs.begin(), pairs.end(), std::pair(i, j)),
              "a pair is missing");
    else if (i < rims.size() && rims[i].loop != j - rims.size())
      crossed.emplace_back(j - rims.size(), i);
  });
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  std::vector<int> around(loops.size());  // winding numbers of all other loops
  for (const auto& [loop, edge] : crossed)
    around[loop] += crossings(point(loops[loop][0], 0), rims[edge].curve);
  for (std::size_t i = 0; i < loops.size(); ++i)
    require(around[i] == (direction(loops[i]) > 0 ? 0 : 1),
            "not one preimage on one side of a loop, none on the other");
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
  std::vector<Use> left, reached{from};
  for (const Use u : s.uses)
    if (u != from && s.begin(u) == s.begin(from)) left.push_back(u);
  while (!reached.empty()) {
    const Use u = reached.back();
    reached.pop_back();
    spend(64 * left.size());
    const auto next = std::partition(left.begin(), left.end(), [&](Use v) {
      return !s.one_edge(u, s.preceding(v)) && !s.one_edge(s.preceding(u), v);
    });
    reached.insert(reached.end(), next, left.end());
    left.erase(next, left.end());
  }
  require(std::find(left.begin(), left.end(), to) != left.end(), "pinch: one fan");
}

/// Closeness of points, measured by an edge of an element and its farthest point.
struct Frame {
  Point a, c;
  mpq_class area;
  Frame(const Element& element, const Curve& edge) : a(point(edge, 1) - point(edge, 0)) {
    for (std::size_t i = 0; i < element.x.size(); ++i) {
      const Point to{fraction(element.x[i], element.unit), fraction(element.y[i], element.unit)};
      const mpq_class size = abs(cross(a, to - point(edge, 0)));
      if (size > area) area = size, c = to - point(edge, 0);
    }
  }
  bool close(const Point& p, const Point& q) const {
    const Point d = p - q;
    return area > 0 && 8 * abs(cross(d, c)) <= area && 8 * abs(cross(a, d)) <= area;
  }
};

void check_crack(const Surface& s, const std::vector<Use>& uses, const std::vector<Curve>& c,
                 const mpq_class& t) {
  require(s.opposite(uses[0], uses[1]) && 0 <= t && t <= 1, "gap: not two uses of one pair of vertices");
  crossings(point(c[0], t), c[1]);  // Rejected if the point may be on the curve
  const auto close = [&](int side) {
    const Frame frame(s.elements.element(uses[side] / 4), c[side]);
    bool all = true;
    for (int k = 1; k < 16; ++k)
      all = all && frame.close(point(c[0], fraction(k, 16)), point(c[1], fraction(16 - k, 16)));
    return all;
  };
  require(close(0) || close(1), "gap: not close");
}

void check_hanging(const Surface& s, const std::vector<Use>& uses, const std::vector<Curve>& c) {
  for (const int i : {0, 1, 2}) require(s.end(uses[i]) == s.begin(uses[(i + 1) % 3]), "gap: not a loop");
  require(uses[0] / 4 != uses[1] / 4 && uses[0] / 4 != uses[2] / 4, "gap: edges of one element");
  const Frame frame(s.elements.element(uses[0] / 4), c[0]);
  const Point node = point(c[2], 0);
  for (const Point& p : {node, point(c[1], fraction(1, 2)), point(c[2], fraction(1, 2))}) {
    bool close = false;
    for (int k = 0; k <= 32 && !close; ++k) close = frame.close(p, point(c[0], fraction(k, 32)));
    require(close, "gap: not close");
  }
  crossings(node, c[0]);
}

void check_gap(const Surface& s, Tokens& line) {
  std::vector<Use> uses{s.named(line.edge_name()), s.named(line.edge_name())};
  const bool hanging = Tokens(line).word().find('.') != std::string_view::npos;
  if (hanging) uses.push_back(s.named(line.edge_name()));
  std::vector<Curve> curves;
  for (const Use u : uses) {
    curves.push_back(s.curve(u));
    for (const Use v : s.uses) require(!s.one_edge(u, v), "gap: perhaps an edge is glued");
  }
  hanging ? check_hanging(s, uses, curves) : check_crack(s, uses, curves, line.rational());
}

}  // namespace

std::string check_mesh(const Elements& elements, const std::vector<Claim>& claims, Tokens& line,
                       const std::function<std::string_view()>& next_line) {
  std::string claim(line.word());
  const auto position = [&] { return line.small(1, static_cast<long>(elements.count())) - 1; };
  const auto injective = [](Claim c) { return c == Claim::injective; };
  if (claim == "embedding") {
    line.expect_end();
    require(std::all_of(claims.begin(), claims.end(), injective),
            "an element is not claimed to be injective");
    check_embedding(elements, next_line);
  } else if (claim == "refuted") {
    const std::string kind(line.word());
    claim += ' ' + kind;
    if (kind == "element") {
      const Claim c = claims.at(position());
      require(!injective(c) && c != Claim::regular && c != Claim::undecided,
              "element: not refuted by its claim");
    } else if (kind == "cover") {
      const std::size_t elements_named[] = {static_cast<std::size_t>(position()),
                                            static_cast<std::size_t>(position())};
      require(elements_named[0] != elements_named[1], "cover: one element");
      const mpq_class x = line.rational(), y = line.rational();
      for (const std::size_t i : elements_named) {
        require(injective(claims.at(i)), "cover: an element is not claimed to be injective");
        std::vector<Curve> edges;
        for (int e = 0; e < elements.corner_count(i); ++e)
          edges.push_back(edge_curve(elements.element(i), e));
        require(winding({x, y}, edges) == 1, "cover: the point is not in the element");
      }
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
