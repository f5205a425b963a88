// certify criteria: the published conditions, what they claim and where they stand.
#include "bezcert/criterion/criterion.hpp"
#include "exit_code.hpp"
#include "subcommand.hpp"

#include <iostream>

namespace bezcert::certify {
namespace {

int list_criteria() {
  for (const Criterion& criterion : criteria()) {
    std::cout << criterion.name << "\n  theorem   " << criterion.theorem << "\n  claim     "
              << name(criterion.claim) << "\n  standing  " << name(criterion.standing)
              << (criterion.refuted ? " (refuted: counterexamples in the corpus)" : "") << "\n  states    "
              << criterion.statement << '\n';
  }
  return exit_certified;
}

}  // namespace

Run add_criteria(CLI::App&) { return list_criteria; }

}  // namespace bezcert::certify
