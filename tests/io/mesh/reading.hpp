// What tests of readers share: a file's bytes, the one way a reader may refuse, what a mesh must keep.
#pragma once

#include "bezcert/io/input_error.hpp"
#include "bezcert/io/mesh/read.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace bezcert::test {

inline std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  INFO("file " << path);
  REQUIRE(stream.good());
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The rows of a table of tabs, without its first line; comments (#) and blank lines left out.
inline std::vector<std::vector<std::string>> table_of(const std::string& path, std::size_t columns) {
  std::istringstream lines(bytes_of(path));
  std::vector<std::vector<std::string>> rows;
  bool first = true;
  for (std::string line; std::getline(lines, line);) {
    if (first || line.empty() || line.front() == '#') {
      first = false;
      continue;
    }
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    INFO(path << ": " << line);
    REQUIRE(row.size() == columns);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// `text` with the one occurrence of `from` replaced.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  INFO("'" << from << "' must occur exactly once");
  REQUIRE(at != std::string::npos);
  REQUIRE(text.find(from, at + 1) == std::string::npos);
  return text.replace(at, from.size(), to);
}

struct Refusal {
  std::string what;
  std::string file;
  std::size_t line = 0;
};

/// How reading is refused; nothing if it succeeds. Any other exception leaves and fails the test.
inline std::optional<Refusal> refusal(std::string_view bytes, const ReadOptions& options = {},
                                      const std::string& file = "input") {
  try {
    read_mesh(file, bytes, options);
    return std::nullopt;
  } catch (const InputError& error) {
    return Refusal{error.what(), error.file(), error.line()};
  }
}

inline bool is_one_line(std::string_view text) {
  return !text.empty() && text.find_first_of("\n\r") == std::string_view::npos;
}

/// Nothing a terminal would act on.
inline bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c & 0x80) != 0 || (c >= 32 && c < 127); });
}

/// Requires InputError with one line "input[:line]: ... phrase ...".
inline void require_refused(std::string_view bytes, const std::string& phrase, std::size_t line,
                            const ReadOptions& options = {}) {
  const auto refused = refusal(bytes, options);
  INFO("expected line " << line << " and: " << phrase);
  REQUIRE(refused.has_value());
  INFO("message: " << refused->what.substr(0, 400));
  CHECK(is_one_line(refused->what));
  CHECK(is_printable(refused->what));
  CHECK(refused->what.size() < 400);
  CHECK(refused->file == "input");
  CHECK(refused->line == line);
  const std::string start = line > 0 ? "input:" + std::to_string(line) + ": " : "input: ";
  CHECK(refused->what.substr(0, start.size()) == start);
  CHECK(refused->what.find(phrase) != std::string::npos);
}

/// Whether what was read is sound: indices within, coordinates finite, every element can be made.
inline bool is_sound(const Mesh& mesh) {
  if (mesh.elements().empty() || mesh.node_count() != mesh.coordinates(1).size()) return false;
  if (!mesh.weights().empty() && mesh.weights().size() != mesh.node_count()) return false;
  for (const ExactVector* numbers : {&mesh.coordinates(0), &mesh.coordinates(1), &mesh.weights()}) {
    for (const double value : numbers->doubles()) {
      if (!std::isfinite(value)) return false;
    }
  }
  for (const std::uint32_t node : mesh.connectivity()) {
    if (node >= mesh.node_count()) return false;
  }
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    const MeshElement& entry = mesh.elements()[i];
    if (entry.first_node + coefficient_count(entry.shape) > mesh.connectivity().size()) return false;
    if (mesh.element(i).coordinates()[0].size() != coefficient_count(entry.shape)) return false;
  }
  return true;
}

/// The points of the i-th element, by rows.
inline std::vector<std::pair<Rational, Rational>> points_of(const Mesh& mesh, std::size_t i) {
  const MeshElement& entry = mesh.elements().at(i);
  std::vector<std::pair<Rational, Rational>> points;
  for (std::size_t k = 0; k < coefficient_count(entry.shape); ++k) {
    const std::uint32_t node = mesh.connectivity().at(entry.first_node + k);
    points.emplace_back(mesh.coordinates(0)[node], mesh.coordinates(1)[node]);
  }
  return points;
}

}  // namespace bezcert::test
