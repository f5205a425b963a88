// The JSON Lines report, schema "bezcert.report/1" (docs/report.md): the stable interface for programs.
#pragma once

#include "bezcert/report/report.hpp"

namespace bezcert {

std::unique_ptr<Report> make_jsonl_report(std::ostream& stream, ReportSource source);

inline constexpr ReportFormat jsonl_report_format{"jsonl", make_jsonl_report};

}  // namespace bezcert
