// The examples of make_certificates.py: expected.tsv and the files it names.
#pragma once

#include "../cli/program.hpp"

#include <string>
#include <vector>

namespace bezcert::test {

inline const std::string verifier_folder = BEZCERT_SOURCE_DIR "/tests/verifier/";

struct Example {
  std::string certificate, elements;  ///< paths below tests/verifier
  int code = 0;
  std::size_t line = 0;  ///< 0: not told

  std::string path() const { return verifier_folder + certificate; }
  std::string elements_path() const { return verifier_folder + "elements/" + elements; }
  std::string folder() const { return certificate.substr(0, certificate.find('/')); }
};

inline std::vector<Example> examples() {
  std::vector<Example> result;
  for (const std::string& row : lines_of(bytes_of(verifier_folder + "expected.tsv"))) {
    if (row.starts_with('#')) continue;
    std::istringstream words(row);
    Example example;
    INFO(row);
    REQUIRE(
        static_cast<bool>(words >> example.certificate >> example.elements >> example.code >> example.line));
    result.push_back(example);
  }
  return result;
}

}  // namespace bezcert::test
