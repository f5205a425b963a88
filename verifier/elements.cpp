// The numbers of an elements file as integers, and the places of an element's points.
#include "elements.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace verifier {

namespace {

/// Appends the numbers as integers, all times the power of two that is returned.
mpz_class scale(const std::vector<double>& values, Integers& integers) {
  int least = 0, exponent = 0;
  for (const double value : values) {
    std::frexp(value, &exponent);
    least = std::min(least, exponent - 53);
  }
  for (const double value : values) {
    integers.emplace_back(static_cast<long>(std::ldexp(std::frexp(value, &exponent), 53)));
    integers.back() <<= static_cast<unsigned>(exponent - 53 - least);
  }
  return mpz_class(1) << static_cast<unsigned>(-least);
}

/// The same with the least common denominator.
mpz_class scale(const std::vector<mpq_class>& values, Integers& integers) {
  mpz_class unit = 1;
  const auto work = [&] { spend(1024 * (1 + mpz_size(unit.get_mpz_t()))); };
  for (const mpq_class& value : values) work(), unit = lcm(unit, value.get_den());
  for (const mpq_class& value : values) work(), integers.push_back(unit / value.get_den() * value.get_num());
  return unit;
}

}  // namespace

std::size_t edge_place(bool triangle, std::size_t p, std::size_t q, std::size_t e, std::size_t k,
                       std::size_t ring) {
  const std::size_t lost = ring * (triangle ? 3 : 2), a = p - lost, b = q - lost;  // degrees of the ring
  const std::size_t us[] = {0, a, triangle ? 0 : a, 0, 0}, vs[] = {0, 0, b, triangle ? 0 : b, 0};  // corners
  const std::size_t n = std::max<std::size_t>(1, e % 2 == 0 ? a : b);
  const std::size_t u = ring + (us[e] * (n - k) + us[e + 1] * k) / n;
  const std::size_t v = ring + (vs[e] * (n - k) + vs[e + 1] * k) / n;
  return triangle ? v * (2 * p + 3 - v) / 2 + u : v * (p + 1) + u;
}

Elements::Elements(std::string bytes, std::string_view basis, std::string_view numbers)
    : bytes_(std::move(bytes)),
      binary64_(numbers == "binary64"),
      json_(std::string_view(bytes_)
                .substr(std::min(bytes_.find_first_not_of(" \t\r\n"), bytes_.size()))
                .starts_with('{')) {
  const bool lagrange = basis == "lagrange", decimal = numbers == "decimal";
  if (!(json_ ? basis == "mixed" && decimal : (lagrange || basis == "bernstein") && (binary64_ || decimal)))
    throw Malformed{"basis and numbers do not fit the elements file"};
  if (bytes_.size() > 0xffffffff) throw Malformed{"limit: elements file of more than 4 GiB"};
  json_ ? read_json() : read_msh(lagrange);
  if (shapes_.empty()) throw Malformed{"elements file: no triangles, no quadrilaterals"};
}

mpz_class Elements::scaled(std::initializer_list<const Column*> columns, std::size_t i, Integers& all) const {
  std::vector<double> doubles;
  std::vector<mpq_class> exact;
  const std::uint32_t* const places = &nodes_[shapes_[i].first];
  const std::size_t count = point_count(shapes_[i].triangle, shapes_[i].p, shapes_[i].q);
  for (const Column* column : columns)
    for (std::size_t k = 0; k < count; ++k)
      binary64_ ? doubles.push_back(column->doubles[places[k]])
                : exact.push_back(exact_number(column->texts[places[k]], json_));
  return binary64_ ? scale(doubles, all) : scale(exact, all);
}

Element Elements::element(std::size_t i) const {
  const Shape& shape = shapes_[i];
  Element e{shape.triangle, shape.p, shape.q, shape.lagrange, false, {}, {}, {}, {}};
  e.unit = scaled({&x_, &y_}, i, e.x);
  const auto middle = e.x.begin() + std::ssize(e.x) / 2;
  e.y.assign(std::move_iterator(middle), std::move_iterator(e.x.end()));
  e.x.erase(middle, e.x.end());
  if (!w_.texts.empty()) scaled({&w_}, i, e.w);
  for (const mpz_class& w : e.w) {
    if (w <= 0) throw Malformed{"weight not positive"};
    e.rational = e.rational || w != e.w[0];
  }
  if (!e.rational) e.w.assign(e.x.size(), 1);
  return e;
}

}  // namespace verifier
