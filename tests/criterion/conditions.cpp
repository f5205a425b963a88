// Full and quick checks against the conditions as docs/criteria.md states them, written down again in
// rational numbers: cartesian points by their exponents, ratios of parallel vectors by division. Nets are
// random ones, and such as satisfy the cone's five conditions by construction, some of them spoilt in one
// place.
#include "bezcert/criterion/criterion.hpp"
#include "bezcert/criterion/quick_net.hpp"
#include "bezcert/element/forms.hpp"
#include "random_element.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <numeric>

using namespace bezcert;
using namespace bezcert::test;

namespace {

using Index = std::array<int, 3>;

struct Point {
  Rational x, y;
};

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Rational wedge(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Rational inner(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

Index plus_corner(Index index, int corner) {
  ++index[static_cast<std::size_t>(corner)];
  return index;
}

// a = lambda b with lambda > 0.
bool same_direction(const Point& a, const Point& b) {
  if (b.x.is_zero() && b.y.is_zero()) return false;
  const Rational lambda = b.x.is_zero() ? Rational(a.y / b.y) : Rational(a.x / b.x);
  return lambda > 0 && a.x == lambda * b.x && a.y == lambda * b.y;
}

// Control points and weights of a triangle by their exponents.
struct Triangle {
  int n;
  std::map<Index, Point> p;
  std::map<Index, Rational> w;

  explicit Triangle(const RawElement& raw) : n(raw.shape.degree(0)) {
    std::size_t k = 0;
    for (int r = 0; r <= n; ++r) {
      for (int c = 0; c <= n - r; ++c, ++k) {
        p[{n - r - c, c, r}] = {raw.x[k], raw.y[k]};
        w[{n - r - c, c, r}] = raw.w.empty() ? Rational(1) : raw.w[k];
      }
    }
  }

  Rational turn(const Index& a, const Index& b, const Index& c) const {
    return wedge(p.at(b) - p.at(a), p.at(c) - p.at(a));
  }

  bool control_net() const {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        const Index m{i, j, n - 1 - i - j};
        if (turn(plus_corner(m, 0), plus_corner(m, 1), plus_corner(m, 2)) <= 0) return false;
      }
    }
    return true;
  }

  bool orientation() const {
    for (const auto& [a, one] : p) {
      for (const auto& [b, two] : p) {
        for (const auto& [c, three] : p) {
          const int det = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                          a[2] * (b[0] * c[1] - b[1] * c[0]);
          if (det * turn(a, b, c) < 0) return false;
        }
      }
    }
    for (int corner = 0; corner < 3; ++corner) {
      Index m{};
      m[static_cast<std::size_t>(corner)] = n - 1;
      if (turn(plus_corner(m, 0), plus_corner(m, 1), plus_corner(m, 2)).is_zero()) return false;
    }
    return true;
  }

  bool cone(std::size_t edge) const {
    const auto index = [&](int i, int j) {
      Index e{};
      e[edge] = n - i - j;
      e[(edge + 1) % 3] = j;
      e[(edge + 2) % 3] = i;
      return e;
    };
    const auto at = [&](int i, int j) { return p.at(index(i, j)); };
    const auto weight = [&](int i, int j) { return Rational(w.at(index(i, j)) / w.at(index(n, 0))); };
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        if ((i > 0 || j == 0 || j == n) && weight(i, j) != 1) return false;
      }
    }
    const Point d = n == 1 ? at(0, 1) - at(0, 0) : at(1, n - 1) - at(1, 0);
    std::vector<Point> curve, projected;
    for (int j = 0; j <= n; ++j) {
      const Point o{(at(0, 0).x + at(0, n).x) / 2, (at(0, 0).y + at(0, n).y) / 2};
      const Rational own = weight(0, j), rest = 1 - own;
      curve.push_back(at(0, j));
      projected.push_back({rest * o.x + own * at(0, j).x, rest * o.y + own * at(0, j).y});
    }
    for (const std::vector<Point>& points : {curve, projected}) {
      std::vector<Point> left_of{d};
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        left_of.push_back(points[k + 1] - points[k]);
        if (inner(d, left_of.back()) <= 0) return false;
      }
      for (int i = 0; i < n; ++i) {
        for (const Point& v : left_of) {
          if (wedge(v, at(1, i) - points[static_cast<std::size_t>(i)]) <= 0) return false;
        }
      }
    }
    for (int i = 1; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        if (!same_direction(at(i, j + 1) - at(i, j), d)) return false;
        if (!same_direction(at(i + 1, j) - at(i, j), at(1, 0) - at(0, 0))) return false;
      }
    }
    return true;
  }

  Status expected(std::string_view criterion) const {
    const auto status = [](bool holds) { return holds ? Status::proved : Status::inconclusive; };
    if (criterion == "orientation") return status(orientation());
    if (criterion == "cone") return status(cone(0) || cone(1) || cone(2));
    for (const auto& [index, weight] : w) {
      if (weight != w.begin()->second) return Status::not_applicable;
    }
    return status(control_net());
  }
};

// Rows 1, 2, ... are a grid over d and e; the curve's inner points and its end are moved, its inner weights
// are free. Seen from edge 0; all coordinates are integers.
RawElement cone_net(Random& random) {
  const int n = static_cast<int>(random.integer(1, 4));
  RawElement result{Shape::triangle(n), {}, {}, {}};
  std::vector<long> along{0}, across{0};
  for (int k = 0; k < n; ++k) {
    along.push_back(along.back() + random.integer(6, 12));
    across.push_back(across.back() + random.integer(6, 12));
  }
  const Point d{random.integer(3, 6), random.integer(-3, 3)}, e{random.integer(-3, 3), random.integer(3, 6)};
  const bool rational = random.chance(60);
  const long moved = random.integer(0, 25);
  const Rational factor = random.integer(1, 3);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const long a = along[static_cast<std::size_t>(j)], b = across[static_cast<std::size_t>(i)];
      const bool curve = i == 0 && j > 0;
      result.x.push_back(a * d.x + b * e.x + (curve ? random.integer(-moved, moved) : 0));
      result.y.push_back(a * d.y + b * e.y + (curve ? random.integer(-moved, moved) : 0));
      const bool inner_weight = curve && j < n;
      if (rational) {
        result.w.push_back(inner_weight ? Rational(factor * Rational(random.integer(1, 12), 4)) : factor);
      }
    }
  }
  if (random.chance(40)) {  // spoilt in one place
    const auto k = static_cast<std::size_t>(random.integer(0, static_cast<long>(result.x.size()) - 1));
    if (rational && random.chance(40)) {
      result.w[k] *= random.integer(2, 3);
    } else {
      (random.chance(50) ? result.x : result.y)[k] += random.chance(50) ? 1 : -1;
    }
  }
  for (long k = random.integer(0, 2); k > 0; --k) result = rotate_corners(result);
  return result;
}

std::optional<Status> quick_status(const Criterion& criterion, const RawElement& raw) {
  std::vector<double> x, y;
  for (const Rational& value : raw.x) x.push_back(value.convert_to<double>());
  for (const Rational& value : raw.y) y.push_back(value.convert_to<double>());
  std::vector<std::uint32_t> nodes(x.size());
  std::iota(nodes.begin(), nodes.end(), 0U);
  QuickNet net;
  if (!net.load(raw.shape, Basis::bernstein, x, y, nodes)) return std::nullopt;
  return criterion.quick(net);
}

}  // namespace

TEST_CASE("conditions hold where their definitions do") {
  const std::uint64_t seed = seed_or(504);
  Random random(seed);
  std::map<std::string, std::map<Status, int>> seen;
  int quick = 0, curved_edge[3] = {};
  for (int i = 0; i < 6000; ++i) {
    const bool constructed = i % 2 == 0;
    const RawElement raw =
        constructed ? cone_net(random) : random_element(random, {.max_degree = 4, .quadrilaterals = false});
    const Triangle triangle(raw);
    const Element element = raw.build();
    const Forms forms(element, random.chance(50) ? Filter::on : Filter::off);
    INFO("seed " << seed << " case " << i << " " << raw.text());
    for (const char* name : {"control-net", "orientation", "cone"}) {
      INFO(name);
      const Criterion& criterion = *find_criterion(name);
      const Status expected = triangle.expected(name);
      REQUIRE(criterion.check(forms).status == expected);
      if (!element.rational()) {
        if (const auto status = quick_status(criterion, raw)) {
          REQUIRE(*status == expected);
          ++quick;
        }
      }
      ++seen[name + std::string(element.rational() ? ", weights" : "")][expected];
    }
    for (std::size_t edge = 0; edge < 3; ++edge) curved_edge[edge] += triangle.cone(edge);
  }
  INFO("seed " << seed << ", quick " << quick);
  for (const char* key : {"control-net", "orientation", "orientation, weights", "cone", "cone, weights"}) {
    INFO(key << ": proved " << seen[key][Status::proved] << ", not " << seen[key][Status::inconclusive]);
    CHECK(seen[key][Status::proved] > 300);
    CHECK(seen[key][Status::inconclusive] > 500);
  }
  CHECK(seen["control-net, weights"][Status::not_applicable] > 1000);
  CHECK(quick > 5000);
  for (const int count : curved_edge) CHECK(count > 200);
}
