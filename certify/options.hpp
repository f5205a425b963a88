// Options that several subcommands have.
#pragma once

#include "bezcert/criterion/criterion.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/io/mesh/read.hpp"

#include <CLI/CLI.hpp>

#include <vector>

namespace bezcert::certify {

/// --basis, --numbers: what a .msh means. Keeps references.
void add_read_options(CLI::App& command, ReadOptions& options);

/// --budget PIECES or PIECES,BITS. Keeps a reference.
void add_budget(CLI::App& command, Budget& budget);

/// --criteria all, none, or a comma-separated list of names. Keeps a reference.
void add_criteria_choice(CLI::App& command, std::vector<const Criterion*>& chosen);

}  // namespace bezcert::certify
