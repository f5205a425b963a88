// The files that a run writes: none may be an input or another output.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bezcert::certify {

/// An option, and the path it was given; empty if it was not.
using Output = std::pair<const char*, std::string>;

/// Throws InputError. A device such as /dev/null may be given several times.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<Output>& outputs);

}  // namespace bezcert::certify
