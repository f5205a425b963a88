// One subcommand of certify: a file of its own and one line in main.cpp's table.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace bezcert::certify {

/// What is done once the command line has been read: returns the exit code (exit_code.hpp). Throws
/// InputError.
using Run = std::function<int()>;

struct Subcommand {
  const char* name;
  /// One line, for `certify --help`.
  const char* description;
  /// Adds options and arguments to its part of the command line, and says what to run. Throws nothing; values
  /// that do not fit are CLI::ValidationError when the command line is read.
  Run (*add)(CLI::App& command);
};

Run add_check(CLI::App& command);
Run add_explain(CLI::App& command);
Run add_criteria(CLI::App& command);

}  // namespace bezcert::certify
