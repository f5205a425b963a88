// certify explain: everything known of one element.
#pragma once

#include "bezcert/io/mesh/read.hpp"
#include "bezcert/decide/decide.hpp"

#include <string>

namespace bezcert::certify {

struct ExplainOptions {
  std::string mesh;
  /// Its number in the file (place from 1 where the format has no numbers), or its name.
  std::string element;
  ReadOptions read;
  Budget budget;
};

/// The exit code that `check` would give for this element. Throws InputError.
int explain(const ExplainOptions& options);

}  // namespace bezcert::certify
