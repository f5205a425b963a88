#include "bezcert/mesh/mesh.hpp"

#include <algorithm>
#include <span>

namespace bezcert {
namespace {

ExactVector gather(const ExactVector& from, std::span<const std::uint32_t> nodes) {
  if (from.binary64()) {
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const std::uint32_t node : nodes) values.push_back(from.doubles()[node]);
    return ExactVector(std::move(values));
  }
  std::vector<Rational> values;
  values.reserve(nodes.size());
  for (const std::uint32_t node : nodes) values.push_back(from.rationals()[node]);
  return ExactVector(std::move(values));
}

}  // namespace

Element Mesh::element(std::size_t i) const {
  const MeshElement& entry = elements_[i];
  const std::span<const std::uint32_t> nodes(connectivity_.data() + entry.first_node,
                                             coefficient_count(entry.shape));
  return Element(entry.shape, entry.basis, {gather(coordinates_[0], nodes), gather(coordinates_[1], nodes)},
                 weights_.empty() ? ExactVector() : gather(weights_, nodes));
}

bool Mesh::rational(std::size_t i) const {
  if (weights_.empty()) return false;
  const MeshElement& entry = elements_[i];
  const std::uint32_t* nodes = connectivity_.data() + entry.first_node;
  const std::size_t count = coefficient_count(entry.shape);
  return std::any_of(nodes, nodes + count, [&](std::uint32_t node) {
    return weights_.binary64() ? weights_.doubles()[node] != weights_.doubles()[nodes[0]]
                               : weights_.rationals()[node] != weights_.rationals()[nodes[0]];
  });
}

}  // namespace bezcert
