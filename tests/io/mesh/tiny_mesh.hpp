// A mesh of two triangles, and writers of its four .msh forms: what the tests of the reader spoil.
//
// Nodes 1..4, triangles 11 = (1, 2, 3) and 12 = (1, 3, 4), and a point and a line that the reader ignores.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace bezcert::test {

inline constexpr std::array<std::array<double, 2>, 4> tiny_nodes = {
    {{0, 0}, {1.5, 0.25}, {1.25, 1}, {-0.5, 0.75}}};

/// Lines 4 to 10 are $Nodes .. $EndNodes, line 12 the number of elements, lines 13 to 16 the elements.
inline const std::string tiny_22a =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$Nodes\n4\n1 0 0 0\n2 1.5 0.25 0\n3 1.25 1 0\n4 -0.5 0.75 0\n$EndNodes\n"
    "$Elements\n4\n1 15 2 7 7 1\n2 1 2 7 7 1 2\n11 2 2 7 7 1 2 3\n12 2 2 7 7 1 3 4\n$EndElements\n";

/// Lines 4 to 16 are $Nodes .. $EndNodes (header in line 5, blocks in 6 and 11), line 18 the header of
/// $Elements, its blocks in lines 19, 21 and 23.
inline const std::string tiny_41a =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$Nodes\n2 4 1 4\n1 1 0 2\n1\n2\n0 0 0\n1.5 0.25 0\n2 1 0 2\n3\n4\n1.25 1 0\n-0.5 0.75 0\n$EndNodes\n"
    "$Elements\n3 4 1 12\n0 1 15 1\n1 1\n1 1 1 1\n2 1 2\n2 1 2 2\n11 1 2 3\n12 1 3 4\n$EndElements\n";

/// Text and binary numbers one after the other, in the machine's byte order or the other one.
class ByteWriter {
 public:
  explicit ByteWriter(bool swapped = false) : swapped_(swapped) {}

  ByteWriter& text(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  ByteWriter& int32(std::int32_t value) { return raw(value); }
  ByteWriter& uint64(std::uint64_t value) { return raw(value); }
  ByteWriter& float64(double value) { return raw(value); }
  const std::string& str() const { return bytes_; }

 private:
  template <class T>
  ByteWriter& raw(T value) {
    std::array<char, sizeof(T)> buffer;
    std::memcpy(buffer.data(), &value, sizeof(T));
    if (swapped_) std::reverse(buffer.begin(), buffer.end());
    bytes_.append(buffer.data(), buffer.size());
    return *this;
  }

  bool swapped_;
  std::string bytes_;
};

/// $MeshFormat of a binary file.
inline ByteWriter binary_start(std::string_view version, bool swapped = false) {
  ByteWriter w(swapped);
  w.text("$MeshFormat\n").text(version).text(" 1 8\n").int32(1).text("\n$EndMeshFormat\n");
  return w;
}

/// $Nodes of the tiny mesh with other coordinates, version 2.2.
inline void write_nodes_22b(ByteWriter& w, const std::array<std::array<double, 2>, 4>& nodes = tiny_nodes) {
  w.text("$Nodes\n4\n");
  for (int k = 0; k < 4; ++k) {
    const auto& [x, y] = nodes[static_cast<std::size_t>(k)];
    w.int32(k + 1).float64(x).float64(y).float64(0);
  }
  w.text("\n$EndNodes\n");
}

inline std::string tiny_22b(bool swapped = false) {
  ByteWriter w = binary_start("2.2", swapped);
  write_nodes_22b(w);
  w.text("$Elements\n4\n");
  w.int32(15).int32(1).int32(2).int32(1).int32(7).int32(7).int32(1);
  w.int32(1).int32(1).int32(2).int32(2).int32(7).int32(7).int32(1).int32(2);
  w.int32(2).int32(2).int32(2);  // type, number in the block, number of tags
  w.int32(11).int32(7).int32(7).int32(1).int32(2).int32(3);
  w.int32(12).int32(7).int32(7).int32(1).int32(3).int32(4);
  w.text("\n$EndElements\n");
  return w.str();
}

/// $Nodes of the tiny mesh with other coordinates, version 4.1.
inline void write_nodes_41b(ByteWriter& w, const std::array<std::array<double, 2>, 4>& nodes = tiny_nodes) {
  w.text("$Nodes\n").uint64(2).uint64(4).uint64(1).uint64(4);
  for (int block = 0; block < 2; ++block) {
    w.int32(block + 1).int32(1).int32(0).uint64(2);  // dimension, entity, parametric, number
    for (int k = 0; k < 2; ++k) w.uint64(static_cast<std::uint64_t>(2 * block + k + 1));
    for (int k = 0; k < 2; ++k) {
      const auto& [x, y] = nodes[static_cast<std::size_t>(2 * block + k)];
      w.float64(x).float64(y).float64(0);
    }
  }
  w.text("\n$EndNodes\n");
}

inline std::string tiny_41b(bool swapped = false) {
  ByteWriter w = binary_start("4.1", swapped);
  write_nodes_41b(w);
  w.text("$Elements\n").uint64(3).uint64(4).uint64(1).uint64(12);
  w.int32(0).int32(1).int32(15).uint64(1).uint64(1).uint64(1);
  w.int32(1).int32(1).int32(1).uint64(1).uint64(2).uint64(1).uint64(2);
  w.int32(2).int32(1).int32(2).uint64(2);
  w.uint64(11).uint64(1).uint64(2).uint64(3);
  w.uint64(12).uint64(1).uint64(3).uint64(4);
  w.text("\n$EndElements\n");
  return w.str();
}

}  // namespace bezcert::test
