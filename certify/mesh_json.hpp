// The mesh as a whole in the JSON Lines report (docs/report.md).
#pragma once

#include "report.hpp"

#include <nlohmann/json.hpp>

namespace bezcert::certify {

using Json = nlohmann::ordered_json;

/// {verdict, obstacles, components, loops, holes, area}.
Json mesh_object(const Mesh& mesh, const MeshResult& result);

/// {file, verdict, curves, covered, failures}.
Json domain_object(const Mesh& mesh, const DomainSummary& domain);

}  // namespace bezcert::certify
