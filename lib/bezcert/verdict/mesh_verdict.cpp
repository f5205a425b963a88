#include "bezcert/verdict/mesh_verdict.hpp"

namespace bezcert {

std::string_view name(MeshVerdict verdict) {
  switch (verdict) {
    case MeshVerdict::embedding: return "embedding";
    case MeshVerdict::invalid_element: return "invalid_element";
    case MeshVerdict::non_manifold: return "non_manifold";
    case MeshVerdict::non_conforming: return "non_conforming";
    case MeshVerdict::folded_vertex: return "folded_vertex";
    case MeshVerdict::overlapping_boundary: return "overlapping_boundary";
    case MeshVerdict::undecided: return "undecided";
  }
  return "";
}

}  // namespace bezcert
