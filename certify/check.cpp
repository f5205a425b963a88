#include "check.hpp"

#include "bezcert/certificate/certificate.hpp"
#include "bezcert/io/curve/read.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/report/report.hpp"
#include "exit_code.hpp"
#include "memory.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "reproducers.hpp"
#include "subcommand.hpp"
#include "threads.hpp"

#include <iostream>
#include <optional>

namespace bezcert::certify {
namespace {

struct Input {
  std::optional<Mesh> mesh;
  std::string sha256;
  bool is_json = false;
};

Input read_input(const std::string& path, const CheckArguments& arguments, Executor& threads) {
  constexpr std::size_t worth_threads = std::size_t{1} << 20;  // bytes: less is read before they have begun
  const FileBytes file(path);
  const std::string_view bytes = file.view();
  expect_memory(bytes.size() * 3 / 2);
  Input result;
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  result.is_json = begin != bytes.npos && bytes[begin] == '{';
  ReadOptions options = arguments.read;
  const auto read = [&] { result.mesh = read_mesh(path, bytes, options); };
  const auto hash = [&] { result.sha256 = sha256(bytes); };
  if (bytes.size() < worth_threads || threads.threads() == 1) {
    read();
    hash();
  } else {
    options.executor = &threads;
    threads.run(2, [&](std::size_t i) { i == 0 ? read() : hash(); });
  }
  file.check_unchanged();
  return result;
}

// What a certificate says of its elements file: the input itself if `verifier` reads it, or the file written
// for it.
CertificateHeader header_of(const std::string& path, const Input& input, const CheckArguments& arguments) {
  const Mesh& mesh = *input.mesh;
  CertificateHeader header{input.sha256, mesh.origin().basis_name, mesh.origin().numbers};
  if (!arguments.elements.empty()) header.elements_sha256 = sha256(read_file(arguments.elements));
  if (!arguments.elements.empty() || input.is_json) {
    header.basis = "mixed";
    header.numbers = Numbers::decimal;
  } else if (mesh.origin().line(0) == 0) {
    throw InputError(path, 0,
                     "is binary, which verifier does not read: expected --elements=FILE beside --certificate "
                     "(the mesh as exact .bez.json), or an ASCII .msh");
  }
  return header;
}

void warn_of_missing_evidence(const std::string& path, std::size_t count) {
  if (count == 0) return;
  std::cerr << "certify: " << path << ": " << count
            << " verdicts without evidence: it would exceed the limits of the format\n";
}

class Check {
 public:
  /// `certificate`: where to write it; null if it is not asked for.
  Check(const CheckArguments& arguments, std::ostream& stream, std::ostream* certificate)
      : arguments_(arguments),
        format_(*find_report_format(arguments.format)),
        stream_(stream),
        certificate_(certificate),
        threads_(arguments.jobs) {
    if (!arguments.curves.empty()) {
      curves_ = read_curves_file(arguments.curves);
    }
  }

  int run() {
    int code = exit_certified;
    for (const std::string& path : arguments_.meshes) code = worse(code, check_one(path));
    return code;
  }

 private:
  int check_one(const std::string& path) {
    const auto started = std::chrono::steady_clock::now();
    const Input input = read_input(path, arguments_, threads_);
    if (!arguments_.elements.empty()) {
      write_file(arguments_.elements, [&](std::ostream& stream) { write_bez_json(stream, *input.mesh); });
    }
    const auto report = format_.make(stream_, {path, input.sha256, arguments_.curves, started});
    Reproducers reproducers(path);
    Progress progress(path);
    std::optional<CertificateWriter> proof;
    if (certificate_ != nullptr) proof.emplace(*certificate_, header_of(path, input, arguments_));
    Observers observers;
    if (proof) observers.add(*proof);
    for (CheckObserver* one :
         {static_cast<CheckObserver*>(report.get()), static_cast<CheckObserver*>(&reproducers),
          static_cast<CheckObserver*>(&progress)}) {
      observers.add(*one);
    }
    const CheckOptions options{arguments_.criteria, arguments_.budget, curves_, &threads_, arguments_.filter};
    const Outcome outcome = check_mesh(*input.mesh, options, observers).outcome();
    if (proof) warn_of_missing_evidence(arguments_.certificate, proof->without_evidence());
    const bool passes = outcome == Outcome::undecided && !arguments_.fail_on_undecided;
    return passes ? exit_certified : exit_code_of(outcome);
  }

  // Of several meshes the worst code counts.
  static int worse(int a, int b) {
    for (const int code : {exit_contradiction, exit_input_error, exit_invalid, exit_undecided}) {
      if (a == code || b == code) return code;
    }
    return exit_certified;
  }

  const CheckArguments& arguments_;
  const ReportFormat& format_;
  std::ostream& stream_;
  std::ostream* certificate_;
  Threads threads_;
  std::vector<InputCurve> curves_;
};

}  // namespace

int check(const CheckArguments& arguments) {
  const bool is_about_one = !arguments.certificate.empty() || !arguments.elements.empty();
  if (arguments.meshes.size() > 1 && is_about_one) {
    throw InputError(arguments.certificate.empty() ? arguments.elements : arguments.certificate, 0,
                     "is about one mesh, but there are " + std::to_string(arguments.meshes.size()) +
                         ": expected one MESH with --certificate or --elements");
  }
  check_outputs(arguments.meshes, {{"-o", arguments.output},
                                   {"--certificate", arguments.certificate},
                                   {"--elements", arguments.elements}});
  int code = exit_certified;
  const auto run = [&](std::ostream* certificate) {
    if (arguments.output.empty()) {
      code = Check(arguments, std::cout, certificate).run();
    } else {
      write_file(arguments.output,
                 [&](std::ostream& stream) { code = Check(arguments, stream, certificate).run(); });
    }
  };
  if (arguments.certificate.empty()) {
    run(nullptr);
  } else {
    write_file(arguments.certificate, [&](std::ostream& stream) { run(&stream); });
  }
  return code;
}

Run add_check(CLI::App& command) {
  const auto arguments = std::make_shared<CheckArguments>();
  CheckArguments& to = *arguments;
  std::vector<std::string> formats;
  std::string format_names;
  for (const ReportFormat& format : report_formats()) {
    formats.emplace_back(format.name);
    format_names += (format_names.empty() ? "" : "|") + formats.back();
  }
  command.add_option("MESH", to.meshes, "mesh files: Gmsh .msh or .bez.json")->required();
  add_read_options(command, to.read);
  add_criteria_choice(command, to.criteria);
  command.add_option("--format", to.format, "of the report (default " + formats.front() + ")")
      ->check(CLI::IsMember(formats))
      ->option_text(format_names);
  command.add_option("-o", to.output, "write the report to FILE")->option_text("FILE");
  command
      .add_option_function<std::string>(
          "--fail-on", [&to](const std::string& word) { to.fail_on_undecided = word == "undecided"; },
          "undecided (default): exit 3 if something is open; invalid: exit 0 then")
      ->check(CLI::IsMember({"invalid", "undecided"}))
      ->option_text("invalid|undecided");
  command
      .add_option("--domain", to.curves,
                  "curves (.bez.json) that the mesh must conform to: each exactly covered by edges")
      ->option_text("CURVES");
  command
      .add_option("--certificate", to.certificate,
                  "write a proof of every verdict to FILE, for `verifier`: of one mesh")
      ->option_text("FILE");
  command
      .add_option("--elements", to.elements,
                  "write the mesh exactly, as .bez.json, to FILE; a certificate is then about that file")
      ->option_text("FILE");
  command
      .add_option("--jobs", to.jobs,
                  "threads (default: one a core); the report does not depend on their number")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  add_budget(command, to.budget);
  // For tests: the report must be the same. An empty group is not listed.
  command
      .add_flag_callback(
          "--exact", [&to] { to.filter = Filter::off; }, "integers alone decide about elements")
      ->group("");
  return [arguments] { return check(*arguments); };
}

}  // namespace bezcert::certify
