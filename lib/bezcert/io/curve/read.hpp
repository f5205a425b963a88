// Reading a file of curves of any known format.
#pragma once

#include "bezcert/curve/input_curve.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bezcert {

/// The curves in the bytes of a file, at least one; the format is told by the first characters. `file` names
/// it in errors. Throws InputError.
std::vector<InputCurve> read_curves(const std::string& file, std::string_view bytes);

/// The same for a file by its path.
std::vector<InputCurve> read_curves_file(const std::string& path);

}  // namespace bezcert
