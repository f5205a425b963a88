// The report for people: a line a bad element, then what it adds up to.
#pragma once

#include "bezcert/report/report.hpp"

namespace bezcert {

std::unique_ptr<Report> make_text_report(std::ostream& stream, ReportSource source);

inline constexpr ReportFormat text_report_format{"text", make_text_report};

/// "mesh.msh:12: element 5 (triangle, degree 2)", with the name if it has one.
std::string element_title(const std::string& input, const Mesh& mesh, std::size_t i);

}  // namespace bezcert
