// The command line: options in, one subcommand run, an exit code out.
#include "bezcert/io/input_error.hpp"
#include "check.hpp"
#include "exit_code.hpp"
#include "explain.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <new>

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

// "all", "none" or a comma-separated list of names.
std::vector<const Criterion*> chosen_criteria(const std::string& text) {
  std::vector<const Criterion*> result;
  if (text == "none") return result;
  for (const Criterion& criterion : criteria()) {
    if (text == "all") result.push_back(&criterion);
  }
  if (text == "all") return result;
  std::string known;
  for (const Criterion& criterion : criteria()) known += ", " + std::string(criterion.name);
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string one = text.substr(at, comma - at);
    const Criterion* criterion = find_criterion(one);
    if (criterion == nullptr) {
      throw CLI::ValidationError("--criteria", "\"" + one + "\" is no criterion: expected all, none" + known);
    }
    if (std::find(result.begin(), result.end(), criterion) == result.end()) result.push_back(criterion);
    at = comma + 1;
  }
  return result;
}

// The words of --basis and --numbers, as given.
struct ReadWords {
  std::string basis = "lagrange";
  std::string numbers = "binary64";

  ReadOptions options() const {
    return {basis == "lagrange" ? Basis::lagrange : Basis::bernstein,
            numbers == "binary64" ? Numbers::binary64 : Numbers::decimal};
  }
};

void add_read_options(CLI::App& command, ReadWords& words) {
  command
      .add_option("--basis", words.basis,
                  "what the points of a .msh are: lagrange nodes (default) or bernstein control points")
      ->check(CLI::IsMember({"lagrange", "bernstein"}))
      ->option_text("lagrange|bernstein");
  command
      .add_option("--numbers", words.numbers,
                  "what text coordinates of a .msh mean: the nearest double (default) or their decimal value")
      ->check(CLI::IsMember({"binary64", "decimal"}))
      ->option_text("binary64|decimal");
}

// "PIECES" or "PIECES,BITS".
void add_budget(CLI::App& command, Budget& budget) {
  command
      .add_option_function<std::string>(
          "--budget",
          [&budget](const std::string& text) {
            const std::size_t comma = std::min(text.find(','), text.size());
            const auto number = [&](const std::string& digits, std::size_t low, std::size_t high) {
              std::size_t value = 0;
              const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
              if (error != std::errc() || end != digits.data() + digits.size() || value < low ||
                  value > high) {
                throw CLI::ValidationError("--budget",
                                           "\"" + text +
                                               "\": expected PIECES from 1 to 1000000, or PIECES,BITS "
                                               "with BITS from 0 to 1000000000000");
              }
              return value;
            };
            budget.pieces = number(text.substr(0, comma), 1, 1000000);
            // In proportion, and none with one piece: the coefficients alone.
            budget.algebra_bits = comma < text.size() ? number(text.substr(comma + 1), 0, 1000000000000)
                                                      : (budget.pieces - 1) << 13;
            budget.contact.algebra_bits = budget.algebra_bits;
          },
          "pieces of the subdivision of one element (default 4096), and bits of the largest resultant that "
          "algebra is asked about (default 8192 (PIECES - 1); 0: no algebra)")
      ->option_text("PIECES[,BITS]");
}

int run(int argc, char** argv) {
  CLI::App app{"Exact verification of curved planar meshes: is every element an injective map?", "certify"};
  app.set_version_flag("--version", "bezcert " BEZCERT_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 all certified, 1 something invalid, 2 usage or input error, 3 undecided,\n"
      "4 a sound criterion contradicts the exact decision (a defect of bezcert).");

  ReadWords read_words;
  CheckOptions check_options;
  std::string criteria_text = "all";
  std::string fail_on = "undecided";
  CLI::App* check_command = app.add_subcommand("check", "decide every element of meshes");
  check_command->add_option("MESH", check_options.meshes, "mesh files: Gmsh .msh or .bez.json")->required();
  add_read_options(*check_command, read_words);
  check_command
      ->add_option("--criteria", criteria_text,
                   "published conditions to hold against the decision (default all)")
      ->option_text("all|none|LIST");
  check_command->add_option("--format", check_options.format, "of the report (default text)")
      ->check(CLI::IsMember({"text", "jsonl"}))
      ->option_text("text|jsonl");
  check_command->add_option("-o", check_options.output, "write the report to FILE")->option_text("FILE");
  check_command
      ->add_option("--fail-on", fail_on,
                   "undecided (default): exit 3 if something is open; invalid: exit 0 then")
      ->check(CLI::IsMember({"invalid", "undecided"}))
      ->option_text("invalid|undecided");
  check_command
      ->add_option("--domain", check_options.domain,
                   "curves (.bez.json) that the mesh must conform to: each exactly covered by edges")
      ->option_text("CURVES");
  check_command
      ->add_option("--certificate", check_options.certificate,
                   "write a proof of every verdict to FILE, for `verifier`: of one mesh")
      ->option_text("FILE");
  check_command
      ->add_option("--elements", check_options.elements,
                   "write the mesh exactly, as .bez.json, to FILE; a certificate is then about that file")
      ->option_text("FILE");
  check_command
      ->add_option("--jobs", check_options.jobs,
                   "threads (default: one a core); the report does not depend on their number")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  add_budget(*check_command, check_options.budget);
  // For tests: the report must be the same. An empty group is not listed.
  check_command
      ->add_flag_callback(
          "--exact", [&] { check_options.filter = Filter::off; }, "integers alone decide about elements")
      ->group("");

  ExplainOptions explain_options;
  CLI::App* explain_command = app.add_subcommand("explain", "everything known of one element");
  explain_command->add_option("MESH", explain_options.mesh, "mesh file")->required();
  explain_command
      ->add_option("--element", explain_options.element,
                   "its number in the file (.bez.json: its place, from 1) or its name")
      ->required()
      ->option_text("N");
  add_read_options(*explain_command, read_words);
  add_budget(*explain_command, explain_options.budget);

  CLI::App* criteria_command = app.add_subcommand("criteria", "the published conditions and their standing");

  try {
    app.parse(argc, argv);
    check_options.criteria = chosen_criteria(criteria_text);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::string what = error.what();
    std::replace(what.begin(), what.end(), '\n', ' ');
    const bool no_command =
        dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && app.get_subcommands().empty();
    if (no_command) what = "a subcommand is required: check MESH..., explain MESH --element N, or criteria";
    std::cerr << "certify: " << what << " (certify --help lists the options)\n";
    return exit_input_error;
  }
  check_options.read = explain_options.read = read_words.options();
  check_options.fail_on_undecided = fail_on == "undecided";
  if (criteria_command->parsed()) return list_criteria();
  return explain_command->parsed() ? explain(explain_options) : check(check_options);
}

}  // namespace
}  // namespace bezcert::certify

int main(int argc, char** argv) {
  try {
    std::ios::sync_with_stdio(false);
    const int code = bezcert::certify::run(argc, argv);
    std::cout.flush();
    if (!std::cout) throw bezcert::InputError("standard output", 0, "cannot be written");
    return code;
  } catch (const std::bad_alloc&) {
    std::cerr << "certify: out of memory: expected a smaller mesh, degree or --budget\n";
    return bezcert::certify::exit_input_error;
  } catch (const bezcert::InputError& error) {
    std::cout.flush();
    std::cerr << error.what() << '\n';
    return bezcert::certify::exit_input_error;
  }
}
