// The command line: one subcommand is chosen and run; what goes wrong becomes one line and an exit code.
#include "bezcert/io/input_error.hpp"
#include "bezcert/version.hpp"
#include "exit_code.hpp"
#include "subcommand.hpp"

#include <algorithm>
#include <iostream>
#include <new>

namespace bezcert::certify {
namespace {

// In the order of `certify --help`.
constexpr Subcommand subcommands[] = {
    {"check", "decide every element of meshes", add_check},
    {"explain", "everything known of one element", add_explain},
    {"criteria", "the published conditions and their standing", add_criteria},
};

// "check, explain or criteria".
std::string subcommand_names() {
  std::string text;
  for (const Subcommand& one : subcommands) {
    const bool last = &one == std::end(subcommands) - 1;
    text += (text.empty() ? "" : last ? " or " : ", ") + std::string(one.name);
  }
  return text;
}

int usage_error(const CLI::App& app, const CLI::ParseError& error) {
  std::string what = error.what();
  std::replace(what.begin(), what.end(), '\n', ' ');
  const bool no_command =
      dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && app.get_subcommands().empty();
  if (no_command) what = "a subcommand is required: " + subcommand_names();
  std::cerr << "certify: " << what << " (certify --help lists the options)\n";
  return exit_input_error;
}

int run(int argc, char** argv) {
  CLI::App app{"Exact verification of curved planar meshes: is every element an injective map?", "certify"};
  app.set_version_flag("--version", "bezcert " + std::string(version));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 all certified, 1 something invalid, 2 usage or input error, 3 undecided,\n"
      "4 a sound criterion contradicts the exact decision (a defect of bezcert).");
  std::vector<std::pair<CLI::App*, Run>> runs;
  for (const Subcommand& subcommand : subcommands) {
    CLI::App* const command = app.add_subcommand(subcommand.name, subcommand.description);
    runs.emplace_back(command, subcommand.add(*command));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : usage_error(app, error);  // 0: --help, --version
  }
  for (const auto& [command, run_it] : runs) {
    if (command->parsed()) return run_it();
  }
  return exit_input_error;
}

}  // namespace
}  // namespace bezcert::certify

int main(int argc, char** argv) {
  using namespace bezcert::certify;
  try {
    std::ios::sync_with_stdio(false);
    const int code = run(argc, argv);
    std::cout.flush();
    if (!std::cout) throw bezcert::InputError("standard output", 0, "cannot be written");
    return code;
  } catch (const std::bad_alloc&) {
    std::cerr << "certify: out of memory: expected a smaller mesh, degree or --budget\n";
  } catch (const bezcert::InputError& error) {
    std::cout.flush();
    std::cerr << error.what() << '\n';
  }
  return exit_input_error;
}
