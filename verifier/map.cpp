#include "map.hpp"

#include <iterator>

namespace verifier {

namespace {

/// The polynomial with these control points, or these values at the nodes, times a number that depends on the
/// shape.
Polynomial2 in_powers(const Element& e, Integers values) {
  Form f{e.triangle, e.p, e.q, std::move(values)};
  if (e.lagrange) {
    for (const bool along_v : {false, true}) f.lines(along_v, differences);
    for (const bool along_v : {false, true}) {
      const int degree = along_v ? e.q : e.p;
      f.lines(along_v, [&](Line line) { newton_to_power(line, degree, degree); });
    }
  } else {
    const Form one = form({{1}}, e.triangle, e.p, e.q);  // the multinomials
    for (std::size_t k = 0; k < f.c.size(); ++k) f.c[k] *= one.c[k];
    for (const bool along_v : {false, true}) f.lines(along_v, [](Line line) { shear(line, true); });
  }
  Polynomial2 rows;
  f.lines(false, [&](Line line) {
    rows.emplace_back(std::move_iterator(line.first), std::move_iterator(line.first + line.size));
  });
  trim(rows);
  return rows;
}

}  // namespace

Map map_of(const Element& e) {
  if (!e.rational) return {in_powers(e, e.x), in_powers(e, e.y), {{1}}};
  Integers x = e.x, y = e.y, w = e.w;
  for (std::size_t i = 0; i < w.size(); ++i) x[i] *= e.w[i], y[i] *= e.w[i], w[i] *= e.unit;
  const Map map{in_powers(e, x), in_powers(e, y), in_powers(e, w)};
  for (const mpz_class& weight : form(map.w, e.triangle, e.p, e.q).c)
    if (weight <= 0) throw Malformed{"a control weight that is not positive"};
  return map;
}

Polynomial2 jacobian_numerator(const Map& map, bool rational) {
  const auto minor = [](const Polynomial2& f, const Polynomial2& g) {
    return derivative(f, false) * derivative(g, true) - derivative(f, true) * derivative(g, false);
  };
  if (!rational) return minor(map.x, map.y);
  return map.x * minor(map.y, map.w) - map.y * minor(map.x, map.w) - map.w * minor(map.y, map.x);
}

Point element_point(const Element& e, std::size_t i) {
  return {fraction(e.x[i], e.unit), fraction(e.y[i], e.unit)};
}

std::vector<Curve> edge_curves(const Element& e) {
  Map map = map_of(e);
  if (!e.rational) map.w = in_powers(e, Integers(e.x.size(), e.unit));
  const Form x = form(map.x, e.triangle, e.p, e.q), y = form(map.y, e.triangle, e.p, e.q),
             w = form(map.w, e.triangle, e.p, e.q);
  std::vector<Curve> edges(e.triangle ? 3 : 4);
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (int j = 0; j <= (k % 2 == 0 ? e.p : e.q); ++j) {
      const std::size_t i = edge_place(e.triangle, e.p, e.q, k, j);
      edges[k].x.push_back(x.c[i]), edges[k].y.push_back(y.c[i]), edges[k].w.push_back(w.c[i]);
    }
  return edges;
}

}  // namespace verifier
