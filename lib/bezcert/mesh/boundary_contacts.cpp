#include "bezcert/mesh/boundary_contacts.hpp"

#include "bezcert/curve/same_curve.hpp"
#include "bezcert/mesh/box_sweep.hpp"
#include "bezcert/mesh/curve_parameters.hpp"
#include "bezcert/mesh/edge_distance.hpp"
#include "bezcert/mesh/one_way.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace bezcert {
namespace {

// Whether a piece of b, between end points of the two, runs along a.
bool run_together(const CurveNet<Integer>& a, const CurveNet<Integer>& b) {
  const auto is_on = [](const CurveNet<Integer>& curve, const Point& point) {
    return point == point_at(curve, 0) || point == point_at(curve, 1) || passes_inside(curve, point);
  };
  std::vector<Rational> on_b;
  if (is_on(a, point_at(b, 0))) on_b.push_back(0);
  if (is_on(a, point_at(b, 1))) on_b.push_back(1);
  for (const int end : {0, 1}) {
    for (const Rational& t : rational_parameters(b, point_at(a, end), 0)) on_b.push_back(t);
  }
  std::sort(on_b.begin(), on_b.end());
  if (on_b.empty() || on_b.front() == on_b.back()) return false;
  // More common points than the product of the degrees: by Bezout one irreducible curve holds both.
  const auto samples = static_cast<long>((a.size() - 1) * (b.size() - 1) + 1);
  for (long k = 1; k <= samples; ++k) {
    const Rational t = on_b.front() + (on_b.back() - on_b.front()) * Rational(k, samples + 1);
    if (!passes_inside(a, point_at(b, t))) return false;
  }
  return true;
}

Joints joints_of(const MeshEdges& edges, const Gluing& gluing, EdgeUse a, EdgeUse b) {
  return {gluing.end(edges, a) == gluing.begin[b], gluing.begin[a] == gluing.end(edges, b)};
}

// Whether two boundary edges whose boxes overlap have to be compared.
bool may_meet(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
              const std::optional<std::uint32_t>& element, EdgeUse a, EdgeUse b) {
  if (edges.element(a) == edges.element(b)) return false;  // it is injective
  if (element && edges.element(a) != *element && edges.element(b) != *element) return false;
  // Edges that begin (or end) at one vertex are parts of different fans or of a gluing obstacle: already
  // reported.
  if (gluing.begin[a] == gluing.begin[b] || gluing.end(edges, a) == gluing.end(edges, b)) return false;
  const Joints joints = joints_of(edges, gluing, a, b);
  // Of the many edges at a vertex where parts touch only those of one part are compared: it is an obstacle
  // already.
  if (joints.end_to_begin && fans.bad[gluing.begin[b]] && fans.next_boundary[a] != b) return false;
  if (joints.begin_to_end && fans.bad[gluing.begin[a]] && fans.next_boundary[b] != a) return false;
  if (joints.end_to_begin == joints.begin_to_end) return true;
  return joints.end_to_begin ? !run_one_way(edges, a, b) : !run_one_way(edges, b, a);
}

// Calls visit(a, b) for near edges until it returns false. Returns false if more than `limit` boxes overlap.
bool for_near_edges(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
                    const std::optional<std::uint32_t>& element, std::size_t limit,
                    const std::function<bool(EdgeUse, EdgeUse)>& visit) {
  std::vector<EdgeUse> uses;
  std::vector<Box> boxes;
  {
    const RoundingScope scope;
    for (EdgeUse use = 0; use < edges.count(); ++use) {
      if (!gluing.is_boundary(use) || gluing.faulty[use]) continue;
      uses.push_back(use);
      boxes.push_back(edges.box(use));
    }
  }
  std::size_t overlaps = 0;
  for_overlapping_boxes(boxes, [&](std::size_t i, std::size_t j) {
    if (++overlaps > limit) return false;
    return !may_meet(edges, gluing, fans, element, uses[i], uses[j]) || visit(uses[i], uses[j]);
  });
  return overlaps <= limit;
}

class BoundaryCheck {
 public:
  BoundaryCheck(const MeshEdges& edges, const Gluing& gluing, const Fans& fans, const ContactBudget& budget,
                ObstacleList& obstacles)
      : edges_(edges), gluing_(gluing), fans_(fans), budget_(budget), obstacles_(obstacles) {}

  void run(const std::optional<std::vector<NearEdges>>& near) {
    const auto look = [&](EdgeUse a, EdgeUse b) {
      look_at(a, b);
      return found_ < ObstacleList::kept;
    };
    if (!near) {
      constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
      for_near_edges(edges_, gluing_, fans_, obstacles_.element(), all, look);
      return;
    }
    for (const auto& [a, b] : *near) {
      if (!look(a, b)) return;
    }
  }

 private:
  std::uint32_t begin(EdgeUse use) const { return gluing_.begin[use]; }
  std::uint32_t end(EdgeUse use) const { return gluing_.end(edges_, use); }

  void look_at(EdgeUse a, EdgeUse b) {
    const ContactResult result = find_contact(curve(a), curve(b), joints_of(edges_, gluing_, a, b), budget_);
    if (result.status == ContactStatus::none) return;
    if (result.status == ContactStatus::open) return open(a, b, *result.exceeded);
    const CurveNet<Integer> net_a = edges_.exact(a), net_b = edges_.exact(b);
    if (same_curve(net_a, reversed(net_b))) return coincide(a, b);
    Contact contact = *result.contact;
    contact.along_a_piece = contact.along_a_piece || run_together(net_a, net_b);
    if (contact.along_a_piece && (hanging(a, net_a, b) || hanging(b, net_b, a))) return;
    if (nearly_hanging(a, b)) return;
    if (two_nodes(a, b, contact)) return;
    meet(a, b, contact, net_a);
  }

  // Curves of the edges compared lately, so that a neighbour's subdivision is not done again.
  DyadicCurve& curve(EdgeUse use) {
    constexpr std::size_t kept = 4096;
    if (curves_.size() >= kept && !curves_.contains(use)) {
      // Both curves of a pair must live: one is fetched right after the other.
      for (auto it = curves_.begin(); it != curves_.end();)
        it = it->first == last_ ? std::next(it) : curves_.erase(it);
    }
    last_ = use;
    const RoundingScope scope;
    return curves_.try_emplace(use, edges_.curve(use)).first->second;
  }

  std::string edge_text(EdgeUse use) const {
    return "edge " + std::to_string(edges_.edge(use)) + " of element " +
           std::to_string(edges_.element_number(use)) + " (from " + node_text(edges_, begin(use)) + " to " +
           node_text(edges_, end(use)) + ")";
  }

  MeshObstacle obstacle(MeshVerdict kind, EdgeUse a, EdgeUse b) const {
    MeshObstacle result;
    result.kind = kind;
    result.elements = {edges_.element(a), edges_.element(b)};
    name_edge(edges_, a, result);
    name_edge(edges_, b, result);
    return result;
  }

  void add(MeshObstacle obstacle) {
    ++found_;
    obstacles_.add(std::move(obstacle));
  }

  void open(EdgeUse a, EdgeUse b, const ExceededBits& exceeded) {
    MeshObstacle result = obstacle(MeshVerdict::undecided, a, b);
    name_nodes(edges_, {begin(a), end(a), begin(b), end(b)}, result);
    result.message = "whether " + edge_text(a) + " meets " + edge_text(b) + " is open: algebra bits " +
                     std::to_string(exceeded.allowed) + " (the contact of two edges needs " +
                     std::to_string(exceeded.needed) + ")";
    add(std::move(result));
  }

  void coincide(EdgeUse a, EdgeUse b) {
    MeshObstacle result = obstacle(MeshVerdict::overlapping_boundary, a, b);
    name_nodes(edges_, {begin(a), end(a), begin(b), end(b)}, result);
    result.message = edge_text(a) + " and " + edge_text(b) + " are one curve, but not one edge";
    result.hint = "their nodes are not merged, or this is a crack (slit) of width 0";
    add(std::move(result));
  }

  // An end of `other` inside edge `use`, along which run it and all boundary edges between it and an end of
  // `use`.
  bool hanging(EdgeUse use, const CurveNet<Integer>& net, EdgeUse other) {
    const std::vector<EdgeUse> chain = chain_along(use, net);
    if (std::find(chain.begin(), chain.end(), other) == chain.end()) return false;
    for (const std::uint32_t node : {begin(other), end(other)}) {
      if (node == begin(use) || node == end(use) || !passes_inside(net, edges_.point(node))) continue;
      if (!hanging_.insert({node, use}).second) return true;
      MeshObstacle result;
      result.kind = MeshVerdict::non_conforming;
      for (const EdgeUse one : chain) {
        if (begin(one) != node && end(one) != node) continue;
        result.elements.push_back(edges_.element(one));
        name_edge(edges_, one, result);
      }
      std::sort(result.elements.begin(), result.elements.end());
      result.elements.erase(std::unique(result.elements.begin(), result.elements.end()),
                            result.elements.end());
      result.message = node_text(edges_, node) + ", a corner of " +
                       elements_text(edges_.mesh(), result.elements) + ", lies inside " + edge_text(use);
      result.hint = "a hanging node: split that element there, or remove the node";
      name_edge(edges_, use, result);
      result.elements.insert(
          std::lower_bound(result.elements.begin(), result.elements.end(), edges_.element(use)),
          edges_.element(use));
      name_nodes(edges_, {node}, result);
      result.distance = DistanceBounds{};
      add(std::move(result));
      return true;
    }
    return false;
  }

  // The boundary edges before and after `use` that run along it, as far as they do.
  std::vector<EdgeUse> chain_along(EdgeUse use, const CurveNet<Integer>& net) {
    constexpr std::size_t longest = 256;
    std::vector<EdgeUse> chain;
    const auto walk = [&](const std::vector<EdgeUse>& step) {
      for (EdgeUse one = step[use]; one != no_edge && one != use && chain.size() < longest; one = step[one]) {
        if (!run_together(net, edges_.exact(one))) break;
        if (std::find(chain.begin(), chain.end(), one) != chain.end()) break;
        chain.push_back(one);
      }
    };
    walk(fans_.next_boundary);
    walk(previous_boundary());
    return chain;
  }

  const std::vector<EdgeUse>& previous_boundary() {
    if (previous_.empty()) {
      previous_.assign(edges_.count(), no_edge);
      for (EdgeUse use = 0; use < edges_.count(); ++use) {
        if (fans_.next_boundary[use] != no_edge) previous_[fans_.next_boundary[use]] = use;
      }
    }
    return previous_;
  }

  // The two belong to a hole of three edges that is not open: an edge and two edges between its ends.
  bool nearly_hanging(EdgeUse a, EdgeUse b) {
    std::array<EdgeUse, 3> loop = {a, fans_.next_boundary[a], no_edge};
    if (loop[1] == no_edge) return false;
    loop[2] = fans_.next_boundary[loop[1]];
    if (loop[2] == no_edge || fans_.next_boundary[loop[2]] != a || (b != loop[1] && b != loop[2]))
      return false;
    const auto length = [&](EdgeUse use) {
      const Point p = edges_.point(begin(use)), q = edges_.point(end(use));
      return Rational((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
    };
    const auto longest = std::max_element(loop.begin(), loop.end(),
                                          [&](EdgeUse p, EdgeUse q) { return length(p) < length(q); });
    std::rotate(loop.begin(), longest, loop.end());
    const std::uint32_t node = end(loop[1]);
    if (!hanging_.insert({node, loop[0]}).second) return true;
    MeshObstacle result;
    result.kind = MeshVerdict::non_conforming;
    for (const EdgeUse use : loop) {
      result.elements.push_back(edges_.element(use));
      name_edge(edges_, use, result);
    }
    std::sort(result.elements.begin(), result.elements.end());
    result.elements.erase(std::unique(result.elements.begin(), result.elements.end()), result.elements.end());
    name_nodes(edges_, {node}, result);
    result.distance = distance_bounds(edges_.exact(loop[0]), edges_.point(node));
    result.message = node_text(edges_, node) + " lies between the ends of " + edge_text(loop[0]) +
                     ", at most " + to_decimal(to_rational(result.distance->upper)) +
                     " from it, and the edges on both sides meet";
    result.hint = "a hanging node: split that element there, or remove the node";
    add(std::move(result));
    return true;
  }

  // They meet in a point that is a node of both, by two numbers.
  bool two_nodes(EdgeUse a, EdgeUse b, const Contact& contact) {
    const auto node_at = [&](EdgeUse use, const ParameterRange& range) -> std::optional<std::uint32_t> {
      if (range.lower != range.upper) return std::nullopt;
      if (range.lower.sign() == 0) return begin(use);
      if (range.lower == 1) return end(use);
      return std::nullopt;
    };
    const auto node_a = node_at(a, contact.first), node_b = node_at(b, contact.second);
    if (!node_a || !node_b || contact.along_a_piece) return false;
    if (!touching_.insert(std::minmax(*node_a, *node_b)).second) return true;
    MeshObstacle result = obstacle(MeshVerdict::overlapping_boundary, a, b);
    name_nodes(edges_, {*node_a, *node_b}, result);
    result.message = elements_text(edges_.mesh(), result.elements) + " touch: " + node_text(edges_, *node_a) +
                     " and " + node_text(edges_, *node_b) + " are one point";
    result.hint = "nodes are not merged, or the parts touch in one point";
    add(std::move(result));
    return true;
  }

  void meet(EdgeUse a, EdgeUse b, const Contact& contact, const CurveNet<Integer>& net_a) {
    MeshObstacle result = obstacle(MeshVerdict::overlapping_boundary, a, b);
    for (const EdgeUse use : {a, b}) {
      if (!edges_.mesh().glued_by_nodes()) break;
      result.nodes.push_back(begin(use));
      result.nodes.push_back(end(use));
    }
    const Point where = point_at(net_a, Rational((contact.first.lower + contact.first.upper) / 2));
    result.points.push_back(where);
    const auto range = [](const ParameterRange& r) {
      if (r.lower == r.upper) return "t = " + to_decimal(r.lower);
      return "t from " + to_decimal(r.lower) + " to " + to_decimal(r.upper);
    };
    result.message = edge_text(a) + " meets " + edge_text(b) +
                     (contact.along_a_piece ? " along a piece near " : " near ") + text_of(where) + " (" +
                     range(contact.first) + " and " + range(contact.second) + ")";
    result.hint =
        contact.along_a_piece
            ? "sides of a crack or of parts that do not match: corners of one side lie inside edges of the "
              "other (hanging nodes), or the parts overlap"
            : "boundary edges cross or touch: parts of the mesh overlap there, or a gap is closed";
    add(std::move(result));
  }

  const MeshEdges& edges_;
  const Gluing& gluing_;
  const Fans& fans_;
  const ContactBudget& budget_;
  ObstacleList& obstacles_;
  std::vector<EdgeUse> previous_;  // the inverse of next_boundary, once it is needed
  std::map<EdgeUse, DyadicCurve> curves_;
  EdgeUse last_ = no_edge;
  // Already reported: (node, edge), and two nodes.
  std::set<std::pair<std::uint32_t, EdgeUse>> hanging_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> touching_;
  std::size_t found_ = 0;
};

}  // namespace

std::optional<std::vector<NearEdges>> find_near_edges(const MeshEdges& edges, const Gluing& gluing,
                                                      const Fans& fans,
                                                      const std::optional<std::uint32_t>& element,
                                                      std::size_t limit) {
  std::vector<NearEdges> near;
  const auto keep = [&](EdgeUse a, EdgeUse b) {
    near.emplace_back(a, b);
    return true;
  };
  if (!for_near_edges(edges, gluing, fans, element, limit, keep)) return std::nullopt;
  return near;
}

void check_boundary(const MeshEdges& edges, const Gluing& gluing, const Fans& fans,
                    const std::optional<std::vector<NearEdges>>& near, const ContactBudget& budget,
                    ObstacleList& obstacles) {
  BoundaryCheck(edges, gluing, fans, budget, obstacles).run(near);
}

}  // namespace bezcert
