#include "bezcert/report/jsonl_report.hpp"
#include "bezcert/report/text_report.hpp"

#include <array>

namespace bezcert {
namespace {

// The default first. One line a format.
constexpr std::array formats = {text_report_format, jsonl_report_format};

}  // namespace

std::span<const ReportFormat> report_formats() { return formats; }

const ReportFormat* find_report_format(std::string_view name) {
  for (const ReportFormat& format : formats) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

}  // namespace bezcert
