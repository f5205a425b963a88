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

std::string_view name(Numbers numbers) { return numbers == Numbers::binary64 ? "binary64" : "decimal"; }

Element Mesh::element(std::size_t i) const {
  const MeshElement& entry = elements[i];
  const std::span<const std::uint32_t> nodes(connectivity.data() + entry.first_node,
                                             coefficient_count(entry.shape));
  return Element(entry.shape, entry.basis, {gather(x, nodes), gather(y, nodes)},
                 weights.empty() ? ExactVector() : gather(weights, nodes));
}

bool Mesh::rational(std::size_t i) const {
  if (weights.empty()) return false;
  const MeshElement& entry = elements[i];
  const std::uint32_t* nodes = connectivity.data() + entry.first_node;
  const std::size_t count = coefficient_count(entry.shape);
  return std::any_of(nodes, nodes + count, [&](std::uint32_t node) {
    return weights.binary64() ? weights.doubles()[node] != weights.doubles()[nodes[0]]
                              : weights.rationals()[node] != weights.rationals()[nodes[0]];
  });
}

}  // namespace bezcert
