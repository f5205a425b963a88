// The decision against an independent one: 20,000 random nets of degrees 2 to 4, many of them degenerate on
// purpose.
//
// det J is expanded anew in powers (jacobian_table.hpp). Folded: the witnesses are the proof. Everything
// else: a plain subdivision where that proves the sign, otherwise the critical points of det J
// (critical_points.hpp).
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/report/decision_text.hpp"
#include "critical_points.hpp"
#include "degenerate_nets.hpp"
#include "rational_polynomial.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace bezcert;
using namespace bezcert::test;

namespace {

struct Tally {
  std::map<std::string, int> seen;

  std::string text() const {
    std::string result;
    for (const auto& [what, number] : seen) result += what + " " + std::to_string(number) + "; ";
    return result;
  }
};

std::array<Rational, 2> uv_of(const Witness& witness) {
  const std::vector<Rational> uv = witness.parameter.affine();
  return {uv[0], uv[1]};
}

// The sign of det J at a witness, or 2 if it lies outside the domain.
int sign_at(const Table& n, Domain domain, const std::optional<Witness>& witness) {
  if (!witness) return 2;
  const auto [u, v] = uv_of(*witness);
  if (!in_domain(domain, u, v)) return 2;
  const int s = sign(n.at(u, v));
  return sign(witness->determinant) == s ? s : 2;
}

// det J on a column u = constant, or a row.
RationalPolynomial on_line(const Table& n, std::size_t fixed, const Rational& value) {
  RationalPolynomial result;
  if (fixed == 0) {
    for (const auto& row : n.rows) result.c.push_back(RationalPolynomial(row)(value));
  } else {
    Rational power = 1;
    for (const auto& row : n.rows) {
      result = result + power * RationalPolynomial(row);
      power *= value;
    }
  }
  result.shrink();
  return result;
}

// Whether a root is what it says: exact, or alone in its interval.
bool root_holds(const RealRoot& root) {
  if (root.polynomial.is_zero()) return root.lower <= root.upper;
  const RationalPolynomial f(root.polynomial.coefficients);
  if (root.is_rational()) return f(root.lower).is_zero();
  return sign(f(root.lower)) * sign(f(root.upper)) < 0 && count_roots(f, root.lower, root.upper) == 1;
}

enum class ZeroKind { wrong, rational, on_line, isolated };

// Whether det J vanishes at the zero that the decision shows. `oracle` is asked for only if it is needed.
template <class Oracle>
ZeroKind check_zero(const Table& n, Domain domain, const PlanarPoint& at, Oracle oracle) {
  if (!root_holds(at.u) || !root_holds(at.v)) return ZeroKind::wrong;
  const Rational width(Integer(1), Integer(1) << 39);
  if (at.u.upper - at.u.lower > width || at.v.upper - at.v.lower > width) return ZeroKind::wrong;
  if (at.is_rational()) {
    const bool holds = in_domain(domain, at.u.lower, at.v.lower) && n.at(at.u.lower, at.v.lower).is_zero();
    return holds ? ZeroKind::rational : ZeroKind::wrong;
  }
  if (at.u.is_rational() || at.v.is_rational()) {
    const std::size_t fixed = at.u.is_rational() ? 0 : 1;
    const RealRoot& free = fixed == 0 ? at.v : at.u;
    const RationalPolynomial f = on_line(n, fixed, fixed == 0 ? at.u.lower : at.v.lower);
    if (f.is_zero()) return ZeroKind::on_line;
    // A zero inside the domain or where the interval meets it.
    const Rational bound =
        domain == Domain::triangle ? Rational(1 - (fixed == 0 ? at.u.lower : at.v.lower)) : Rational(1);
    const Rational low = std::max(free.lower, Rational(0)), high = std::min(free.upper, bound);
    return low <= high && count_roots(f, low, high) > 0 ? ZeroKind::on_line : ZeroKind::wrong;
  }
  for (const ZeroBox& box : oracle().zeros) {
    if (at.u.lower <= box.upper[0] && box.lower[0] <= at.u.upper && at.v.lower <= box.upper[1] &&
        box.lower[1] <= at.v.upper) {
      return ZeroKind::isolated;
    }
  }
  return ZeroKind::wrong;
}

// ---- injectivity, in doubles
// --------------------------------------------------------------------------------

struct DoubleMap {
  Table x, y, w;
  explicit DoubleMap(const RawElement& e) : x(1, 1), y(1, 1), w(1, 1) {
    // One common scale: expanded() brings each list to its own denominators.
    std::vector<Rational> wx = e.x, wy = e.y, ww(e.x.size(), Rational(1));
    for (std::size_t i = 0; i < e.w.size(); ++i) {
      ww[i] = e.w[i];
      wx[i] *= e.w[i];
      wy[i] *= e.w[i];
    }
    x = expanded(e.shape, wx);
    y = expanded(e.shape, wy);
    w = expanded(e.shape, ww);
  }
  // Each coordinate up to a positive factor: a linear map of the plane.
  std::array<double, 2> at(double u, double v) const {
    const auto value = [&](const Table& f) {
      double sum = 0;
      for (std::size_t k = f.height(); k-- > 0;) {
        double row = 0;
        for (std::size_t i = f.width(); i-- > 0;) row = row * u + f.rows[k][i].convert_to<double>();
        sum = sum * v + row;
      }
      return sum;
    };
    const double below = value(w);
    return {value(x) / below, value(y) / below};
  }
};

std::array<double, 2> on_boundary(Domain domain, int edge, double t) {
  if (domain == Domain::triangle) {
    if (edge == 0) return {t, 0};
    return edge == 1 ? std::array{1 - t, t} : std::array{0.0, 1 - t};
  }
  switch (edge) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {1 - t, 1};
    default: return {0, 1 - t};
  }
}

// How often the image of the boundary runs around the image of an inner point; nothing if it comes too near.
std::optional<int> winding_number(const DoubleMap& map, Domain domain, double u, double v) {
  constexpr int chords = 200;
  const auto centre = map.at(u, v);
  double turn = 0, nearest = 1e300, longest = 0;
  const int edges = domain == Domain::triangle ? 3 : 4;
  std::array<double, 2> last = map.at(0, 0);
  for (int edge = 0; edge < edges; ++edge) {
    for (int k = 1; k <= chords; ++k) {
      const auto [a, b] = on_boundary(domain, edge, static_cast<double>(k) / chords);
      const auto next = map.at(a, b);
      const double px = last[0] - centre[0], py = last[1] - centre[1], qx = next[0] - centre[0],
                   qy = next[1] - centre[1];
      turn += std::atan2(px * qy - py * qx, px * qx + py * qy);
      nearest = std::min(nearest, std::hypot(qx, qy));
      longest = std::max(longest, std::hypot(next[0] - last[0], next[1] - last[1]));
      last = next;
    }
  }
  if (nearest < 4 * longest) return std::nullopt;
  return static_cast<int>(std::lround(turn / (2 * std::acos(-1.0))));
}

// Whether the two parts of the boundary come together: their chords cross, or all are near each other.
bool parts_meet(const DoubleMap& map, Domain domain, const Overlap& overlap) {
  constexpr int chords = 32;
  const auto chain = [&](const BoundaryRange& range) {
    std::vector<std::array<double, 2>> points;
    const double low = range.lower.convert_to<double>(), high = range.upper.convert_to<double>();
    for (int k = 0; k <= chords; ++k) {
      const auto [a, b] = on_boundary(domain, range.edge, low + (high - low) * k / chords);
      points.push_back(map.at(a, b));
    }
    return points;
  };
  const auto a = chain(overlap.first), b = chain(overlap.second);
  double size = 0, gap = 0;
  for (int k = 0; k < 8; ++k) {
    const auto p = map.at(0, 0),
               q = map.at(on_boundary(domain, 0, k / 7.0)[0], on_boundary(domain, 0, k / 7.0)[1]);
    size = std::max(size, std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  for (const auto& p : a) {
    for (const auto& q : b) gap = std::max(gap, std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  if (gap < 1e-9 * size) return true;
  const auto side = [](const auto& p, const auto& q, const auto& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  for (int i = 0; i < chords; ++i) {
    for (int j = 0; j < chords; ++j) {
      if (side(a[i], a[i + 1], b[j]) * side(a[i], a[i + 1], b[j + 1]) <= 0 &&
          side(b[j], b[j + 1], a[i]) * side(b[j], b[j + 1], a[i + 1]) <= 0) {
        return true;
      }
    }
  }
  return false;
}

void check_injectivity(Random& random, const TestNet& net, const Decision& decision, Tally& tally) {
  const Domain domain = net.element.shape.domain;
  if (decision.verdict == ElementVerdict::overlapping) {
    REQUIRE(decision.overlap);
    REQUIRE_FALSE((net.injective && !net.mirrored));
    REQUIRE(parts_meet(DoubleMap(net.element), domain, *decision.overlap));
    ++tally.seen["overlap confirmed"];
    return;
  }
  if (!random.chance(15)) return;
  const DoubleMap map(net.element);
  for (int k = 0; k < 2; ++k) {
    const double u = static_cast<double>(random.integer(20, 50)) / 100,
                 v = static_cast<double>(random.integer(15, 45)) / 100;
    if (const auto winding = winding_number(map, domain, u, v)) {
      CAPTURE(u, v);
      REQUIRE(*winding == 1);
      ++tally.seen["winding number 1"];
    }
  }
}

// ---- one net
// ------------------------------------------------------------------------------------------------

// The oracle takes milliseconds up to this degree of det J, and seconds at 9.
constexpr int quick_degree = 6;

// The oracle is asked wherever nothing simpler proves the answer, and for a share (in percent) of the other
// degenerate nets.
void check(Random& random, const TestNet& net, int oracle_share, Tally& tally) {
  const Element element = net.element.build();
  const Forms forms(element);
  const Decision decision = decide(forms);
  const Domain domain = net.element.shape.domain;
  const Table n = jacobian_table(net.element);
  ++tally.seen["verdict " + std::string(name(decision.verdict))];
  ++tally.seen["verdict " + std::string(name(decision.verdict)) + " of " + net.kind];
  ++tally.seen[std::string("sign by ") + std::string(name(decision.sign_proof))];
  ++tally.seen[element.rational() ? "rational" : "polynomial"];
  ++tally.seen[element.is_triangle() ? "triangle" : "quadrilateral"];
  CAPTURE(name(decision.verdict), open_text(decision));

  std::optional<LowestSign> lowest;
  const auto oracle = [&]() -> const LowestSign& {
    if (!lowest) {
      lowest = lowest_sign(n, domain);
      ++tally.seen["oracle asked"];
    }
    return *lowest;
  };
  const auto is_positive = [&](const Table& f) {
    if (subdivision_proves_positive(f, domain, 200)) {
      ++tally.seen["proved by plain subdivision"];
      return true;
    }
    ++tally.seen["oracle asked"];
    return lowest_sign(f, domain).sign == 1;
  };
  if (!net.mirrored && net.positive) REQUIRE(is_regular(decision.verdict));
  if (!net.mirrored && net.nonnegative) {
    REQUIRE((is_regular(decision.verdict) || decision.verdict == ElementVerdict::degenerate));
  }
  switch (decision.verdict) {
    case ElementVerdict::folded:
      REQUIRE(sign_at(n, domain, decision.witness) == -1);
      if (decision.other_witness) {
        const int other = sign_at(n, domain, decision.other_witness);
        REQUIRE((other == 0 || other == 1));
      } else {
        // det J <= 0: the zero is irrational.
        REQUIRE(decision.zero);
        REQUIRE(lowest_sign(negated(n), domain).sign == 0);
        const auto of_minus = [&] { return lowest_sign(negated(n), domain); };
        REQUIRE(check_zero(n, domain, decision.zero->at, of_minus) != ZeroKind::wrong);
        ++tally.seen["folded with an irrational zero only"];
      }
      return;
    case ElementVerdict::reversed:
      REQUIRE(is_positive(negated(n)));
      REQUIRE(sign_at(n, domain, decision.witness) == -1);
      return;
    case ElementVerdict::degenerate: {
      REQUIRE(decision.zero);
      if (n.is_zero()) {
        REQUIRE(decision.zero->dimension == 2);
        ++tally.seen["dimension 2"];
        return;
      }
      const ZeroKind kind = check_zero(n, domain, decision.zero->at, oracle);
      REQUIRE(kind != ZeroKind::wrong);
      // A zero is shown. det J >= 0 by the oracle, by construction or by a plain subdivision.
      if (random.chance(oracle_share) && total_degree(n) <= quick_degree) oracle();
      if (!lowest && net.nonnegative && !net.mirrored) {
        ++tally.seen["det J >= 0 by construction"];
      } else if (!lowest && subdivision_proves_positive(n, domain, 60, false)) {
        ++tally.seen["det J >= 0 by plain subdivision"];
      } else {
        REQUIRE(oracle().sign == 0);
        ++tally.seen["det J >= 0 by the oracle"];
      }
      ++tally.seen[kind == ZeroKind::rational  ? "zero rational"
                   : kind == ZeroKind::on_line ? "zero with one rational coordinate"
                                               : "zero with two irrational coordinates"];
      REQUIRE((decision.zero->dimension == 0 || decision.zero->dimension == 1));
      ++tally.seen["dimension " + std::to_string(decision.zero->dimension)];
      if (net.dimension) {
        REQUIRE(decision.zero->dimension == *net.dimension);
        ++tally.seen["dimension " + std::to_string(decision.zero->dimension) + " as constructed"];
      }
      if (decision.witness) REQUIRE(sign_at(n, domain, decision.witness) == 0);
      return;
    }
    case ElementVerdict::injective:
    case ElementVerdict::overlapping:
      REQUIRE(is_positive(n));
      check_injectivity(random, net, decision, tally);
      return;
    default: FAIL("not decided: " << open_text(decision));
  }
}

void run(std::uint64_t seed, int count, int oracle_share, Tally& tally) {
  for (int i = 0; i < count; ++i) {
    Random random(seed * 1000003 + static_cast<std::uint64_t>(i));  // so that a case can be run alone
    const TestNet net = test_net(random);
    INFO("seed " << seed << " case " << i << " " << net.kind << (net.mirrored ? " mirrored " : " ")
                 << net.element.text());
    check(random, net, oracle_share, tally);
  }
}

}  // namespace

TEST_CASE("20,000 random nets, many degenerate on purpose: the decision agrees with an independent one") {
  const std::uint64_t seed = seed_or(31);
  Tally tally;
  run(seed, 20000, 10, tally);
  WARN("seed " << seed << ": " << tally.text());
  // Agreement says nothing of a kind that was not met.
  const auto at_least = [&](const char* what, int number) {
    INFO(what << ": " << tally.seen[what]);
    CHECK(tally.seen[what] >= number);
  };
  at_least("verdict degenerate", 4000);
  at_least("verdict folded", 4000);
  at_least("verdict injective", 3000);
  at_least("verdict reversed", 600);
  at_least("overlap confirmed", 1);
  at_least("sign by algebra", 2000);
  at_least("sign by coefficients", 5000);
  at_least("sign by subdivision", 1000);
  at_least("triangle", 8000);
  at_least("quadrilateral", 4000);
  at_least("rational", 3000);
  at_least("oracle asked", 600);
  at_least("det J >= 0 by the oracle", 500);
  at_least("det J >= 0 by construction", 1000);
  at_least("det J >= 0 by plain subdivision", 500);
  at_least("proved by plain subdivision", 3000);
  at_least("dimension 0 as constructed", 1500);
  at_least("dimension 1 as constructed", 200);
  at_least("dimension 2", 300);
  at_least("zero rational", 3000);
  at_least("zero with one rational coordinate", 40);
  at_least("zero with two irrational coordinates", 200);
  at_least("folded with an irrational zero only", 30);
  at_least("winding number 1", 600);
}

TEST_CASE("100,000 more random nets, the oracle asked for every degenerate one", "[.nightly]") {
  const std::uint64_t seed = seed_or(32);
  Tally tally;
  run(seed, 100000, 100, tally);
  WARN("seed " << seed << ": " << tally.text());
  CHECK(tally.seen["det J >= 0 by the oracle"] > 10000);
}
