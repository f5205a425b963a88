#include "bezcert/surface/surface.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace bezcert {

Surface::Surface(const Mesh& mesh, ObstacleList& obstacles) : HalfEdges(mesh) {
  glue(obstacles);
  sort_corners();
  find_hanging_nodes(obstacles);
  link_fans(obstacles);
}

void Surface::sort_corners() {
  corner_start_.assign(mesh().coordinates(0).size() + 2, 0);
  for (const std::uint32_t vertex : begin_) ++corner_start_[vertex + 2];
  std::partial_sum(corner_start_.begin(), corner_start_.end(), corner_start_.begin());
  corners_.resize(count());
  for (HalfEdge h = 0; h < count(); ++h) corners_[corner_start_[begin_[h] + 1]++] = h;
  corner_start_.pop_back();
}

bool Surface::has_bad_vertices() const { return std::find(bad_.begin(), bad_.end(), true) != bad_.end(); }

std::vector<Fan> Surface::fans(std::uint32_t vertex) const {
  const std::span<const HalfEdge> all = corners(vertex);
  std::vector<bool> seen(all.size(), false);
  std::vector<Fan> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (seen[i]) continue;
    const HalfEdge seed = all[i];
    // Clockwise to where the fan begins; all around if it does not.
    HalfEdge begin = seed;
    while (!is_boundary(begin)) {
      begin = next(opposite(begin));
      if (begin == seed) break;
    }
    Fan fan;
    for (HalfEdge corner = begin;;) {
      fan.corners.push_back(corner);
      seen[static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), corner) - all.begin())] = true;
      corner = opposite(previous(corner));
      if (corner == no_half_edge) break;
      if (corner == begin) {
        fan.closed = true;
        break;
      }
    }
    result.push_back(std::move(fan));
  }
  return result;
}

HalfEdge Surface::previous_boundary(HalfEdge h) const {
  HalfEdge arriving = previous(h);
  while (!is_boundary(arriving)) arriving = previous(opposite(arriving));
  return next_boundary(arriving) == h ? arriving : no_half_edge;
}

class Surface::FanLinker {
 public:
  FanLinker(Surface& surface, ObstacleList& obstacles)
      : surface_(surface), obstacles_(obstacles), meant_(surface.meant_.begin(), surface.meant_.end()) {}

  void run() {
    for (HalfEdge h = 0; h < surface_.count(); ++h) {
      if (surface_.is_faulty(h)) surface_.bad_[surface_.begin(h)] = surface_.bad_[surface_.end(h)] = true;
    }
    for (std::uint32_t vertex = 0; vertex < surface_.vertex_limit(); ++vertex) {
      const std::span<const HalfEdge> corners = surface_.corners(vertex);
      if (corners.empty()) continue;
      const FanEnds one = fan_around(corners[0]);
      if (one.count != corners.size()) {
        several_fans(vertex);
      } else if (!one.closed) {
        surface_.open_[vertex] = true;
        link(one.first, one.last);
      }
    }
  }

 private:
  // The corners of the fan that holds a corner: how many, the first and the last of them (of a closed one
  // any).
  struct FanEnds {
    std::size_t count = 0;
    HalfEdge first = no_half_edge, last = no_half_edge;
    bool closed = false;
  };

  FanEnds fan_around(HalfEdge corner) const {
    FanEnds fan{1, corner, corner, false};
    for (;; ++fan.count) {  // counter-clockwise
      const HalfEdge across = surface_.opposite(surface_.previous(fan.last));
      if (across == no_half_edge) break;
      if (across == corner) {
        fan.closed = true;
        return fan;
      }
      fan.last = across;
    }
    for (; !surface_.is_boundary(fan.first); ++fan.count) {
      fan.first = surface_.next(surface_.opposite(fan.first));
    }
    return fan;
  }

  // The boundary arrives at the last corner of an open fan and leaves at the first.
  void link(HalfEdge first, HalfEdge last) {
    const HalfEdge arriving = surface_.previous(last);
    if (!surface_.is_faulty(arriving) && !surface_.is_faulty(first))
      surface_.next_boundary_[arriving] = first;
  }

  void several_fans(std::uint32_t vertex) {
    const std::vector<Fan> fans = surface_.fans(vertex);
    for (const Fan& fan : fans) {
      if (!fan.closed) link(fan.corners.front(), fan.corners.back());
    }
    if (surface_.bad_[vertex] && !is_pinched(fans)) return;
    surface_.bad_[vertex] = true;
    obstacles_.add(MeshVerdict::non_manifold, [&] { return pinched_vertex(vertex, fans); });
  }

  // Whether the fans of a vertex at which faulty edges end are several parts, even if the edges that were
  // meant to be glued join them. A faulty edge without a partner may belong anywhere: then nothing is said.
  bool is_pinched(const std::vector<Fan>& fans) const {
    std::vector<std::size_t> part(fans.size());
    std::iota(part.begin(), part.end(), std::size_t{0});
    std::vector<bool> leaves_alone(fans.size(), true);
    for (std::size_t i = 0; i < fans.size(); ++i) {
      const HalfEdge arriving = surface_.previous(fans[i].corners.back());
      if (fans[i].closed || !surface_.is_faulty(arriving)) continue;
      const auto partner = meant_.find(arriving);
      if (partner == meant_.end()) return false;
      for (std::size_t j = 0; j < fans.size(); ++j) {
        if (fans[j].corners.front() != partner->second) continue;
        leaves_alone[j] = false;
        std::replace(part.begin(), part.end(), part[i], part[j]);
      }
    }
    for (std::size_t j = 0; j < fans.size(); ++j) {
      if (!fans[j].closed && surface_.is_faulty(fans[j].corners.front()) && leaves_alone[j]) return false;
    }
    return std::any_of(part.begin(), part.end(), [&](std::size_t one) { return one != part[0]; });
  }

  // One element of each fan: they are what meets there.
  MeshObstacle pinched_vertex(std::uint32_t vertex, const std::vector<Fan>& fans) const {
    MeshObstacle result;
    result.cause = Cause::pinched_vertex;
    result.count = fans.size();
    for (const Fan& fan : fans) {
      result.add_element(surface_.element(*std::min_element(fan.corners.begin(), fan.corners.end())));
    }
    result.add_node(surface_, vertex);
    return result;
  }

  Surface& surface_;
  ObstacleList& obstacles_;
  const std::map<HalfEdge, HalfEdge> meant_;
};

void Surface::link_fans(ObstacleList& obstacles) {
  next_boundary_.assign(count(), no_half_edge);
  open_.assign(vertex_limit(), false);
  bad_.assign(vertex_limit(), false);
  FanLinker(*this, obstacles).run();
}

}  // namespace bezcert
