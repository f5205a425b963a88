// A mesh in parts that tests may change: nodes and elements as lists, made a mesh by the builder.
#pragma once

#include "bezcert/mesh/mesh_builder.hpp"

#include <optional>
#include <span>
#include <vector>

namespace bezcert::test {

struct MeshParts {
  ExactVector x, y, weights;
  std::vector<std::uint32_t> connectivity;
  std::vector<MeshElement> elements;
  bool glued_by_nodes = true;

  MeshParts() = default;
  explicit MeshParts(const Mesh& mesh)
      : x(mesh.coordinates(0)),
        y(mesh.coordinates(1)),
        weights(mesh.weights()),
        connectivity(mesh.connectivity()),
        elements(mesh.elements()),
        glued_by_nodes(mesh.glued_by_nodes()) {}

  Mesh build() const {
    MeshBuilder builder;
    for (std::size_t i = 0; i < x.size(); ++i) {
      builder.add_node({x[i], y[i]}, weights.empty() ? std::nullopt : std::optional(weights[i]));
    }
    for (const MeshElement& element : elements) {
      builder.add_elements(
          element.shape, element.basis,
          std::span(connectivity).subspan(element.first_node, coefficient_count(element.shape)));
    }
    builder.set_glued_by_nodes(glued_by_nodes);
    builder.origin().numbers = Numbers::decimal;
    return std::move(builder).build();
  }
};

}  // namespace bezcert::test
