#include "bezcert/certificate/direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bezcert {
namespace {

// All vectors lie between `low` and `high`, counter-clockwise; both of length about 1.
struct Cone {
  Vector2<double> low, high;
  double span = 0;  // of `angle_from`: 2 is half a turn
};

// Grows counter-clockwise with the angle from r to v, from -2 to 2; opposite vectors differ by 2.
double angle_from(const Vector2<double>& r, const Vector2<double>& v) {
  const double along = dot(r, v), across = cross(r, v);
  const double slope = across / (std::fabs(along) + std::fabs(across));
  if (along >= 0) return slope;
  return across >= 0 ? 2 - slope : -2 - slope;
}

// If the vectors lie in a half-plane their sum lies between them. Nothing if doubles do not tell.
std::optional<Cone> cone_of(const std::vector<AskedVector<double>>& vectors) {
  std::vector<Vector2<double>> units;
  units.reserve(vectors.size());
  Vector2<double> sum{0, 0};
  for (const AskedVector<double>& asked : vectors) {
    const double length = std::sqrt(dot(asked.v, asked.v));
    if (length == 0) {
      if (asked.strict) return std::nullopt;
      continue;
    }
    units.push_back({asked.v.x / length, asked.v.y / length});
    sum.x += units.back().x;
    sum.y += units.back().y;
  }
  if (units.empty() || (sum.x == 0 && sum.y == 0)) return std::nullopt;
  Cone result{units[0], units[0]};
  double low = angle_from(sum, units[0]), high = low;
  for (const Vector2<double>& unit : units) {
    const double angle = angle_from(sum, unit);
    if (angle < low) {
      low = angle;
      result.low = unit;
    }
    if (angle > high) {
      high = angle;
      result.high = unit;
    }
  }
  result.span = high - low;
  return result;
}

// Steps that lead from few digits to as many as a double has.
constexpr std::array<double, 24> sizes = {1,      2,      3,      4,      6,      8,      12,     16,
                                          32,     64,     128,    256,    1024,   4096,   16384,  65536,
                                          0x1p20, 0x1p24, 0x1p28, 0x1p32, 0x1p36, 0x1p40, 0x1p44, 0x1p48};
// Below that doubles do not tell signs.
constexpr double uncertain = 1e-13;

std::optional<Direction> in_cone(const Cone& cone, const std::function<bool(const Direction&)>& holds) {
  Vector2<double> middle{cone.low.x + cone.high.x, cone.low.y + cone.high.y};
  if (dot(cone.low, cone.high) < 0) {
    middle = {cone.high.y - cone.low.y, cone.low.x - cone.high.x};
  }
  const double size = std::max(std::fabs(middle.x), std::fabs(middle.y));
  int refused = 0;
  for (const double step : sizes) {
    const Vector2<double> n{std::floor(middle.x / size * step + 0.5),
                            std::floor(middle.y / size * step + 0.5)};
    const double least = uncertain * step;
    if (!(dot(n, cone.low) > least && dot(n, cone.high) > least)) continue;
    Direction direction{Integer(n.x), Integer(n.y)};
    if (holds(direction)) return direction;
    if (++refused == 4) return std::nullopt;
  }
  return std::nullopt;
}

void make_primitive(Direction& n) {
  const Integer divisor = gcd(n.x, n.y);
  if (divisor > 1) {
    n.x /= divisor;
    n.y /= divisor;
  }
}

Integer size_of(const Direction& n) { return std::max(Integer(abs(n.x)), Integer(abs(n.y))); }

// Rounds value * 2^bits / size to the nearest integer.
Integer rounded(const Integer& value, int bits, const Integer& size) {
  Integer doubled = abs(value) << (static_cast<unsigned>(bits) + 1);
  Integer result = (doubled / size + 1) / 2;
  return value.sign() < 0 ? Integer(-result) : result;
}

std::optional<Direction> exactly(const std::vector<AskedVector<Integer>>& vectors,
                                 const std::function<bool(const Direction&)>& holds) {
  std::vector<const AskedVector<Integer>*> all;
  for (const auto& asked : vectors) {
    if (!asked.v.x.is_zero() || !asked.v.y.is_zero()) {
      all.push_back(&asked);
    } else if (asked.strict) {
      return std::nullopt;
    }
  }
  for (const auto* low : all) {
    const AskedVector<Integer>* high = low;
    bool is_low = true, is_line = false;
    for (const auto* other : all) {
      const int turn = cross(low->v, other->v).sign();
      const bool opposite = turn == 0 && dot(low->v, other->v).sign() < 0;
      is_low = turn >= 0 && !(opposite && (low->strict || other->strict));
      if (!is_low) break;
      is_line = is_line || opposite;
      if (opposite || (!is_line && cross(high->v, other->v).sign() > 0)) high = other;
    }
    if (!is_low) continue;
    Direction left{-low->v.y, low->v.x}, right{high->v.y, -high->v.x};
    if (is_line) {
      make_primitive(left);
      if (holds(left)) return left;
      continue;
    }
    const Integer left_size = size_of(left), right_size = size_of(right);
    Direction middle{left.x * right_size + right.x * left_size, left.y * right_size + right.y * left_size};
    make_primitive(middle);
    const Integer size = size_of(middle);
    const int most = static_cast<int>(mpz_sizeinbase(size.backend().data(), 2));
    for (int bits = 16; bits < most; bits *= 2) {
      Direction n{rounded(middle.x, bits, size), rounded(middle.y, bits, size)};
      if (holds(n)) return n;
    }
    if (holds(middle)) return middle;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::string text_of(const Direction& n) { return n.x.str() + ' ' + n.y.str(); }

std::optional<Direction> find_direction(const std::vector<AskedVector<double>>& vectors,
                                        const std::function<std::vector<AskedVector<Integer>>()>& exact,
                                        const std::function<bool(const Direction&)>& holds) {
  if (const std::optional<Cone> cone = cone_of(vectors)) {
    if (cone->span > 2 + uncertain) return std::nullopt;
    if (cone->span < 2 - uncertain) {
      if (auto found = in_cone(*cone, holds)) return found;
    }
  }
  return exactly(exact(), holds);
}

}  // namespace bezcert
