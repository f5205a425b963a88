#include "bezcert/io/mesh/gmsh_types.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace bezcert {
namespace {

// Types by number, orders 1, 2, 3, ...
constexpr std::array triangle_types = {2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
constexpr std::array quadrangle_types = {3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
constexpr std::array line_types = {1, 8, 26, 27, 28, 62, 63, 64, 65, 66};

struct Listed {
  int number;
  int nodes;
  std::string_view name;
};

constexpr std::array serendipity_types = {
    Listed{16, 8, "8-node serendipity quadrangle"},   Listed{20, 9, "9-node serendipity triangle"},
    Listed{22, 12, "12-node serendipity triangle"},   Listed{24, 15, "15-node serendipity triangle"},
    Listed{39, 12, "12-node serendipity quadrangle"}, Listed{40, 16, "16-node serendipity quadrangle"},
    Listed{41, 20, "20-node serendipity quadrangle"}, Listed{52, 18, "18-node serendipity triangle"},
    Listed{53, 21, "21-node serendipity triangle"},   Listed{54, 24, "24-node serendipity triangle"},
    Listed{55, 27, "27-node serendipity triangle"},   Listed{56, 30, "30-node serendipity triangle"},
    Listed{57, 24, "24-node serendipity quadrangle"}, Listed{58, 28, "28-node serendipity quadrangle"},
    Listed{59, 32, "32-node serendipity quadrangle"}, Listed{60, 36, "36-node serendipity quadrangle"},
    Listed{61, 40, "40-node serendipity quadrangle"},
};

// Surface types with a fixed count that are no polynomial Lagrange elements of order 1 to 10.
constexpr std::array other_surface_types = {
    Listed{68, 3, "triangle border"},
    Listed{85, 1, "triangle of order 0"},
    Listed{86, 1, "quadrangle of order 0"},
    Listed{138, 4, "MINI triangle with a bubble"},
};

// Tetrahedra, hexahedra, prisms, pyramids: number and nodes, for skipping.
constexpr std::array volume_types = {
    Listed{4, 4, ""},     Listed{5, 8, ""},     Listed{6, 6, ""},     Listed{7, 5, ""},
    Listed{11, 10, ""},   Listed{12, 27, ""},   Listed{13, 18, ""},   Listed{14, 14, ""},
    Listed{17, 20, ""},   Listed{18, 15, ""},   Listed{19, 13, ""},   Listed{29, 20, ""},
    Listed{30, 35, ""},   Listed{31, 56, ""},   Listed{32, 22, ""},   Listed{33, 28, ""},
    Listed{71, 84, ""},   Listed{72, 120, ""},  Listed{73, 165, ""},  Listed{74, 220, ""},
    Listed{75, 286, ""},  Listed{79, 34, ""},   Listed{80, 40, ""},   Listed{81, 46, ""},
    Listed{82, 52, ""},   Listed{83, 58, ""},   Listed{87, 1, ""},    Listed{88, 1, ""},
    Listed{89, 1, ""},    Listed{90, 40, ""},   Listed{91, 75, ""},   Listed{92, 64, ""},
    Listed{93, 125, ""},  Listed{94, 216, ""},  Listed{95, 343, ""},  Listed{96, 512, ""},
    Listed{97, 729, ""},  Listed{98, 1000, ""}, Listed{99, 32, ""},   Listed{100, 44, ""},
    Listed{101, 56, ""},  Listed{102, 68, ""},  Listed{103, 80, ""},  Listed{104, 92, ""},
    Listed{105, 104, ""}, Listed{106, 126, ""}, Listed{107, 196, ""}, Listed{108, 288, ""},
    Listed{109, 405, ""}, Listed{110, 550, ""}, Listed{111, 24, ""},  Listed{112, 33, ""},
    Listed{113, 42, ""},  Listed{114, 51, ""},  Listed{115, 60, ""},  Listed{116, 69, ""},
    Listed{117, 78, ""},  Listed{118, 30, ""},  Listed{119, 55, ""},  Listed{120, 91, ""},
    Listed{121, 140, ""}, Listed{122, 204, ""}, Listed{123, 285, ""}, Listed{124, 385, ""},
    Listed{125, 21, ""},  Listed{126, 29, ""},  Listed{127, 37, ""},  Listed{128, 45, ""},
    Listed{129, 53, ""},  Listed{130, 61, ""},  Listed{131, 69, ""},  Listed{132, 1, ""},
    Listed{137, 16, ""},  Listed{139, 5, ""},
};

template <class Types>
int order_of(const Types& types, long number) {
  const auto found = std::find(types.begin(), types.end(), number);
  return found == types.end() ? 0 : static_cast<int>(std::distance(types.begin(), found)) + 1;
}

template <class Types>
const Listed* listed(const Types& types, long number) {
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const Listed& entry) { return entry.number == number; });
  return found == types.end() ? nullptr : &*found;
}

GmshType surface(Shape shape) {
  return {GmshClass::surface, static_cast<int>(coefficient_count(shape)), shape, ""};
}

}  // namespace

GmshType gmsh_type(long number) {
  if (const int p = order_of(triangle_types, number)) return surface(Shape::triangle(p));
  if (const int p = order_of(quadrangle_types, number)) return surface(Shape::square(p, p));
  if (const int p = order_of(line_types, number)) return {GmshClass::line, p + 1, {}, ""};
  if (number == 84) return {GmshClass::line, 1, {}, ""};
  if (number == 15) return {GmshClass::point, 1, {}, ""};
  if (const Listed* entry = listed(serendipity_types, number)) {
    return {GmshClass::serendipity, entry->nodes, {}, entry->name};
  }
  if (const Listed* entry = listed(other_surface_types, number)) {
    return {GmshClass::unsupported, entry->nodes, {}, entry->name};
  }
  if (const Listed* entry = listed(volume_types, number)) return {GmshClass::volume, entry->nodes, {}, ""};
  return {};
}

std::vector<std::size_t> gmsh_node_order(Shape shape) {
  const bool triangle = shape.domain == Domain::triangle;
  std::vector<std::size_t> order;
  const auto add = [&](int column, int row) { order.push_back(coefficient_index(shape, row, column)); };
  // The ring of corners and edges at distance `o` from the boundary, p steps long, then what is inside.
  int o = 0;
  for (int p = shape.degree(0); p >= 0; p -= triangle ? 3 : 2, ++o) {
    if (p == 0) {
      add(o, o);
      break;
    }
    if (triangle) {
      add(o, o);
      add(o + p, o);
      add(o, o + p);
      for (int k = 1; k < p; ++k) add(o + k, o);
      for (int k = 1; k < p; ++k) add(o + p - k, o + k);
      for (int k = 1; k < p; ++k) add(o, o + p - k);
    } else {
      add(o, o);
      add(o + p, o);
      add(o + p, o + p);
      add(o, o + p);
      for (int k = 1; k < p; ++k) add(o + k, o);
      for (int k = 1; k < p; ++k) add(o + p, o + k);
      for (int k = 1; k < p; ++k) add(o + p - k, o + p);
      for (int k = 1; k < p; ++k) add(o, o + p - k);
    }
  }
  return order;
}

}  // namespace bezcert
