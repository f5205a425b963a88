#include "bezcert/mesh/mesh_builder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bezcert {
namespace {

// Nodes, and edges of elements, are numbered with 32 bits; the largest number means none.
constexpr std::size_t too_many = std::numeric_limits<std::uint32_t>::max();

bool is_finite(double number) { return std::isfinite(number); }
bool is_finite(const Rational&) { return true; }

std::string text(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return to_decimal(Rational(number));
}
std::string text(const Rational& number) { return to_decimal(number); }

[[noreturn]] void fail_node(std::size_t node, const std::string& problem) {
  throw MeshError("node " + std::to_string(node) + ": " + problem);
}

[[noreturn]] void fail_coordinate(std::size_t node, std::size_t k, double number) {
  fail_node(node, "coordinate " + std::to_string(k) + " is " + text(number) + ", expected a finite number");
}

std::size_t edge_count(Shape shape) { return shape.domain == Domain::triangle ? 3 : 4; }

std::string shape_text(Shape shape) {
  if (shape.domain == Domain::triangle) return "triangle of degree " + std::to_string(shape.degree(0));
  return "quadrilateral of degrees " + std::to_string(shape.degree(0)) + " and " +
         std::to_string(shape.degree(1));
}

void check_shape(std::size_t element, Shape shape, Basis basis) {
  if (shape.domain != Domain::square && shape.domain != Domain::triangle) {
    throw MeshError(element, "its domain is none of an element, expected a triangle or a square");
  }
  for (int f = 0; f < shape.factor_count(); ++f) {
    const int degree = shape.degree(f);
    if (degree >= 1 && degree <= max_degree) continue;
    throw MeshError(
        element, "its degree is " + std::to_string(degree) + ", expected 1 to " + std::to_string(max_degree));
  }
  if (basis != Basis::bernstein && basis != Basis::lagrange) {
    throw MeshError(element, "its basis is not known, expected bernstein or lagrange");
  }
}

}  // namespace

template <class Number>
std::uint32_t MeshBuilder::add_point(std::span<const Number> point, const std::optional<Number>& weight) {
  const std::size_t node = node_count();
  if (point.size() != mesh_.coordinates_.size()) {
    fail_node(node, std::to_string(point.size()) + " coordinates, expected " +
                        std::to_string(mesh_.coordinates_.size()));
  }
  for (std::size_t k = 0; k < point.size(); ++k) {
    if constexpr (std::is_same_v<Number, double>) {
      if (!is_finite(point[k])) fail_coordinate(node, k, point[k]);
    }
  }
  if (weight && !(is_finite(*weight) && *weight > 0)) {
    fail_node(node, "its weight is " + text(*weight) + ", expected a positive finite number");
  }
  if (node + 1 >= too_many) fail_node(node, "expected fewer than 2^32 - 1 nodes");
  for (std::size_t k = 0; k < point.size(); ++k) mesh_.coordinates_[k].push_back(point[k]);
  if (weight) {
    if (mesh_.weights_.empty()) mesh_.weights_ = ExactVector(std::vector<double>(node, 1.0));
    mesh_.weights_.push_back(*weight);
  } else if (!mesh_.weights_.empty()) {
    mesh_.weights_.push_back(1.0);
  }
  return static_cast<std::uint32_t>(node);
}

std::uint32_t MeshBuilder::add_node(std::initializer_list<double> point, std::optional<double> weight) {
  return add_point<double>(point, weight);
}

std::uint32_t MeshBuilder::add_node(std::initializer_list<Rational> point,
                                    const std::optional<Rational>& weight) {
  return add_point<Rational>(point, weight);
}

// coordinate(i, k): the k-th coordinate of the i-th node.
template <class Coordinate>
std::uint32_t MeshBuilder::add_points(std::size_t count, std::span<const double> weights,
                                      Coordinate coordinate) {
  if (!weights.empty() && weights.size() != count) {
    throw MeshError(std::to_string(weights.size()) + " weights for " + std::to_string(count) +
                    " nodes, expected one a node, or none");
  }
  const std::size_t first = node_count();
  if (first == 0) reserve_nodes(count);
  std::vector<double> point(mesh_.coordinates_.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < point.size(); ++k) point[k] = coordinate(i, k);
    add_point<double>(point, weights.empty() ? std::nullopt : std::optional(weights[i]));
  }
  return static_cast<std::uint32_t>(first);
}

std::uint32_t MeshBuilder::add_nodes_interleaved(std::span<const double> points,
                                                 std::span<const double> weights) {
  const std::size_t dimension = mesh_.coordinates_.size();
  if (points.size() % dimension != 0) {
    throw MeshError(std::to_string(points.size()) + " coordinates of nodes in turn, expected a multiple of " +
                    std::to_string(dimension));
  }
  return add_points(points.size() / dimension, weights,
                    [&](std::size_t i, std::size_t k) { return points[i * dimension + k]; });
}

std::uint32_t MeshBuilder::add_nodes_separate(std::initializer_list<std::span<const double>> coordinates,
                                              std::span<const double> weights) {
  if (coordinates.size() != mesh_.coordinates_.size()) {
    throw MeshError(std::to_string(coordinates.size()) + " arrays of coordinates, expected " +
                    std::to_string(mesh_.coordinates_.size()));
  }
  const std::span<const double>* const arrays = coordinates.begin();
  for (std::size_t k = 1; k < coordinates.size(); ++k) {
    if (arrays[k].size() == arrays[0].size()) continue;
    throw MeshError("array " + std::to_string(k) + " of coordinates has " + std::to_string(arrays[k].size()) +
                    " numbers, expected " + std::to_string(arrays[0].size()) + " as in the first");
  }
  return add_points(arrays[0].size(), weights, [&](std::size_t i, std::size_t k) { return arrays[k][i]; });
}

std::size_t MeshBuilder::add_element(Shape shape, Basis basis, std::initializer_list<std::int64_t> nodes) {
  check_shape(mesh_.elements_.size(), shape, basis);
  if (nodes.size() != coefficient_count(shape)) {
    throw MeshError(mesh_.elements_.size(), std::to_string(nodes.size()) + " nodes, expected " +
                                                std::to_string(coefficient_count(shape)) + " of a " +
                                                shape_text(shape));
  }
  return add_elements(shape, basis, nodes);
}

std::size_t MeshBuilder::count_elements(Shape shape, Basis basis, std::size_t nodes) const {
  check_shape(mesh_.elements_.size(), shape, basis);
  const std::size_t each = coefficient_count(shape);
  if (nodes % each != 0) {
    throw MeshError(mesh_.elements_.size() + nodes / each,
                    std::to_string(nodes % each) + " nodes are left, expected " + std::to_string(each) +
                        " of a " + shape_text(shape));
  }
  return nodes / each;
}

void MeshBuilder::fail_index(std::size_t element, std::size_t place, const std::string& index,
                             const std::string& expected) {
  throw MeshError(element, "its node " + std::to_string(place) + " is " + index + ", expected " + expected);
}

void MeshBuilder::reserve_nodes(std::size_t more) {
  for (ExactVector& numbers : mesh_.coordinates_) numbers.reserve(numbers.size() + more);
}

void MeshBuilder::reserve_elements(std::size_t more, std::size_t nodes_of_each) {
  const auto reserve = [](auto& list, std::size_t count) {
    const std::size_t needed = list.size() + count;
    if (needed > list.capacity()) list.reserve(std::max(needed, list.capacity() * 2));
  };
  reserve(mesh_.elements_, more);
  reserve(mesh_.connectivity_, more * nodes_of_each);
}

std::optional<std::array<std::span<double>, 2>> MeshBuilder::append_nodes(std::size_t count) {
  const std::size_t before = node_count();
  if (count >= too_many - before) fail_node(before + count, "expected fewer than 2^32 - 1 nodes");
  if (!mesh_.coordinates_[0].binary64() || !mesh_.coordinates_[1].binary64()) return std::nullopt;
  if (!mesh_.weights_.empty()) {
    for (std::size_t i = 0; i < count; ++i) mesh_.weights_.push_back(1.0);
  }
  return std::array{mesh_.coordinates_[0].append_zeros(count), mesh_.coordinates_[1].append_zeros(count)};
}

std::span<std::uint32_t> MeshBuilder::append_elements(Shape shape, Basis basis, std::size_t count) {
  check_shape(mesh_.elements_.size(), shape, basis);
  if (count > (too_many - 1 - edges_) / edge_count(shape)) {
    throw MeshError(mesh_.elements_.size() + count, "expected fewer than 2^32 - 1 edges of elements");
  }
  const std::size_t first_node = mesh_.connectivity_.size(), each = coefficient_count(shape);
  mesh_.connectivity_.resize(first_node + count * each);
  for (std::size_t i = 0; i < count; ++i) mesh_.elements_.push_back({shape, basis, first_node + i * each});
  edges_ += count * edge_count(shape);
  in_basis_[static_cast<std::size_t>(basis)] += count;
  return std::span(mesh_.connectivity_).subspan(first_node);
}

void MeshBuilder::drop_nodes(std::size_t count) {
  if (count > node_count()) throw MeshError("fewer nodes than are to be dropped");
  for (ExactVector& numbers : mesh_.coordinates_) numbers.remove_last(count);
  if (!mesh_.weights_.empty()) mesh_.weights_.remove_last(count);
}

void MeshBuilder::drop_elements(std::size_t count) {
  if (count > mesh_.elements_.size()) throw MeshError("fewer elements than are to be dropped");
  for (; count > 0; --count) {
    const MeshElement& last = mesh_.elements_.back();
    edges_ -= edge_count(last.shape);
    --in_basis_[static_cast<std::size_t>(last.basis)];
    mesh_.connectivity_.resize(last.first_node);
    mesh_.elements_.pop_back();
  }
}

// Lists that do not fit each other are what is left where memory ran out while something was added.
void MeshBuilder::check_sizes() const {
  std::size_t nodes = 0;
  bool fit = mesh_.weights_.empty() || mesh_.weights_.size() == node_count();
  for (const ExactVector& coordinates : mesh_.coordinates_) fit = fit && coordinates.size() == node_count();
  for (const MeshElement& element : mesh_.elements_) {
    fit = fit && element.first_node == nodes;
    nodes += coefficient_count(element.shape);
  }
  if (!fit || nodes != mesh_.connectivity_.size()) {
    throw MeshError("nodes and elements are incomplete: memory ran out while they were added");
  }
}

void MeshBuilder::check_coordinates() const {
  for (std::size_t k = 0; k < mesh_.coordinates_.size(); ++k) {
    const std::span<const double> numbers = mesh_.coordinates_[k].doubles();
    bool finite = true;
    for (const double number : numbers) {
      constexpr std::uint64_t exponent = std::uint64_t{0x7FF} << 52;  // infinite or no number, if all are set
      finite &= (std::bit_cast<std::uint64_t>(number) & exponent) != exponent;
    }
    for (std::size_t i = 0; i < numbers.size() && !finite; ++i) {
      if (!is_finite(numbers[i])) fail_coordinate(i, k, numbers[i]);
    }
  }
}

void MeshBuilder::check_connectivity() const {
  const std::size_t nodes = node_count();
  std::uint32_t largest = 0;
  for (const std::uint32_t node : mesh_.connectivity_) largest = std::max(largest, node);
  if (largest < nodes) return;
  for (std::size_t i = 0; i < mesh_.elements_.size(); ++i) {
    for (std::size_t k = 0; k < coefficient_count(mesh_.elements_[i].shape); ++k) {
      const std::uint32_t node = mesh_.connectivity_[mesh_.elements_[i].first_node + k];
      if (node < nodes) continue;
      fail_index(i, k, std::to_string(node),
                 "an index below " + std::to_string(nodes) + ", the number of nodes");
    }
  }
}

void MeshBuilder::check_origin() const {
  const auto check = [](std::size_t size, std::size_t count, const char* what) {
    if (size == 0 || size == count) return;
    throw MeshError("the origin has " + std::to_string(size) + " " + what + ", expected " +
                    std::to_string(count) + " or none");
  };
  check(mesh_.origin_.element_tags.size(), mesh_.elements_.size(), "numbers of elements");
  check(mesh_.origin_.element_lines.size(), mesh_.elements_.size(), "lines of elements");
  check(mesh_.origin_.element_names.size(), mesh_.elements_.size(), "names of elements");
  check(mesh_.origin_.element_expected.size(), mesh_.elements_.size(), "expected verdicts of elements");
  check(mesh_.origin_.node_tags.size(), node_count(), "numbers of nodes");
}

// Positive weights that are values can belong to a net with others: making the element tells.
void MeshBuilder::check_converted_weights() const {
  for (std::size_t i = 0; i < mesh_.elements_.size(); ++i) {
    if (mesh_.elements_[i].basis != Basis::lagrange || !mesh_.rational(i)) continue;
    try {
      mesh_.element(i);
    } catch (const std::invalid_argument& error) {
      throw MeshError(i, error.what() + std::string("; expected an element with a positive control net "
                                                    "(degree elevation may give one)"));
    }
  }
}

Mesh MeshBuilder::build() && {
  if (mesh_.elements_.empty()) throw MeshError("there are no elements, expected at least one");
  if (node_count() == 0) throw MeshError("there are no nodes, expected those of the elements");
  check_sizes();
  check_coordinates();
  check_connectivity();
  check_origin();

  const std::size_t lagrange = in_basis_[static_cast<std::size_t>(Basis::lagrange)];
  if (lagrange > 0 && !mesh_.weights_.empty()) check_converted_weights();

  const bool mixed = lagrange > 0 && lagrange < mesh_.elements_.size();
  mesh_.origin_.basis_name = mixed ? "mixed" : lagrange > 0 ? "lagrange" : "bernstein";
  Mesh result = std::move(mesh_);
  *this = MeshBuilder();
  return result;
}

}  // namespace bezcert
