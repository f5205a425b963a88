#include "bezcert/certificate/mesh_evidence.hpp"

#include "bezcert/certificate/pair_evidence.hpp"
#include "bezcert/certificate/refutation.hpp"
#include "bezcert/curve/box.hpp"

#include <algorithm>
#include <map>
#include <ostream>

namespace bezcert {
namespace {

class EmbeddingWriter {
 public:
  explicit EmbeddingWriter(const Surface& surface) : surface_(surface) {}

  // Lines are kept until the last is known to exist: only then is it an embedding that is claimed.
  bool run(std::ostream& stream) {
    if (!pair_lines()) return false;
    stream << "mesh embedding\n";
    for (const std::string& line : lines_) stream << line << '\n';
    return true;
  }

 private:
  bool pair_lines() {
    std::vector<HalfEdge> boundary;
    std::vector<Box> boxes;
    for (HalfEdge h = 0; h < surface_.count(); ++h) {
      if (!surface_.is_boundary(h)) continue;
      boundary.push_back(h);
      boxes.push_back(surface_.box(RoundUp(), h));
    }
    bool complete = true;
    for_overlapping_boxes(boxes, [&](std::size_t i, std::size_t j) {
      const HalfEdge a = boundary[i], b = boundary[j];
      if (surface_.element(a) == surface_.element(b)) return true;
      const Joints joints{surface_.next_boundary(a) == b, surface_.next_boundary(b) == a};
      // Resultants eliminate the parameter of the second edge: the other order is another chance.
      return complete =
                 pair_line(a, b, joints) || pair_line(b, a, {joints.begin_to_end, joints.end_to_begin});
    });
    return complete;
  }

  bool pair_line(HalfEdge a, HalfEdge b, Joints joints) {
    make_room();
    const auto pair = pair_evidence(curve(a), curve(b), joints);
    if (pair) lines_.push_back("pair " + edge_name(surface_, a) + ' ' + edge_name(surface_, b) + ' ' + *pair);
    return pair.has_value();
  }

  // Curves met lately: an edge has several neighbours.
  DyadicCurve& curve(HalfEdge h) {
    const auto found = curves_.find(h);
    if (found != curves_.end()) return found->second;
    return curves_.try_emplace(h, surface_.curve(h)).first->second;
  }
  void make_room() {
    constexpr std::size_t kept = 1024;
    if (curves_.size() > kept) curves_.clear();
  }

  const Surface& surface_;
  std::vector<std::string> lines_;
  std::map<HalfEdge, DyadicCurve> curves_;
};

}  // namespace

std::string edge_name(const HalfEdges& edges, HalfEdge h) {
  return std::to_string(edges.element(h) + std::size_t{1}) + '.' + std::to_string(edges.edge(h));
}

bool write_mesh_evidence(std::ostream& stream, const MeshResult& result,
                         std::span<const ElementState> claims) {
  bool complete = result.verdict == MeshVerdict::undecided;
  if (result.verdict == MeshVerdict::embedding) {
    const bool all_injective = std::all_of(
        claims.begin(), claims.end(), [](ElementState state) { return state == ElementState::injective; });
    if (all_injective && EmbeddingWriter(*result.surface).run(stream)) return true;
  } else if (!complete) {
    if (const auto refutation = find_refutation(result, claims)) {
      stream << "mesh refuted " << *refutation << '\n';
      return true;
    }
  }
  stream << "mesh undecided\n";
  return complete;
}

}  // namespace bezcert
