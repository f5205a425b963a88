// The mesh as a whole in the JSON Lines report (docs/report.md).
#pragma once

#include "bezcert/surface/domain.hpp"
#include "bezcert/surface/embedding.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace bezcert {

using Json = nlohmann::ordered_json;

/// {verdict, obstacles, components, loops, holes, area}.
Json mesh_object(const Mesh& mesh, const MeshResult& result);

/// {file, verdict, curves, covered, failures}.
Json domain_object(const std::string& file, const Mesh& mesh, const DomainResult& domain);

}  // namespace bezcert
