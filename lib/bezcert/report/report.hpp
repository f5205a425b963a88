// Reports of a check: observers that write to a stream while the check runs, and keep no elements.
//
// A report is one class in a file of its own and one line in registry.cpp. It says how an element is written;
// that is a function of the element alone, so threads prepare it and the text is put together in mesh order.
#pragma once

#include "bezcert/check/check_mesh.hpp"

#include <chrono>
#include <iosfwd>
#include <memory>
#include <string>

namespace bezcert {

/// Where the mesh of a report comes from.
struct ReportSource {
  std::string input;   ///< the path as given; a report shows it printably
  std::string sha256;  ///< of the file's bytes, lower-case hexadecimal
  std::string curves;  ///< the path of the file of curves; empty if there is none
  /// From when on the `seconds` of a report are counted.
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
};

class Report : public CheckObserver {
 public:
  /// Keeps a reference to the stream.
  Report(std::ostream& stream, ReportSource source) : stream_(stream), source_(std::move(source)) {}

  void begin(const Mesh& mesh) final;
  std::unique_ptr<Block> new_block() final;
  void end(const Mesh& mesh, const MeshReport& report) final;

 protected:
  virtual void write_header(const Mesh& mesh) = 0;
  /// Appends what is said of an element. From any thread.
  virtual void append_element(const Mesh& mesh, std::size_t i, const CheckedElement& checked,
                              std::string& text) const = 0;
  virtual void write_summary(const Mesh& mesh, const MeshReport& report) = 0;

  double seconds() const;

  std::ostream& stream_;
  const ReportSource source_;

 private:
  const Mesh* mesh_ = nullptr;
};

/// A kind of report: what --format calls it.
struct ReportFormat {
  std::string_view name;
  std::unique_ptr<Report> (*make)(std::ostream& stream, ReportSource source);
};

/// All of them, the default first.
std::span<const ReportFormat> report_formats();

/// The format of that name, or nullptr.
const ReportFormat* find_report_format(std::string_view name);

}  // namespace bezcert
