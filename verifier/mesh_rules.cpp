// `mesh embedding`: boundary loops are simple and disjoint (by `pair` lines), and by their winding numbers
// every loop has points with one preimage on one side and with none on the other.
#include "rules.hpp"
#include "surface.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace verifier {

namespace {

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

/// Boundary edges, each with the one that follows it on its loop.
std::map<Use, Rim> boundary(const Surface& s) {
  std::map<Use, Rim> rims;
  for (const Use u : s.uses) {
    if (s.mate[u] != none) continue;
    begin_line();
    rims.try_emplace(u, u, s.curve(u));
  }
  for (auto& [u, rim] : rims) {
    Use corner = u;
    while (s.across(corner) != none) corner = s.across(corner);
    rims.at(s.preceding(corner)).next = &rim;
  }
  return rims;
}

void check_embedding(const Elements& elements, const std::function<std::string_view()>& next_line) {
  Surface s(elements);
  s.glue();
  std::map<Use, Rim> rims = boundary(s);

  std::set<std::pair<Use, Use>> pairs;
  const auto rim_named = [&](const EdgeName& name) -> const Rim& {
    const auto at = rims.find(s.named(name));
    require(at != rims.end(), "pair: not an edge of the boundary");
    return at->second;
  };
  Tokens line(next_line());
  for (; line.accept("pair"); line = Tokens(next_line())) {
    const Rim &a = rim_named(line.edge_name()), &b = rim_named(line.edge_name());
    require(a.use / 4 != b.use / 4, "pair: edges of one element");
    check_pair(line, a.curve, b.curve, {a.next == &b, b.next == &a});
    line.expect_end();
    pairs.insert(std::minmax(a.use, b.use));
  }
  if (!line.accept("end")) throw Malformed{"expected pair or end"};
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

}  // namespace

std::string check_mesh(const Elements& elements, const std::vector<Claim>& claims, Tokens& line,
                       const std::function<std::string_view()>& next_line) {
  std::string claim(line.word());
  if (claim == "embedding") {
    line.expect_end();
    require(std::all_of(claims.begin(), claims.end(), [](Claim c) { return c == Claim::injective; }),
            "an element is not claimed to be injective");
    check_embedding(elements, next_line);
  } else if (claim == "refuted") {
    claim += ' ' + check_refutation(elements, claims, line);
  } else if (claim != "undecided") {
    throw Malformed{"unknown claim of the mesh"};
  }
  line.expect_end();
  return claim;
}

}  // namespace verifier
