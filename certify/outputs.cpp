#include "outputs.hpp"

#include "bezcert/io/input_error.hpp"

#include <filesystem>

namespace bezcert::certify {
namespace {

// One path for all ways to write it, whether or not there is a file.
std::filesystem::path place_of(const std::string& path) {
  std::error_code error;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
}

}  // namespace

void check_outputs(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
  for (const auto& [option, output] : outputs) {
    if (output.empty()) continue;
    std::error_code error;
    for (const std::string& input : inputs) {
      if (std::filesystem::equivalent(input, output, error)) {
        throw InputError(output, 0, std::string("is an input: expected another file for ") + option);
      }
    }
    for (const auto& [other_option, other] : outputs) {
      if (other_option == option) break;
      if (other.empty() || place_of(other) != place_of(output)) continue;
      if (std::filesystem::status(output, error).type() == std::filesystem::file_type::character) continue;
      throw InputError(
          output, 0,
          std::string("is given twice: expected different files for ") + other_option + " and " + option);
    }
  }
}

}  // namespace bezcert::certify
