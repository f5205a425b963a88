#include "check.hpp"

#include "bezcert/io/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/mesh/mesh_decider.hpp"
#include "exit_code.hpp"
#include "progress.hpp"
#include "report.hpp"

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

Summary check_mesh(const std::string& input, const CheckOptions& options, std::span<const InputCurve> curves,
                   Report& report) {
  const auto start = std::chrono::steady_clock::now();
  const std::string bytes = read_file(input);
  const Mesh mesh = read_mesh(input, bytes, options.read);
  report.begin(input, sha256(bytes), mesh);

  Summary summary;
  summary.criteria = options.criteria;
  summary.by_criterion.resize(options.criteria.size());
  std::vector<ElementState> states;
  states.reserve(mesh.elements.size());
  Progress progress(input, mesh.elements.size());
  const MeshDecider decider(mesh, options.budget, options.filter);
  decider.decide_range(0, mesh.elements.size(), [&](std::size_t i, const Decision& decision) {
    const Element element = mesh.element(i);
    const CheckedElement checked = check_decided(decision, Forms(element, options.filter), options.criteria);
    summary.add(checked);
    states.push_back(state_of(checked.decision));
    report.element(mesh, i, element, checked);
    if (std::any_of(checked.criteria.begin(), checked.criteria.end(),
                    [](const CheckedCriterion& one) { return one.is_defect(); })) {
      write_reproducer(input, mesh.elements[i], element, checked);
    }
    progress.done(i + 1);
  });
  summary.mesh = examine_mesh(mesh, states, {options.budget.contact, std::nullopt});
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
  int code = exit_certified;
  for (const std::string& input : options.meshes) {
    code = worse(code, exit_code_of(check_mesh(input, options, curves, *report), options));
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
