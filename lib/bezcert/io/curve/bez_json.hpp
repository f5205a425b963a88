// Curves of our own exact format, .bez.json (docs/formats.md).
#pragma once

#include "bezcert/io/bez_json_values.hpp"
#include "bezcert/curve/input_curve.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// The curves of a file, at least one; it need not have elements, which are not looked at. Throws InputError.
std::vector<InputCurve> read_bez_json_curves(const std::string& file, std::string_view bytes);

/// The curves of a list, none or more. Throws InputError.
std::vector<InputCurve> bez_json_curves(const BezJsonValues& values, const JsonValue& list);

}  // namespace bezcert
