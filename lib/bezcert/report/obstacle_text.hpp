// The words for what is wrong with a mesh as a whole: the only place that makes them.
#pragma once

#include "bezcert/surface/domain.hpp"
#include "bezcert/surface/embedding.hpp"

#include <string>

namespace bezcert {

/// Names the elements, nodes and coordinates, as the file of the mesh does.
std::string message(const Mesh& mesh, const MeshObstacle& obstacle);

/// The likely cause; may be empty.
std::string hint(const MeshObstacle& obstacle);

/// Why the curve is covered no further.
std::string message(const Mesh& mesh, const DomainFailure& failure);

/// "(0.5, 0.25)": six digits, for people.
std::string text_of(const Point& point);

}  // namespace bezcert
