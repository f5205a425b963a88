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
  Curve curve;
  Point low, high;  ///< the box of the control points

  explicit Rim(const Curve& c) : curve(c), low(control_point(c, 0)), high(low) {
    for (std::size_t i = 1; i < c.x.size(); ++i) {
      const Point p = control_point(c, i);
      for (const int axis : {0, 1})
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
    }
  }
};
using Rims = std::map<Use, Rim>;

/// The lines `pair`, and that no two edges of the boundary whose boxes meet are without one.
void check_pairs(const Surface& s, const Rims& rims, const std::function<std::string_view()>& next_line) {
  std::set<std::pair<Use, Use>> pairs;
  Tokens line(next_line());
  for (; line.accept("pair"); line = Tokens(next_line())) {
    const Use a = s.named(line.edge_name()), b = s.named(line.edge_name());
    require(rims.contains(a) && rims.contains(b), "pair: not an edge of the boundary");
    require(a / 4 != b / 4, "pair: edges of one element");
    check_pair(line, rims.at(a).curve, rims.at(b).curve, {s.follower(a) == b, s.follower(b) == a});
    line.expect_end();
    pairs.insert(std::minmax(a, b));
  }
  if (!line.accept("end")) throw Malformed{"expected pair or end"};
  line.expect_end();

  std::vector<const Rims::value_type*> sorted;
  for (const auto& rim : rims) sorted.push_back(&rim);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto* a, const auto* b) { return a->second.low[0] < b->second.low[0]; });
  for (auto i = sorted.begin(); i != sorted.end(); ++i) {
    const auto& [u, a] = **i;
    for (auto j = i + 1; j != sorted.end() && (*j)->second.low[0] <= a.high[0]; ++j) {
      const auto& [v, b] = **j;
      spend(8);
      require(
          u / 4 == v / 4 || a.low[1] > b.high[1] || b.low[1] > a.high[1] || pairs.contains(std::minmax(u, v)),
          "a pair is missing");
    }
  }
}

/// Beside every loop there are points with one preimage on one side and with none on the other.
void check_loops(const Surface& s, const Rims& rims) {
  std::set<Use> seen;
  for (const auto& [start, first] : rims) {
    if (seen.contains(start)) continue;
    std::set<Use> own;
    std::vector<Curve> loop;
    for (Use u = start; own.insert(u).second; u = s.follower(u)) loop.push_back(rims.at(u).curve);
    const Point p = control_point(first.curve, 0);
    int around = 0;  // the winding numbers of all other loops
    for (const auto& [u, rim] : rims) {
      spend(8);
      if (!own.contains(u) && rim.low[1] <= p[1] && p[1] <= rim.high[1] && p[0] <= rim.high[0])
        around += crossings(p, rim.curve);
    }
    require(around == (direction(loop) > 0 ? 0 : 1),
            "not one preimage on one side of a loop, none on the other");
    seen.merge(own);
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
    Surface s(elements);
    s.glue();
    Rims rims;
    for (const Use u : s.uses) {
      begin_line();
      if (s.mate[u] == none) rims.try_emplace(u, s.curve(u));
    }
    check_pairs(s, rims, next_line);
    check_loops(s, rims);
  } else if (claim == "refuted") {
    claim += ' ' + check_refutation(elements, claims, line);
  } else if (claim != "undecided") {
    throw Malformed{"unknown claim of the mesh"};
  }
  line.expect_end();
  return claim;
}

}  // namespace verifier
