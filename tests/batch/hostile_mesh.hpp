// Elements that try to break a bound on rounding errors: coordinates that cancel, nets that are degenerate
// but for rounding, elements far from the origin, of all sizes, and elements that a block only just settles.
#pragma once

#include "bezcert/check/mesh_decider.hpp"
#include "mesh_parts.hpp"
#include "random_input.hpp"

#include <cmath>
#include <functional>

namespace bezcert::test {

/// One element as doubles.
struct DoubleNet {
  Shape shape;
  Basis basis = Basis::bernstein;
  std::vector<double> x, y, w;  ///< w is empty for a polynomial element
};

inline void append(MeshParts& mesh, const DoubleNet& net) {
  MeshElement element;
  element.shape = net.shape;
  element.basis = net.basis;
  element.first_node = mesh.connectivity.size();
  for (std::size_t i = 0; i < net.x.size(); ++i) {
    mesh.connectivity.push_back(static_cast<std::uint32_t>(mesh.x.size()));
    mesh.x.push_back(net.x[i]);
    mesh.y.push_back(net.y[i]);
    if (!net.w.empty()) mesh.weights.push_back(net.w[i]);
  }
  mesh.elements.push_back(element);
}

inline Mesh mesh_of(const DoubleNet& net) {
  MeshParts mesh;
  append(mesh, net);
  return mesh.build();
}

/// A number from -1 to 1 with 53 random bits.
inline double unit(Random& random) {
  return std::ldexp(static_cast<double>(random.integer(-(1L << 53), 1L << 53)), -53);
}

inline Shape random_shape(Random& random, bool rational) {
  // Exact arithmetic, which the answers are compared with, grows fast with the degree.
  const int highest = random.chance(90) ? 3 : 6;
  if (rational) return Shape::triangle(static_cast<int>(random.integer(1, 3)));
  if (random.chance(70)) return Shape::triangle(static_cast<int>(random.integer(1, highest)));
  const auto degree = [&] { return static_cast<int>(random.integer(1, highest == 3 ? 2 : 4)); };
  return Shape::square(degree(), degree());
}

/// The identity, its points moved by up to `noise` of their distance.
inline DoubleNet noisy_identity(Random& random, Shape shape, bool rational, double noise) {
  DoubleNet net{shape, !rational && random.chance(60) ? Basis::lagrange : Basis::bernstein, {}, {}, {}};
  for (int r = 0; r < row_count(shape); ++r) {
    for (int c = 0; c < column_count(shape, r); ++c) {
      net.x.push_back(c + noise * unit(random));
      net.y.push_back(r + noise * unit(random));
      if (rational)
        net.w.push_back(std::ldexp(1.5 + unit(random) / 2, static_cast<int>(random.integer(-2, 2))));
    }
  }
  return net;
}

/// Points on a line or on few lines, in skew coordinates: determinants that are 0 but for the rounding of
/// inputs.
inline void flatten(Random& random, DoubleNet& net) {
  const double a = unit(random), b = unit(random), c = unit(random), d = unit(random);
  const bool line = random.chance(50);
  for (std::size_t i = 0; i < net.x.size(); ++i) {
    const double s = net.x[i],
                 t = line ? std::ldexp(net.y[i], -static_cast<int>(random.integer(20, 60))) : net.y[i];
    net.x[i] = a * s + b * t;
    net.y[i] = c * s + d * t;
  }
}

inline void map_all(DoubleNet& net, const std::function<double(double)>& f) {
  for (auto* values : {&net.x, &net.y}) {
    for (double& value : *values) value = f(value);
  }
}

/// Thin along an axis or along a diagonal.
inline void squeeze(Random& random, DoubleNet& net) {
  const double thin = std::ldexp(1.0, -static_cast<int>(random.integer(1, 40)));
  const bool diagonal = random.chance(50);
  for (std::size_t i = 0; i < net.x.size(); ++i) {
    net.y[i] *= thin;
    if (!diagonal) continue;
    const double x = net.x[i], y = net.y[i];
    net.x[i] = 0.8 * x - 0.6 * y;
    net.y[i] = 0.6 * x + 0.8 * y;
  }
}

/// Far from the origin: up to all bits of the differences are lost to rounding of the input.
inline void shift_far(Random& random, DoubleNet& net) {
  const double far = std::ldexp(unit(random), static_cast<int>(random.integer(0, 60)));
  const double other = std::ldexp(unit(random), static_cast<int>(random.integer(0, 60)));
  for (double& x : net.x) x += far;
  for (double& y : net.y) y += other;
}

/// Of any size that doubles have, subnormal numbers included.
inline void scale_wildly(Random& random, DoubleNet& net) {
  const int common =
      static_cast<int>(random.chance(50) ? random.integer(-130, 130) : random.integer(-1080, 1015));
  const int more = random.chance(30) ? static_cast<int>(random.integer(-60, 60)) : 0;
  for (double& x : net.x) x = std::ldexp(x, common);
  for (double& y : net.y) y = std::ldexp(y, std::min(common + more, 1015));
  for (double& w : net.w) w = std::ldexp(w, static_cast<int>(random.integer(0, 1)) * (common % 40));
  // Finite in any case.
  map_all(net, [](double v) { return std::isfinite(v) ? v : 1.0; });
}

inline bool settled(const DoubleNet& net) {
  const Mesh mesh = mesh_of(net);
  return MeshDecider(mesh).decide_range(0, 1, [](std::size_t, const Decision&) {}).batch == 1;
}

/// Between a net that blocks settle and one that they do not: one that is settled, while a few
/// steps of the doubles further it is not. The first net if the pair is none such.
inline DoubleNet just_settled(const DoubleNet& good, const DoubleNet& bad) {
  const auto between = [&](double t) {
    DoubleNet net = good;
    for (std::size_t i = 0; i < net.x.size(); ++i) {
      net.x[i] += t * (bad.x[i] - good.x[i]);
      net.y[i] += t * (bad.y[i] - good.y[i]);
    }
    return net;
  };
  const auto by_block = [](const DoubleNet& net) {
    const auto* table = batch::find_block_table(net.shape, net.basis, !net.w.empty());
    const Mesh mesh = mesh_of(net);
    const std::size_t first = 0;
    batch::Settled result;
    batch::settle(
        *table,
        {mesh.coordinates(0).doubles().data(), mesh.coordinates(1).doubles().data(),
         mesh.weights().empty() ? nullptr : mesh.weights().doubles().data(), mesh.connectivity().data()},
        {&first, 1}, {&result, 1});
    return result.settled;
  };
  if (!by_block(good) || by_block(between(1))) return good;
  double low = 0, high = 1;
  for (int k = 0; k < 60 && high > low; ++k) {
    const double middle = low + (high - low) / 2;
    (by_block(between(middle)) ? low : high) = middle;
  }
  return between(low);
}

inline DoubleNet hostile_net(Random& random) {
  const bool rational = random.chance(20);
  const Shape shape = random_shape(random, rational);
  const double noise = std::ldexp(1.0, -static_cast<int>(random.integer(0, 6)));
  DoubleNet net = noisy_identity(random, shape, rational, noise);
  if (random.chance(25)) flatten(random, net);
  if (random.chance(25)) squeeze(random, net);
  if (random.chance(25)) shift_far(random, net);
  if (random.chance(5)) {
    DoubleNet bad = noisy_identity(random, shape, rational, 2);
    bad.basis = net.basis;
    net = just_settled(net, bad);
  }
  if (random.chance(15)) scale_wildly(random, net);
  return net;
}

}  // namespace bezcert::test
