#include "check.hpp"

#include "bezcert/certificate/certificate.hpp"
#include "bezcert/io/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "exit_code.hpp"
#include "progress.hpp"
#include "report.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>

namespace bezcert::certify {
namespace {

// A sound criterion contradicts the decision: keep the element, so that the defect can be found.
void write_reproducer(const std::string& input, const MeshElement& entry, const Element& element,
                      const CheckedElement& checked) {
  std::string what;
  for (const CheckedCriterion& one : checked.criteria) {
    if (one.is_defect())
      what += std::string(one.criterion->name) + " says " + std::string(name(one.verdict.status)) + "; ";
  }
  const std::string stem = std::filesystem::path(input).filename().string();
  const std::string path = "bezcert-contradiction-" + stem + "-" + std::to_string(entry.tag) + ".bez.json";
  write_file(path, [&](std::ostream& stream) {
    write_bez_json(stream, element, "element " + std::to_string(entry.tag),
                   input + ": " + what + "decision " + std::string(name(checked.decision.verdict)));
  });
  std::cerr << "certify: a sound criterion contradicts the exact decision; reproducer written to " << path
            << '\n';
}

DomainSummary check_domain_of(const Mesh& mesh, const std::string& file, std::span<const InputCurve> curves) {
  DomainSummary result{file, {}, check_domain(mesh, curves)};
  for (const InputCurve& curve : curves) result.names.push_back(curve.name);
  return result;
}

// What a certificate says of its elements file: the input itself if `verifier` reads it, or the file written
// for it.
CertificateHeader header_of(const std::string& input, const std::string& bytes, const std::string& digest,
                            const Mesh& mesh, const CheckOptions& options) {
  CertificateHeader header{digest, mesh.basis_name, mesh.numbers, mesh.elements.size()};
  const bool is_json = bytes[bytes.find_first_not_of(" \t\r\n")] == '{';
  if (!options.elements.empty()) header.elements_sha256 = sha256(read_file(options.elements));
  if (!options.elements.empty() || is_json) {
    header.basis = "mixed";
    header.numbers = Numbers::decimal;
  } else if (mesh.elements.front().line == 0) {
    throw InputError(input, 0,
                     "is binary, which verifier does not read: expected --elements=FILE beside --certificate "
                     "(the mesh as exact .bez.json), or an ASCII .msh");
  }
  return header;
}

Summary check_mesh(const std::string& input, const CheckOptions& options, std::span<const InputCurve> curves,
                   Report& report, std::ostream* certificate) {
  const auto start = std::chrono::steady_clock::now();
  const std::string bytes = read_file(input);
  const Mesh mesh = read_mesh(input, bytes, options.read);
  const std::string digest = sha256(bytes);
  if (!options.elements.empty()) {
    write_file(options.elements, [&](std::ostream& stream) { write_bez_json(stream, mesh); });
  }
  std::optional<CertificateWriter> proof;
  if (certificate != nullptr) proof.emplace(*certificate, header_of(input, bytes, digest, mesh, options));
  report.begin(input, digest, mesh);

  Summary summary;
  summary.criteria = options.criteria;
  summary.by_criterion.resize(options.criteria.size());
  std::vector<ElementState> states;
  states.reserve(mesh.elements.size());
  Progress progress(input, mesh.elements.size());
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const Element element = mesh.element(i);
    const CheckedElement checked = check_element(element, options.criteria, options.budget);
    summary.add(checked);
    states.push_back(state_of(checked.decision));
    report.element(mesh, i, element, checked);
    if (proof) proof->element(element, checked.decision);
    if (std::any_of(checked.criteria.begin(), checked.criteria.end(),
                    [](const CheckedCriterion& one) { return one.is_defect(); })) {
      write_reproducer(input, mesh.elements[i], element, checked);
    }
    progress.done(i + 1);
  }
  summary.mesh = examine_mesh(mesh, states, {options.budget.contact, std::nullopt});
  if (proof) {
    proof->mesh(mesh, summary.mesh);
    if (proof->without_evidence() > 0) {
      std::cerr << "certify: " << options.certificate << ": " << proof->without_evidence()
                << " verdicts without evidence: it would exceed the limits of the format\n";
    }
  }
  if (!options.domain.empty()) summary.domain = check_domain_of(mesh, options.domain, curves);
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.end(mesh, summary);
  return summary;
}

// Of several meshes the worst code counts.
int worse(int a, int b) {
  constexpr int order[] = {exit_contradiction, exit_input_error, exit_invalid, exit_undecided,
                           exit_certified};
  for (const int code : order) {
    if (a == code || b == code) return code;
  }
  return a;
}

int exit_code_of(const Summary& summary, const CheckOptions& options) {
  if (summary.defects > 0) return exit_contradiction;
  const bool embedding = summary.mesh.verdict == MeshVerdict::embedding;
  const bool undecided = summary.mesh.verdict == MeshVerdict::undecided;
  if (!embedding && !undecided) return exit_invalid;
  if (summary.domain && !summary.domain->result.conforming()) return exit_invalid;
  if (undecided && options.fail_on_undecided) return exit_undecided;
  return exit_certified;
}

int check_all(const CheckOptions& options, std::ostream& stream, std::ostream* certificate) {
  const auto report = options.format == "jsonl" ? make_jsonl_report(stream) : make_text_report(stream);
  std::vector<InputCurve> curves;
  if (!options.domain.empty()) curves = read_bez_json_curves(options.domain, read_file(options.domain));
  int code = exit_certified;
  for (const std::string& input : options.meshes) {
    code = worse(code, exit_code_of(check_mesh(input, options, curves, *report, certificate), options));
  }
  return code;
}

// One path for all ways to write it, whether or not there is a file.
std::filesystem::path place_of(const std::string& path) {
  std::error_code error;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
}

// No output may be an input or another output.
void check_outputs(const CheckOptions& options) {
  if (options.meshes.size() > 1 && !(options.certificate.empty() && options.elements.empty())) {
    throw InputError(options.certificate.empty() ? options.elements : options.certificate, 0,
                     "is about one mesh, but there are " + std::to_string(options.meshes.size()) +
                         ": expected one MESH with --certificate or --elements");
  }
  const std::pair<const char*, const std::string*> outputs[] = {
      {"-o", &options.output}, {"--certificate", &options.certificate}, {"--elements", &options.elements}};
  for (const auto& [option, output] : outputs) {
    if (output->empty()) continue;
    std::error_code error;
    for (const std::string& input : options.meshes) {
      if (std::filesystem::equivalent(input, *output, error)) {
        throw InputError(*output, 0, std::string("is an input: expected another file for ") + option);
      }
    }
    for (const auto& [other_option, other] : outputs) {
      if (other == output) break;
      if (other->empty()) continue;
      const bool same = place_of(*other) == place_of(*output);
      if (same && std::filesystem::status(*output, error).type() != std::filesystem::file_type::character) {
        throw InputError(
            *output, 0,
            std::string("is given twice: expected different files for ") + other_option + " and " + option);
      }
    }
  }
}

}  // namespace

int check(const CheckOptions& options) {
  check_outputs(options);
  int code = exit_certified;
  const auto run = [&](std::ostream* certificate) {
    if (options.output.empty()) {
      code = check_all(options, std::cout, certificate);
    } else {
      write_file(options.output,
                 [&](std::ostream& stream) { code = check_all(options, stream, certificate); });
    }
  };
  if (options.certificate.empty()) {
    run(nullptr);
  } else {
    write_file(options.certificate, [&](std::ostream& stream) { run(&stream); });
  }
  return code;
}

}  // namespace bezcert::certify
