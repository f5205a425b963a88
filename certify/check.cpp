#include "check.hpp"

#include "bezcert/certificate/certificate.hpp"
#include "bezcert/io/curve/bez_json.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/mesh/mesh_decider.hpp"
#include "exit_code.hpp"
#include "memory.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "workers.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>

namespace bezcert::certify {
namespace {

// A sound criterion contradicts the decision: keep the element, so that the defect can be found.
void write_reproducer(const std::string& input, std::uint64_t number, const Element& element,
                      const CheckedElement& checked) {
  std::string what;
  for (const CheckedCriterion& one : checked.criteria) {
    if (one.is_defect())
      what += std::string(one.criterion->name) + " says " + std::string(name(one.verdict.status)) + "; ";
  }
  const std::string stem = std::filesystem::path(input).filename().string();
  const std::string path = "bezcert-contradiction-" + stem + "-" + std::to_string(number) + ".bez.json";
  write_file(path, [&](std::ostream& stream) {
    write_bez_json(stream, element, "element " + std::to_string(number),
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

// Elements that one thread decides at a time.
constexpr std::size_t block_size = 256;

// What is known of a block. Its memory is used again for another block: threads that ask for memory at every
// element wait for each other.
struct CheckedBlock {
  std::string report;
  ElementCounts counts;
  std::vector<ElementClaim> claims;                             // if a certificate is asked for
  std::vector<std::pair<std::size_t, CheckedElement>> defects;  // sound criteria contradict these
};

// Any number of blocks at a time: each has its own elements of `states`.
void check_block(const Mesh& mesh, std::size_t begin, std::size_t end, const CheckOptions& options,
                 const Report& report, std::vector<ElementState>& states, CheckedBlock& block) {
  block.report.clear();
  block.counts.clear(options.criteria.size());
  block.claims.clear();
  block.defects.clear();
  const auto take = [&](std::size_t i, const CheckedElement& checked) {
    report.element(mesh, i, checked, block.report);
    block.counts.add(checked);
    states[i] = state_of(checked.decision);
    if (!options.certificate.empty()) block.claims.push_back(claim_of(mesh, i, checked.decision));
    const bool is_defect = std::any_of(checked.criteria.begin(), checked.criteria.end(),
                                       [](const CheckedCriterion& one) { return one.is_defect(); });
    if (is_defect) block.defects.emplace_back(i, checked);
  };
  check_elements(mesh, begin, end, options.criteria, options.budget, options.filter, take);
}

// Adds a block to the report and to what is known of the mesh; blocks come in mesh order.
void take_block(const std::string& input, const Mesh& mesh, const CheckedBlock& block, Summary& summary,
                Report& report, std::optional<CertificateWriter>& proof) {
  report.write(block.report);
  for (const ElementClaim& claim : block.claims) proof->element(claim);
  summary.add(block.counts);
  for (const auto& [i, checked] : block.defects) {
    write_reproducer(input, mesh.origin().number(i), mesh.element(i), checked);
  }
}

struct Input {
  std::optional<Mesh> mesh;
  std::string sha256;
  bool is_json = false;
};

Input read_input(const std::string& input, const ReadOptions& options, Workers& workers) {
  const FileBytes file(input);
  const std::string_view bytes = file.view();
  expect_memory(bytes.size() * 3 / 2);
  Input result;
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  result.is_json = begin != bytes.npos && bytes[begin] == '{';
  ReadOptions with_threads = options;
  with_threads.parallel = workers.parallel();
  workers.at_once([&] { result.mesh = read_mesh(input, bytes, with_threads); },
                  [&] { result.sha256 = sha256(bytes); });
  file.check_unchanged();
  return result;
}

// What a certificate says of its elements file: the input itself if `verifier` reads it, or the file written
// for it.
CertificateHeader header_of(const std::string& name, const Input& input, const CheckOptions& options) {
  const Mesh& mesh = *input.mesh;
  CertificateHeader header{input.sha256, mesh.origin().basis_name, mesh.origin().numbers,
                           mesh.elements().size()};
  if (!options.elements.empty()) header.elements_sha256 = sha256(read_file(options.elements));
  if (!options.elements.empty() || input.is_json) {
    header.basis = "mixed";
    header.numbers = Numbers::decimal;
  } else if (mesh.origin().line(0) == 0) {
    throw InputError(name, 0,
                     "is binary, which verifier does not read: expected --elements=FILE beside --certificate "
                     "(the mesh as exact .bez.json), or an ASCII .msh");
  }
  return header;
}

Summary check_mesh(const std::string& input, const CheckOptions& options, std::span<const InputCurve> curves,
                   Workers& workers, Report& report, std::ostream* certificate) {
  const auto start = std::chrono::steady_clock::now();
  const Input read = read_input(input, options.read, workers);
  const Mesh& mesh = *read.mesh;
  if (!options.elements.empty()) {
    write_file(options.elements, [&](std::ostream& stream) { write_bez_json(stream, mesh); });
  }
  std::optional<CertificateWriter> proof;
  if (certificate != nullptr) proof.emplace(*certificate, header_of(input, read, options));
  report.begin(input, read.sha256, mesh);

  Summary summary;
  summary.criteria = options.criteria;
  summary.clear(options.criteria.size());
  std::vector<ElementState> states(mesh.elements().size());
  std::optional<MeshTopology> topology;
  workers.both([&] { topology.emplace(mesh); },
               [&] {
                 Progress progress(input, mesh.elements().size());
                 workers.in_order<CheckedBlock>(
                     mesh.elements().size(), block_size,
                     [&](std::size_t begin, std::size_t end, CheckedBlock& block) {
                       check_block(mesh, begin, end, options, report, states, block);
                     },
                     [&](const CheckedBlock& block) {
                       take_block(input, mesh, block, summary, report, proof);
                       progress.done(summary.elements);
                     });
               });
  summary.mesh = examine_mesh(std::move(*topology), states, {options.budget.contact, std::nullopt});
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
  Workers workers(options.jobs);
  int code = exit_certified;
  for (const std::string& input : options.meshes) {
    code =
        worse(code, exit_code_of(check_mesh(input, options, curves, workers, *report, certificate), options));
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
