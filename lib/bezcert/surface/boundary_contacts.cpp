#include "bezcert/surface/boundary_contacts.hpp"

#include "bezcert/curve/incidence.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/surface/one_way.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace bezcert {
namespace {

Joints joints_of(const Surface& surface, HalfEdge a, HalfEdge b) {
  return {surface.end(a) == surface.begin(b), surface.begin(a) == surface.end(b)};
}

// Whether two boundary edges whose boxes overlap have to be compared.
bool may_meet(const Surface& surface, const std::optional<std::uint32_t>& element, HalfEdge a, HalfEdge b) {
  if (surface.element(a) == surface.element(b)) return false;  // it is injective
  if (element && surface.element(a) != *element && surface.element(b) != *element) return false;
  // Edges that begin (or end) at one vertex are parts of different fans or of a gluing obstacle: already
  // reported.
  if (surface.begin(a) == surface.begin(b) || surface.end(a) == surface.end(b)) return false;
  const Joints joints = joints_of(surface, a, b);
  // Of the many edges at a vertex where parts touch only those of one part are compared: it is an obstacle
  // already.
  if (joints.end_to_begin && surface.is_bad(surface.begin(b)) && surface.next_boundary(a) != b) return false;
  if (joints.begin_to_end && surface.is_bad(surface.begin(a)) && surface.next_boundary(b) != a) return false;
  if (joints.end_to_begin == joints.begin_to_end) return true;
  return joints.end_to_begin ? !run_one_way(surface, a, b) : !run_one_way(surface, b, a);
}

// Calls visit(a, b) for near edges until it returns false. Returns false if more than `limit` boxes overlap.
bool for_near_edges(const Surface& surface, const std::optional<std::uint32_t>& element, std::size_t limit,
                    const std::function<bool(HalfEdge, HalfEdge)>& visit) {
  std::vector<HalfEdge> half_edges;
  std::vector<Box> boxes;
  {
    const RoundUp up;
    for (HalfEdge h = 0; h < surface.count(); ++h) {
      if (!surface.is_boundary(h) || surface.is_faulty(h)) continue;
      half_edges.push_back(h);
      boxes.push_back(surface.box(up, h));
    }
  }
  std::size_t overlaps = 0;
  for_overlapping_boxes(boxes, [&](std::size_t i, std::size_t j) {
    if (++overlaps > limit) return false;
    return !may_meet(surface, element, half_edges[i], half_edges[j]) || visit(half_edges[i], half_edges[j]);
  });
  return overlaps <= limit;
}

class BoundaryCheck {
 public:
  BoundaryCheck(const Surface& surface, const ContactBudget& budget, ObstacleList& obstacles)
      : surface_(surface), budget_(budget), obstacles_(obstacles) {}

  void run(const std::optional<std::vector<NearEdges>>& near) {
    const auto look = [&](HalfEdge a, HalfEdge b) {
      look_at(a, b);
      return found_ < ObstacleList::kept;
    };
    if (!near) {
      constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
      for_near_edges(surface_, obstacles_.element(), all, look);
      return;
    }
    for (const auto& [a, b] : *near) {
      if (!look(a, b)) return;
    }
  }

 private:
  std::uint32_t begin(HalfEdge h) const { return surface_.begin(h); }
  std::uint32_t end(HalfEdge h) const { return surface_.end(h); }

  void look_at(HalfEdge a, HalfEdge b) {
    const ContactResult result = find_contact(curve(a), curve(b), joints_of(surface_, a, b), budget_);
    if (result.status == ContactStatus::none) return;
    if (result.status == ContactStatus::open) return open(a, b, *result.exceeded);
    const CurveNet<Integer> net_a = surface_.exact(a), net_b = surface_.exact(b);
    if (same_curve(net_a, reversed(net_b))) return add(with_ends(Cause::unmerged_edges, a, b));
    Contact contact = *result.contact;
    contact.along_a_piece = contact.along_a_piece || run_together(net_a, net_b);
    if (contact.along_a_piece && (hanging(a, net_a, b) || hanging(b, net_b, a))) return;
    if (nearly_hanging(a, b)) return;
    if (two_nodes(a, b, contact)) return;
    meet(a, b, contact, net_a);
  }

  // Curves of the edges compared lately, so that a neighbour's subdivision is not done again.
  DyadicCurve& curve(HalfEdge h) {
    constexpr std::size_t kept = 4096;
    if (curves_.size() >= kept && !curves_.contains(h)) {
      // Both curves of a pair must live: one is fetched right after the other.
      for (auto it = curves_.begin(); it != curves_.end();)
        it = it->first == last_ ? std::next(it) : curves_.erase(it);
    }
    last_ = h;
    return curves_.try_emplace(h, surface_.curve(h)).first->second;
  }

  MeshObstacle obstacle(Cause cause, std::initializer_list<HalfEdge> edges) const {
    MeshObstacle result;
    result.cause = cause;
    for (const HalfEdge h : edges) result.add_edge(surface_, h);
    return result;
  }

  // About two edges and all their ends.
  MeshObstacle with_ends(Cause cause, HalfEdge a, HalfEdge b) const {
    MeshObstacle result = obstacle(cause, {a, b});
    for (const std::uint32_t node : {begin(a), end(a), begin(b), end(b)}) result.add_node(surface_, node);
    return result;
  }

  void add(MeshObstacle obstacle) {
    ++found_;
    obstacles_.add(std::move(obstacle));
  }

  void open(HalfEdge a, HalfEdge b, const ExceededBits& exceeded) {
    MeshObstacle result = with_ends(Cause::contact_open, a, b);
    result.exceeded = exceeded;
    add(std::move(result));
  }

  // An end of `other` inside edge `h`, along which run it and all boundary edges between it and an end of
  // `h`.
  bool hanging(HalfEdge h, const CurveNet<Integer>& net, HalfEdge other) {
    const std::vector<HalfEdge> chain = chain_along(h, net);
    if (std::find(chain.begin(), chain.end(), other) == chain.end()) return false;
    for (const std::uint32_t node : {begin(other), end(other)}) {
      if (node == begin(h) || node == end(h) || !passes_inside(net, surface_.point(node))) continue;
      if (!hanging_.insert({node, h}).second) return true;
      MeshObstacle result = obstacle(Cause::hanging_on_border, {});
      for (const HalfEdge one : chain) {
        if (begin(one) == node || end(one) == node) result.add_edge(surface_, one);
      }
      result.add_edge(surface_, h);
      sort_unique(result.elements);
      result.add_node(surface_, node);
      result.distance = DistanceBounds{};
      add(std::move(result));
      return true;
    }
    return false;
  }

  // The boundary edges before and after `h` that run along it, as far as they do.
  std::vector<HalfEdge> chain_along(HalfEdge h, const CurveNet<Integer>& net) const {
    constexpr std::size_t longest = 256;
    std::vector<HalfEdge> chain;
    const auto walk = [&](HalfEdge (Surface::*step)(HalfEdge) const) {
      for (HalfEdge one = (surface_.*step)(h); one != no_half_edge && one != h && chain.size() < longest;
           one = (surface_.*step)(one)) {
        if (!run_together(net, surface_.exact(one))) break;
        if (std::find(chain.begin(), chain.end(), one) != chain.end()) break;
        chain.push_back(one);
      }
    };
    walk(&Surface::next_boundary);
    walk(&Surface::previous_boundary);
    return chain;
  }

  // The two belong to a hole of three edges that is not open: an edge and two edges between its ends.
  bool nearly_hanging(HalfEdge a, HalfEdge b) {
    std::array<HalfEdge, 3> loop = {a, surface_.next_boundary(a), no_half_edge};
    if (loop[1] == no_half_edge) return false;
    loop[2] = surface_.next_boundary(loop[1]);
    if (loop[2] == no_half_edge || surface_.next_boundary(loop[2]) != a || (b != loop[1] && b != loop[2]))
      return false;
    const auto length = [&](HalfEdge h) {
      const Point p = surface_.point(begin(h)), q = surface_.point(end(h));
      return Rational((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
    };
    const auto longest = std::max_element(loop.begin(), loop.end(),
                                          [&](HalfEdge p, HalfEdge q) { return length(p) < length(q); });
    std::rotate(loop.begin(), longest, loop.end());
    const std::uint32_t node = end(loop[1]);
    if (!hanging_.insert({node, loop[0]}).second) return true;
    MeshObstacle result = obstacle(Cause::hanging_in_gap, {loop[0], loop[1], loop[2]});
    sort_unique(result.elements);
    result.add_node(surface_, node);
    result.distance = distance_bounds(surface_.exact(loop[0]), surface_.point(node));
    add(std::move(result));
    return true;
  }

  // They meet in a point that is a node of both, by two numbers.
  bool two_nodes(HalfEdge a, HalfEdge b, const Contact& contact) {
    const auto node_at = [&](HalfEdge h, const ParameterRange& range) -> std::optional<std::uint32_t> {
      if (range.lower != range.upper) return std::nullopt;
      if (range.lower.sign() == 0) return begin(h);
      if (range.lower == 1) return end(h);
      return std::nullopt;
    };
    const auto node_a = node_at(a, contact.first), node_b = node_at(b, contact.second);
    if (!node_a || !node_b || contact.along_a_piece) return false;
    if (!touching_.insert(std::minmax(*node_a, *node_b)).second) return true;
    MeshObstacle result = obstacle(Cause::unmerged_nodes, {a, b});
    result.add_node(surface_, *node_a);
    result.add_node(surface_, *node_b);
    add(std::move(result));
    return true;
  }

  void meet(HalfEdge a, HalfEdge b, const Contact& contact, const CurveNet<Integer>& net_a) {
    const Cause cause = contact.along_a_piece ? Cause::edges_overlap : Cause::edges_meet;
    MeshObstacle result = with_ends(cause, a, b);
    result.at = {contact.first, contact.second};
    result.points = {point_at(net_a, Rational((contact.first.lower + contact.first.upper) / 2))};
    add(std::move(result));
  }

  const Surface& surface_;
  const ContactBudget& budget_;
  ObstacleList& obstacles_;
  std::map<HalfEdge, DyadicCurve> curves_;
  HalfEdge last_ = no_half_edge;
  // Already reported: (node, edge), and two nodes.
  std::set<std::pair<std::uint32_t, HalfEdge>> hanging_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> touching_;
  std::size_t found_ = 0;
};

}  // namespace

std::optional<std::vector<NearEdges>> find_near_edges(const Surface& surface,
                                                      const std::optional<std::uint32_t>& element,
                                                      std::size_t limit) {
  std::vector<NearEdges> near;
  const auto keep = [&](HalfEdge a, HalfEdge b) {
    near.emplace_back(a, b);
    return true;
  };
  if (!for_near_edges(surface, element, limit, keep)) return std::nullopt;
  return near;
}

void check_boundary(const Surface& surface, const std::optional<std::vector<NearEdges>>& near,
                    const ContactBudget& budget, ObstacleList& obstacles) {
  BoundaryCheck(surface, budget, obstacles).run(near);
}

}  // namespace bezcert
