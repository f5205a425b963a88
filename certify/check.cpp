#include "check.hpp"

#include "bezcert/io/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "exit_code.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "workers.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

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

// Elements that one thread decides at a time.
constexpr std::size_t block_size = 256;

struct CheckedBlock {
  std::size_t first = 0;
  std::vector<CheckedElement> elements;
  std::string report;
};

CheckedBlock check_block(const Mesh& mesh, std::size_t begin, std::size_t end, const CheckOptions& options,
                         const Report& report) {
  CheckedBlock block{begin, check_elements(mesh, begin, end, options.criteria, options.budget), {}};
  block.report.reserve(block.elements.size() * 384);
  for (std::size_t i = begin; i < end; ++i) report.element(mesh, i, block.elements[i - begin], block.report);
  return block;
}

// Adds a block to the report and to what is known of the mesh; blocks come in mesh order.
void take_block(const std::string& input, const Mesh& mesh, const CheckedBlock& block, Summary& summary,
                std::vector<ElementState>& states, Report& report) {
  report.write(block.report);
  for (std::size_t k = 0; k < block.elements.size(); ++k) {
    const CheckedElement& checked = block.elements[k];
    summary.add(checked);
    states.push_back(state_of(checked.decision));
    if (std::any_of(checked.criteria.begin(), checked.criteria.end(),
                    [](const CheckedCriterion& one) { return one.is_defect(); })) {
      const std::size_t i = block.first + k;
      write_reproducer(input, mesh.elements[i], mesh.element(i), checked);
    }
  }
}

struct Input {
  Mesh mesh;
  std::string sha256;
};

Input read_input(const std::string& input, const ReadOptions& options, Workers& workers) {
  const std::string bytes = read_file(input);
  Input result;
  ReadOptions with_threads = options;
  if (workers.jobs() > 1) {
    with_threads.parallel = [&](std::size_t count, const std::function<void(std::size_t)>& work) {
      workers.each(count, work);
    };
  }
  workers.both([&] { result.mesh = read_mesh(input, bytes, with_threads); },
               [&] { result.sha256 = sha256(bytes); });
  return result;
}

Summary check_mesh(const std::string& input, const CheckOptions& options, std::span<const InputCurve> curves,
                   Workers& workers, Report& report) {
  const auto start = std::chrono::steady_clock::now();
  const auto [mesh, sha256] = read_input(input, options.read, workers);
  report.begin(input, sha256, mesh);

  Summary summary;
  summary.criteria = options.criteria;
  summary.by_criterion.resize(options.criteria.size());
  std::vector<ElementState> states;
  states.reserve(mesh.elements.size());
  std::optional<MeshTopology> topology;
  workers.both([&] { topology.emplace(mesh); },
               [&] {
                 Progress progress(input, mesh.elements.size());
                 workers.in_order(
                     mesh.elements.size(), block_size,
                     [&](std::size_t begin, std::size_t end) {
                       return check_block(mesh, begin, end, options, report);
                     },
                     [&](const CheckedBlock& block) {
                       take_block(input, mesh, block, summary, states, report);
                       progress.done(states.size());
                     });
               });
  summary.mesh = examine_mesh(std::move(*topology), states, {options.budget.contact, std::nullopt});
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

int check_all(const CheckOptions& options, std::ostream& stream) {
  const auto report = options.format == "jsonl" ? make_jsonl_report(stream) : make_text_report(stream);
  std::vector<InputCurve> curves;
  if (!options.domain.empty()) curves = read_bez_json_curves(options.domain, read_file(options.domain));
  Workers workers(options.jobs);
  int code = exit_certified;
  for (const std::string& input : options.meshes) {
    code = worse(code, exit_code_of(check_mesh(input, options, curves, workers, *report), options));
  }
  return code;
}

}  // namespace

int check(const CheckOptions& options) {
  if (options.output.empty()) return check_all(options, std::cout);
  for (const std::string& input : options.meshes) {
    std::error_code error;
    if (std::filesystem::equivalent(input, options.output, error)) {
      throw InputError(options.output, 0, "is an input: expected another file for -o");
    }
  }
  int code = exit_certified;
  write_file(options.output, [&](std::ostream& stream) { code = check_all(options, stream); });
  return code;
}

}  // namespace bezcert::certify
