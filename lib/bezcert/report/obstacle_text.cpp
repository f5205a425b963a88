#include "bezcert/report/obstacle_text.hpp"

#include "bezcert/report/decision_text.hpp"

namespace bezcert {
namespace {

std::string place_text(const Point& point) { return "the point " + text_of(point); }

// "node 7 at (0.5, 0.25)", or "the point (0.5, 0.25)" in a mesh that is glued by points.
std::string node_text(const Mesh& mesh, std::uint32_t node) {
  const Point point{mesh.coordinates(0)[node], mesh.coordinates(1)[node]};
  if (!mesh.glued_by_nodes()) return place_text(point);
  return "node " + std::to_string(mesh.origin().node_number(node)) + " at " + text_of(point);
}

std::string node_text(const Mesh& mesh, const MeshObstacle& obstacle, std::size_t i = 0) {
  return obstacle.nodes.empty() ? place_text(obstacle.points[i]) : node_text(mesh, obstacle.nodes[i]);
}

std::string element_text(const Mesh& mesh, std::uint32_t element) {
  return "element " + std::to_string(mesh.origin().number(element));
}

// "element 12", "elements 12 and 40", "elements 12, 40 and 41".
std::string elements_text(const Mesh& mesh, const std::vector<std::uint32_t>& elements) {
  constexpr std::size_t listed = 8;
  std::string text = elements.size() == 1 ? "element " : "elements ";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i == listed) return text + " and " + std::to_string(elements.size() - listed) + " more";
    if (i > 0) text += i + 1 == elements.size() ? " and " : ", ";
    text += std::to_string(mesh.origin().number(elements[i]));
  }
  return text;
}

// The node where an edge begins, or ends.
std::uint32_t end_node(const Mesh& mesh, const ElementEdge& edge, End end) {
  const MeshElement& element = mesh.elements()[edge.element];
  const std::vector<std::size_t> along = edge_positions(element.shape, edge.edge);
  return mesh.connectivity()[element.first_node + (end == End::begin ? along.front() : along.back())];
}

std::string edge_text(const Mesh& mesh, const ElementEdge& edge) {
  return "edge " + std::to_string(edge.edge) + " of " + element_text(mesh, edge.element);
}

std::string edge_with_ends(const Mesh& mesh, const ElementEdge& edge) {
  return edge_text(mesh, edge) + " (from " + node_text(mesh, end_node(mesh, edge, End::begin)) + " to " +
         node_text(mesh, end_node(mesh, edge, End::end)) + ")";
}

// "0.01 to 0.011".
std::string text_of(const DistanceBounds& distance) {
  const std::string lower = to_decimal(to_rational(distance.lower));
  const std::string upper = to_decimal(to_rational(distance.upper));
  return lower == upper ? lower : lower + " to " + upper;
}

std::string at_most(const DistanceBounds& distance) { return to_decimal(to_rational(distance.upper)); }

std::string text_of(const ParameterRange& range) {
  if (range.lower == range.upper) return "t = " + to_decimal(range.lower);
  return "t from " + to_decimal(range.lower) + " to " + to_decimal(range.upper);
}

std::string component_text(const MeshObstacle& obstacle, std::size_t i) {
  return "component " + std::to_string(obstacle.components[i] + 1);
}

std::string states_text(const Mesh& mesh, const MeshObstacle& obstacle, const std::string& what) {
  std::string text = elements_text(mesh, obstacle.elements);
  if (obstacle.count > obstacle.elements.size()) {
    text += " and others, " + std::to_string(obstacle.count) + " in all,";
  }
  return text + (obstacle.count == 1 ? " is " : " are ") + what;
}

// The elements of an edge, what they do, and the edge by its ends.
std::string common_edge_text(const Mesh& mesh, const MeshObstacle& obstacle, const std::string& what) {
  std::string text = elements_text(mesh, obstacle.elements);
  if (obstacle.count > obstacle.edges.size()) text += " (" + std::to_string(obstacle.count) + " in all)";
  return text + what + "the edge from " + node_text(mesh, obstacle, 0) + " to " +
         node_text(mesh, obstacle, 1);
}

std::string crack_text(const Mesh& mesh, const MeshObstacle& obstacle) {
  return common_edge_text(mesh, obstacle, " have different curves on ") + ", " + text_of(*obstacle.distance) +
         " apart at most at equal parameters";
}

// A node and the elements of the short edges that end there.
std::string hanging_text(const Mesh& mesh, const MeshObstacle& obstacle, std::size_t long_edge) {
  std::vector<std::uint32_t> neighbours;
  for (std::size_t i = 0; i < obstacle.edges.size(); ++i) {
    if (i != long_edge) neighbours.push_back(obstacle.edges[i].element);
  }
  sort_unique(neighbours);
  return node_text(mesh, obstacle) + ", a corner of " + elements_text(mesh, neighbours);
}

std::string around_text(const Mesh& mesh, const MeshObstacle& obstacle, const std::string& what) {
  return elements_text(mesh, obstacle.elements) + what + node_text(mesh, obstacle);
}

std::string meet_text(const Mesh& mesh, const MeshObstacle& obstacle, const std::string& where) {
  return edge_with_ends(mesh, obstacle.edges[0]) + " meets " + edge_with_ends(mesh, obstacle.edges[1]) +
         where + text_of(obstacle.points[0]) + " (" + text_of(obstacle.at[0]) + " and " +
         text_of(obstacle.at[1]) + ")";
}

}  // namespace

std::string text_of(const Point& point) {
  return "(" + to_decimal(point.x) + ", " + to_decimal(point.y) + ")";
}

std::string message(const Mesh& mesh, const MeshObstacle& obstacle) {
  const auto edge = [&](std::size_t i) { return edge_with_ends(mesh, obstacle.edges[i]); };
  const auto component = [&](std::size_t i) { return component_text(obstacle, i); };
  const std::size_t last = obstacle.edges.size() - 1;
  switch (obstacle.cause) {
    case Cause::not_injective: return states_text(mesh, obstacle, "not injective");
    case Cause::not_decided: return states_text(mesh, obstacle, "not decided");
    case Cause::too_many_elements:
      return common_edge_text(mesh, obstacle, " share ") + ": an edge has two elements at most";
    case Cause::one_side:
      return common_edge_text(mesh, obstacle, " share ") + " and both lie on the same side of it";
    case Cause::pinched_vertex:
      return around_text(mesh, obstacle,
                         " belong to " + std::to_string(obstacle.count) + " parts that touch only in ") +
             ": a pinched vertex";
    case Cause::crack:
    case Cause::crack_in_one_shape: return crack_text(mesh, obstacle);
    case Cause::hanging_inside:
      return hanging_text(mesh, obstacle, 0) + ", lies inside " + edge_text(mesh, obstacle.edges[0]);
    case Cause::hanging_beside:
      return hanging_text(mesh, obstacle, 0) + ", lies beside " + edge_text(mesh, obstacle.edges[0]) +
             ", at most " + at_most(*obstacle.distance) + " from it";
    case Cause::hanging_on_border: return hanging_text(mesh, obstacle, last) + ", lies inside " + edge(last);
    case Cause::hanging_in_gap:
      return node_text(mesh, obstacle) + " lies between the ends of " + edge(0) + ", at most " +
             at_most(*obstacle.distance) + " from it, and the edges on both sides meet";
    case Cause::more_than_one_turn:
      return around_text(mesh, obstacle, " make more than one full turn around the boundary vertex ");
    case Cause::sliver_covered_twice:
      return around_text(mesh, obstacle,
                         " make one full turn and cover a sliver twice at the boundary vertex ");
    case Cause::several_turns:
      return around_text(mesh, obstacle, " wind " + std::to_string(obstacle.count) + " times around ");
    case Cause::unmerged_edges: return edge(0) + " and " + edge(1) + " are one curve, but not one edge";
    case Cause::unmerged_nodes:
      return around_text(mesh, obstacle, " touch: ") + " and " + node_text(mesh, obstacle, 1) +
             " are one point";
    case Cause::edges_meet: return meet_text(mesh, obstacle, " near ");
    case Cause::edges_overlap: return meet_text(mesh, obstacle, " along a piece near ");
    case Cause::nested:
      return component(0) + " (with " + element_text(mesh, obstacle.elements[0]) + ", " +
             node_text(mesh, obstacle) + ") lies inside " + component(1) + " (with " +
             element_text(mesh, obstacle.elements[1]) + ")";
    case Cause::contact_open:
      return "whether " + edge(0) + " meets " + edge(1) + " is open: " +
             text_of({ExhaustedBudget::Limit::contact_bits, obstacle.exceeded->allowed,
                      obstacle.exceeded->needed, 0, 0});
    case Cause::nesting_open:
      return "whether " + component(0) + " lies in " + component(1) + " is open: winding depth";
  }
  return "";
}

std::string hint(const MeshObstacle& obstacle) {
  switch (obstacle.cause) {
    case Cause::too_many_elements:
      return "an element is there twice, or sheets of elements meet as they do in a surface in space";
    case Cause::one_side:
      return "one of them is turned over (a Moebius-like gluing), or an element is there twice";
    case Cause::pinched_vertex:
      return "parts that touch in one point; give each part a node of its own and move them apart, or join "
             "them by an edge";
    case Cause::crack: return "inner nodes (control points, weights) of the edge differ";
    case Cause::crack_in_one_shape:
      return "they have one shape, but run through it differently: inner nodes (or weights) are placed "
             "differently along the edge";
    case Cause::hanging_inside:
    case Cause::hanging_beside:
    case Cause::hanging_on_border:
    case Cause::hanging_in_gap: return "a hanging node: split that element there, or remove the node";
    case Cause::more_than_one_turn:
    case Cause::sliver_covered_twice:
    case Cause::several_turns:
      return "the elements are fine one by one, but lie on each other around that node";
    case Cause::unmerged_edges: return "their nodes are not merged, or this is a crack (slit) of width 0";
    case Cause::unmerged_nodes: return "nodes are not merged, or the parts touch in one point";
    case Cause::edges_meet:
      return "boundary edges cross or touch: parts of the mesh overlap there, or a gap is closed";
    case Cause::edges_overlap:
      return "sides of a crack or of parts that do not match: corners of one side lie inside edges of the "
             "other (hanging nodes), or the parts overlap";
    case Cause::nested: return "two parts of the mesh cover the same region";
    case Cause::not_injective:
    case Cause::not_decided:
    case Cause::contact_open:
    case Cause::nesting_open: break;
  }
  return "";
}

std::string message(const Mesh& mesh, const DomainFailure& failure) {
  if (failure.cause == DomainCause::no_corner) return "no element has a corner there";
  const std::string from =
      failure.nodes.empty() ? place_text(failure.point) : node_text(mesh, failure.nodes.front());
  if (failure.cause == DomainCause::no_edge) {
    return "no edge from " + from + " leads to another point of the curve";
  }
  const std::uint32_t to = end_node(mesh, failure.edge, failure.forward ? End::end : End::begin);
  const std::string edge = "the edge from " + from + " to " + node_text(mesh, to) + " of " +
                           element_text(mesh, failure.edge.element);
  switch (failure.cause) {
    case DomainCause::other_way:
      return edge + " ends on the curve, but is not that part of it: " + text_of(*failure.distance) +
             " apart at most at equal parameters";
    case DomainCause::ends_inside_edge:
      return "the curve ends at " + text_of(failure.end) + ", inside " + edge + ": there is no node";
    default:
      return edge + " ends on the curve, but at an irrational parameter: it runs through it differently";
  }
}

}  // namespace bezcert
