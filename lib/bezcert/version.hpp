// The version of the library and its programs; CMake reads it here.
#pragma once

#include <string_view>

namespace bezcert {

inline constexpr std::string_view version = "0.2.0";

}  // namespace bezcert
