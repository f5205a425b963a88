#include "bezcert/certificate/mesh_evidence.hpp"

#include "bezcert/certificate/pair_evidence.hpp"
#include "bezcert/certificate/refutation.hpp"
#include "bezcert/mesh/box_sweep.hpp"

#include <algorithm>
#include <map>
#include <ostream>

namespace bezcert {
namespace {

class EmbeddingWriter {
 public:
  EmbeddingWriter(const Mesh& mesh, const MeshSurface& surface) : edges_(mesh), surface_(surface) {}

  // Lines are kept until the last is known to exist: only then is it an embedding that is claimed.
  bool run(std::ostream& stream) {
    if (!pair_lines()) return false;
    stream << "mesh embedding\n";
    for (const std::string& line : lines_) stream << line << '\n';
    return true;
  }

 private:
  bool pair_lines() {
    std::vector<EdgeUse> uses;
    std::vector<Box> boxes;
    for (EdgeUse use = 0; use < edges_.count(); ++use) {
      if (!surface_.gluing.is_boundary(use)) continue;
      uses.push_back(use);
      boxes.push_back(edges_.box(RoundUp(), use));
    }
    bool complete = true;
    for_overlapping_boxes(boxes, [&](std::size_t i, std::size_t j) {
      const EdgeUse a = uses[i], b = uses[j];
      if (edges_.element(a) == edges_.element(b)) return true;
      const auto& next = surface_.fans.next_boundary;
      const Joints joints{next[a] == b, next[b] == a};
      // Resultants eliminate the parameter of the second edge: the other order is another chance.
      return complete =
                 pair_line(a, b, joints) || pair_line(b, a, {joints.begin_to_end, joints.end_to_begin});
    });
    return complete;
  }

  bool pair_line(EdgeUse a, EdgeUse b, Joints joints) {
    make_room();
    const auto pair = pair_evidence(curve(a), curve(b), joints);
    if (pair) lines_.push_back("pair " + edge_name(edges_, a) + ' ' + edge_name(edges_, b) + ' ' + *pair);
    return pair.has_value();
  }

  // Curves met lately: an edge has several neighbours.
  DyadicCurve& curve(EdgeUse use) {
    const auto found = curves_.find(use);
    if (found != curves_.end()) return found->second;
    return curves_.try_emplace(use, edges_.curve(use)).first->second;
  }
  void make_room() {
    constexpr std::size_t kept = 1024;
    if (curves_.size() > kept) curves_.clear();
  }

  MeshEdges edges_;
  const MeshSurface& surface_;
  std::vector<std::string> lines_;
  std::map<EdgeUse, DyadicCurve> curves_;
};

}  // namespace

std::string edge_name(const MeshEdges& edges, EdgeUse use) {
  return std::to_string(edges.element(use) + std::size_t{1}) + '.' + std::to_string(edges.edge(use));
}

bool write_mesh_evidence(std::ostream& stream, const Mesh& mesh, const MeshResult& result,
                         std::span<const ElementState> claims) {
  bool complete = result.verdict == MeshVerdict::undecided;
  if (result.verdict == MeshVerdict::embedding) {
    const bool all_injective = std::all_of(
        claims.begin(), claims.end(), [](ElementState state) { return state == ElementState::injective; });
    if (all_injective && EmbeddingWriter(mesh, *result.surface).run(stream)) return true;
  } else if (!complete) {
    if (const auto refutation = find_refutation(mesh, result, claims)) {
      stream << "mesh refuted " << *refutation << '\n';
      return true;
    }
  }
  stream << "mesh undecided\n";
  return complete;
}

}  // namespace bezcert
